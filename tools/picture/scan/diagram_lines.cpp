#include "tools/picture/scan/diagram_lines.h"

#include "studies/scan/beyond_fold.h"
#include "studies/scan/branch_lines.h"
#include "studies/scan/stability_lines.h"
#include "tools/picture/scan/chains.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace sbeh::picture {
namespace {

namespace fs = std::filesystem;

constexpr Colour magenta{200, 0, 160};

constexpr double line_width = 2.6, border = 2.0;

// Told apart without colours too.
LineStyle fold_style(axisym::Branch branch, bool whole) {
  switch (branch) {
    case axisym::Branch::oblate:
      return {red, line_width, whole ? Pattern::dashed : Pattern::solid};
    case axisym::Branch::prolate:
      return {{0, 70, 190}, line_width, whole ? Pattern::dashed : Pattern::dash_dotted};
    case axisym::Branch::stomatocyte:
      return {{0, 110, 80}, line_width, whole ? Pattern::dashed : Pattern::dotted};
    case axisym::Branch::pear:
      return {{150, 90, 0}, line_width, whole ? Pattern::dashed : Pattern::dash_dotted};
  }
  return {};
}

constexpr double farthest = 2.0;  // ratio of L between neighbours on one line of folds

// Where the order melts on the whole surface, say, is no continuation of where a rim loses it.
bool goes_on(const studies::FoldRow& before, const studies::FoldRow& fold) {
  return before.branch == fold.branch && before.kind == fold.kind && fold.L <= farthest * before.L
      && before.L <= farthest * fold.L;
}

void add_folds(const std::vector<studies::FoldRow>& folds, const std::string& branch,
               std::vector<DiagramLine>& lines) {
  const studies::FoldRow* before = nullptr;
  for (const studies::FoldRow& fold : folds) {
    if (!branch.empty() && branch != name(fold.branch)) continue;
    if (!before || !goes_on(*before, fold)) {
      const std::string kind = fold.kind ? fmt::format(" ({})", name(*fold.kind)) : "";
      lines.push_back({fmt::format("fold, {}{}", name(fold.branch), kind),
                       fold_style(fold.branch, fold.kind == axisym::FoldKind::whole),
                       {}});
    }
    before = &fold;
    lines.back().points.push_back({fold.reduced_volume, fold.L});
  }
}

// At one L two branches may meet more than once: the k-th meetings make the k-th line.
void add_equal_energies(const std::vector<studies::EqualEnergyRow>& rows, const std::string& branch,
                        std::vector<DiagramLine>& lines) {
  std::map<std::pair<std::string, std::size_t>, Points> meetings;
  std::map<std::pair<std::string, double>, std::size_t> counts;
  for (const auto& [first, second, L, volume, energy] : rows) {
    if (!branch.empty() && branch != name(first) && branch != name(second)) continue;
    const std::string pair = fmt::format("{} = {}", name(first), name(second));
    const std::size_t k = counts[{pair, L}]++;
    meetings[{pair, k}].push_back({volume, L});
  }
  std::vector<std::string> pairs;
  for (const auto& [key, points] : meetings) {
    if (std::ranges::find(pairs, key.first) == pairs.end()) pairs.push_back(key.first);
    constexpr Pattern patterns[] = {Pattern::solid, Pattern::dashed, Pattern::dash_dotted};
    lines.push_back({"equal energy, " + key.first,
                     {.colour = black,
                      .width = line_width,
                      .pattern = patterns[(pairs.size() - 1) % std::size(patterns)]},
                     points});
  }
}

void add_sharp_rims(const std::vector<studies::RimRow>& states, std::vector<DiagramLine>& lines) {
  using axisym::RimKind;
  constexpr std::array<std::pair<RimKind, const char*>, 2> wanted{
      {{RimKind::equal_energy, "equal energy, smooth = sharp rim"},
       {RimKind::second_fold, "end of sharp rims"}}};
  for (const auto& [kind, name] : wanted) {
    Points points;
    for (const studies::RimRow& state : states)
      if (state.kind == kind) points.push_back({state.reduced_volume, state.L});
    lines.push_back(
        {name,
         {.colour = magenta,
          .width = line_width,
          .pattern = kind == RimKind::second_fold ? Pattern::dashed : Pattern::dash_dotted},
         points});
  }
}

// Told apart by their labels.
LineStyle stability_style(axisym::Branch branch) {
  switch (branch) {
    case axisym::Branch::oblate:
      return {{110, 40, 170}, line_width, Pattern::dotted};
    case axisym::Branch::prolate:
      return {{0, 120, 150}, line_width, Pattern::dotted};
    case axisym::Branch::stomatocyte:
      return {{90, 110, 0}, line_width, Pattern::dotted};
    case axisym::Branch::pear:
      return {{150, 60, 60}, line_width, Pattern::dotted};
  }
  return {};
}

// Of the values of a grid, the whole numbers being those.
double place_in(const std::vector<double>& grid, double value) {
  if (grid.size() < 2) return 0.0;
  const auto above = std::ranges::upper_bound(grid, value);
  const std::size_t i =
      std::clamp<std::size_t>(std::size_t(above - grid.begin()), 1, grid.size() - 1);
  return double(i) - (grid[i] - value) / (grid[i] - grid[i - 1]);
}

// A crossing of which is not known to which others it belongs.
void draw_point(Canvas& canvas, const std::array<double, 2>& at, const LineStyle& style) {
  const auto square = [&](double side, Colour colour) {
    const double half = 0.5 * side * canvas.unit();
    canvas.line({{at[0] - half, at[1]}, {at[0] + half, at[1]}}, {.colour = colour, .width = side});
  };
  square(3.0 * style.width + border, white);
  square(3.0 * style.width, style.colour);
}

struct PlacedLabel {
  std::string text;
  Rect rect;
};

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.top() && b.y < a.top();
}

