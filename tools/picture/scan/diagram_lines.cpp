#include "tools/picture/scan/diagram_lines.h"

#include "studies/scan/branch_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
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
  }
  return {};
}

constexpr double farthest = 2.0;  // ratio of L between neighbours on one line of folds

template <class Row>
std::vector<Row> rows_if_there(const studies::Columns<Row>& columns, const fs::path& file) {
  return fs::exists(file) ? studies::read_rows(columns, file) : std::vector<Row>{};
}

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

void add_sharp_rims(const std::vector<axisym::RimRecord>& states, std::vector<DiagramLine>& lines) {
  using axisym::RimKind;
  constexpr std::array<std::pair<RimKind, const char*>, 2> wanted{
      {{RimKind::equal_energy, "equal energy, smooth = sharp rim"},
       {RimKind::second_fold, "end of sharp rims"}}};
  for (const auto& [kind, name] : wanted) {
    Points points;
    for (const axisym::RimRecord& state : states)
      if (state.kind == kind) points.push_back({state.reduced_volume, state.L});
    lines.push_back(
        {name,
         {.colour = magenta,
          .width = line_width,
          .pattern = kind == RimKind::second_fold ? Pattern::dashed : Pattern::dash_dotted},
         points});
  }
}

}  // namespace

std::vector<DiagramLine> diagram_lines(const fs::path& directory, const std::string& branch) {
  std::vector<DiagramLine> lines;
  add_folds(rows_if_there(studies::fold_columns(), directory / "folds.csv"), branch, lines);
  add_equal_energies(rows_if_there(studies::equal_energy_columns(), directory / "equal_energy.csv"),
                     branch, lines);
  if (branch.empty() || branch == "oblate")
    add_sharp_rims(rows_if_there(studies::rim_columns(), directory / "beyond_fold.csv"), lines);
  std::erase_if(lines, [](const DiagramLine& line) { return line.points.size() < 2; });
  return lines;
}

void draw_diagram_lines(Canvas& canvas, const Rect& inside, const std::vector<DiagramLine>& lines,
                        const HeatMapGrid& grid) {
  for (const DiagramLine& line : lines) {
    Points pixels;
    for (const auto& [volume, L] : line.points)
      pixels.push_back({inside.x + share_of(grid.x, volume) * inside.width,
                        inside.y + share_of(grid.y, L) * inside.height});
    for (const Points& piece : clipped(pixels, inside)) {
      canvas.line(piece, {.colour = white, .width = line.style.width + border});
      canvas.line(piece, line.style);
    }
  }
}

std::vector<LegendEntry> legend_of(const std::vector<DiagramLine>& lines) {
  std::vector<LegendEntry> entries;
  for (const DiagramLine& line : lines)
    if (std::ranges::none_of(entries, [&](const LegendEntry& e) { return e.text == line.name; }))
      entries.push_back(line_entry(line.style, line.name));
  return entries;
}

}  // namespace sbeh::picture