// A place on a line, and its direction there.
struct Place {
  std::array<double, 2> at;
  double dx, dy;
};

// Beside the place, on white, to the right if there is room; false where there is none for it. Beside one that says the
// same it is not needed.
bool draw_label(Canvas& canvas, const Rect& inside, const Place& place, const DiagramLine& line,
                double text_size, std::vector<PlacedLabel>& placed) {
  const double size = 0.75 * text_size, width = canvas.text_width(line.label, size) + 0.4 * size,
               height = 1.1 * size, length = std::hypot(place.dx, place.dy);
  const double side = place.dy < 0.0 ? -1.0 : 1.0, nx = side * place.dy / length,
               ny = -side * place.dx / length;
  const double away = 0.5 * (width * std::abs(nx) + height * std::abs(ny)) + 0.3 * size;
  for (const double sign : {1.0, -1.0}) {
    const double x = place.at[0] + sign * away * nx, y = place.at[1] + sign * away * ny;
    const Rect rect{x - 0.5 * width, y - 0.5 * height, width, height};
    if (std::ranges::any_of(placed, [&](const PlacedLabel& label) {
          return label.text == line.label && std::abs(label.rect.x - rect.x) < 2.0 * width
              && std::abs(label.rect.y - rect.y) < 2.0 * height;
        }))
      return true;
    if (rect.x < inside.x || rect.right() > inside.right()
        || std::ranges::any_of(placed, [&](const auto& l) { return overlap(l.rect, rect); }))
      continue;
    placed.push_back({line.label, rect});
    canvas.fill(rect, white);
    canvas.text(x, y, line.label, {.size = size, .colour = line.style.colour});
    return true;
  }
  return false;
}

bool within(const Rect& inside, const std::array<double, 2>& at) {
  return at[0] >= inside.x && at[0] <= inside.right() && at[1] >= inside.y && at[1] <= inside.top();
}

// Of every piece of a line, at another share of its length for each, so that those of lines side by side are apart;
// then of single points.
void draw_labels(Canvas& canvas, const Rect& inside,
                 const std::vector<std::pair<const DiagramLine*, Points>>& pieces,
                 double text_size) {
  std::vector<PlacedLabel> placed;
  double share = 0.0;
  for (const auto& [line, piece] : pieces) {
    share = std::fmod(share + 0.3, 0.9);
    if (line->label.empty() || piece.size() < 2) continue;
    for (const double further : {0.0, 0.3, 0.6}) {
      const auto k = std::size_t(std::fmod(share + further, 0.9) * double(piece.size() - 1));
      const Place place{piece[k], piece[k + 1][0] - piece[k][0], piece[k + 1][1] - piece[k][1]};
      if (draw_label(canvas, inside, place, *line, text_size, placed)) break;
    }
  }
  for (const auto& [line, piece] : pieces) {
    if (line->label.empty() || piece.size() != 1) continue;
    for (const Place& place : {Place{piece[0], 0.0, 1.0}, Place{piece[0], 1.0, 0.0}})
      if (draw_label(canvas, inside, place, *line, text_size, placed)) break;
  }
}

}  // namespace

std::vector<DiagramLine> diagram_lines(const ScanGrid& scan, const std::string& branch) {
  std::vector<DiagramLine> lines;
  if (scan.over_L()) add_folds(scan.rows(studies::fold_columns(), "folds.csv"), branch, lines);
  add_equal_energies(scan.rows(studies::equal_energy_columns(), "equal_energy.csv"), branch, lines);
  if (scan.over_L() && (branch.empty() || branch == "oblate"))
    add_sharp_rims(scan.rows(studies::rim_columns(), "beyond_fold.csv"), lines);
  std::erase_if(lines, [](const DiagramLine& line) { return line.points.size() < 2; });
  return lines;
}

std::vector<DiagramLine> stability_lines(const ScanGrid& scan, Model model,
                                         const std::string& branch) {
  using Row = studies::StabilityLineRow;
  std::map<std::tuple<axisym::Branch, int, axisym::Parity>, std::vector<Row>> found;
  for (const Row& row : scan.rows(studies::stability_line_columns(), "stability_lines.csv"))
    if (row.model == model && row.reason.empty() && (branch.empty() || branch == name(row.branch)))
      found[{row.branch, row.m, row.parity}].push_back(row);
  std::vector<DiagramLine> lines;
  for (const auto& [kind, rows] : found) {
    const auto& [of, m, parity] = kind;
    Points places;
    for (const Row& row : rows)
      places.push_back(
          {place_in(scan.reduced_volumes(), row.reduced_volume), place_in(scan.lengths(), row.L)});
    for (const std::vector<std::size_t>& chain : chains(places)) {
      DiagramLine& line = lines.emplace_back();
      line.name = fmt::format("limit of stability, {}", name(of));
      line.style = stability_style(of);
      line.label = fmt::format("m = {}", m);
      for (const std::size_t k : chain) line.points.push_back({rows[k].reduced_volume, rows[k].L});
    }
  }
  return lines;
}

void draw_diagram_lines(Canvas& canvas, const Rect& inside, const std::vector<DiagramLine>& lines,
                        const HeatMapGrid& grid, double text_size) {
  std::vector<std::pair<const DiagramLine*, Points>> pieces;
  for (const DiagramLine& line : lines) {
    Points pixels;
    for (const auto& [volume, L] : line.points)
      pixels.push_back({inside.x + share_of(grid.x, volume) * inside.width,
                        inside.y + share_of(grid.y, L) * inside.height});
    if (pixels.size() == 1 && within(inside, pixels.front())) {
      draw_point(canvas, pixels.front(), line.style);
      pieces.emplace_back(&line, pixels);
    }
    for (const Points& piece : clipped(pixels, inside)) {
      canvas.line(piece, {.colour = white, .width = line.style.width + border});
      canvas.line(piece, line.style);
      pieces.emplace_back(&line, piece);
    }
  }
  draw_labels(canvas, inside, pieces, text_size);
}

std::vector<LegendEntry> legend_of(const std::vector<DiagramLine>& lines) {
  std::vector<LegendEntry> entries;
  for (const DiagramLine& line : lines)
    if (std::ranges::none_of(entries, [&](const LegendEntry& e) { return e.text == line.name; }))
      entries.push_back(line_entry(line.style, line.name));
  return entries;
}

}  // namespace sbeh::picture
