#include "tools/picture/scan/diagram_lines.h"

#include "tools/picture/canvas/csv.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

namespace fs = std::filesystem;

constexpr Colour magenta{200, 0, 160};

Colour fold_colour(const std::string& branch) {
  if (branch == "prolate") return {205, 95, 0};
  return branch == "stomatocyte" ? Colour{0, 120, 70} : red;
}

constexpr double line_width = 2.6, border = 2.0;
constexpr double farthest = 2.0;  // ratio of L between neighbours on one line of folds

std::optional<CsvTable> table_if_there(const fs::path& file) {
  if (!fs::exists(file)) return {};
  return CsvTable(file);
}

void add_folds(const CsvTable& table, const std::string& branch, std::vector<DiagramLine>& lines) {
  const std::size_t names = table.column("branch");
  const auto volumes = table.numbers("reduced_volume"), L = table.numbers("L");
  std::map<std::string, std::vector<Points>> by_branch;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& pieces = by_branch[table.text(row, names)];
    // Another fold, such as where the order melts at large L, is no continuation.
    const double before = pieces.empty() ? 0.0 : pieces.back().back()[1];
    if (L[row] > farthest * before || before > farthest * L[row]) pieces.emplace_back();
    pieces.back().push_back({volumes[row], L[row]});
  }
  for (const auto& [name, pieces] : by_branch)
    if (branch.empty() || branch == name)
      for (const Points& points : pieces)
        lines.push_back(
            {"fold, " + name, {.colour = fold_colour(name), .width = line_width}, points});
}

// At one L two branches may meet more than once: the k-th meetings make the k-th line.
void add_equal_energies(const CsvTable& table, const std::string& branch,
                        std::vector<DiagramLine>& lines) {
  const std::size_t firsts = table.column("first"), seconds = table.column("second");
  const auto volumes = table.numbers("reduced_volume"), L = table.numbers("L");
  std::map<std::pair<std::string, std::size_t>, Points> meetings;
  std::map<std::pair<std::string, double>, std::size_t> counts;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string first = table.text(row, firsts), second = table.text(row, seconds);
    if (!branch.empty() && branch != first && branch != second) continue;
    const std::string pair = first + " = " + second;
    const std::size_t k = counts[{pair, L[row]}]++;
    meetings[{pair, k}].push_back({volumes[row], L[row]});
  }
  std::vector<std::string> pairs;
  for (const auto& [key, points] : meetings) {
    if (std::ranges::find(pairs, key.first) == pairs.end()) pairs.push_back(key.first);
    const bool dashed = pairs.size() > 1;
    lines.push_back({"equal energy, " + key.first,
                     {.colour = black, .width = line_width, .dashed = dashed},
                     points});
  }
}

void add_sharp_rims(const CsvTable& table, std::vector<DiagramLine>& lines) {
  const std::size_t kinds = table.column("kind");
  const auto volumes = table.numbers("reduced_volume"), L = table.numbers("L");
  const std::array<std::pair<const char*, const char*>, 2> wanted{
      {{"equal_energy", "equal energy, smooth = sharp rim"}, {"second_fold", "end of sharp rims"}}};
  for (const auto& [kind, name] : wanted) {
    Points points;
    for (std::size_t row = 0; row < table.rows(); ++row)
      if (table.text(row, kinds) == kind) points.push_back({volumes[row], L[row]});
    lines.push_back(
        {name,
         {.colour = magenta, .width = line_width, .dashed = std::string(kind) == "second_fold"},
         points});
  }
}

// The part of a segment inside, by Liang and Barsky; empty when there is none.
using Point = Points::value_type;
std::optional<std::pair<Point, Point>> clipped(const Point& from, const Point& to,
                                               const Rect& inside) {
  double begin = 0, end = 1;
  const auto limit = [&](double start, double change, double low, double high) {
    if (change == 0) return start >= low && start <= high;
    double enter = (low - start) / change, leave = (high - start) / change;
    if (enter > leave) std::swap(enter, leave);
    begin = std::max(begin, enter);
    end = std::min(end, leave);
    return begin < end;
  };
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  if (!limit(from[0], dx, inside.x, inside.right()) || !limit(from[1], dy, inside.y, inside.top()))
    return {};
  return std::pair(Point{from[0] + begin * dx, from[1] + begin * dy},
                   Point{from[0] + end * dx, from[1] + end * dy});
}

std::vector<Points> clipped(const Points& line, const Rect& inside) {
  std::vector<Points> pieces;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto piece = clipped(line[i - 1], line[i], inside);
    if (!piece) continue;
    if (pieces.empty() || pieces.back().back() != piece->first) pieces.push_back({piece->first});
    pieces.back().push_back(piece->second);
  }
  return pieces;
}

}  // namespace

std::vector<DiagramLine> diagram_lines(const fs::path& directory, const std::string& branch) {
  std::vector<DiagramLine> lines;
  if (const auto folds = table_if_there(directory / "folds.csv")) add_folds(*folds, branch, lines);
  if (const auto meetings = table_if_there(directory / "equal_energy.csv"))
    add_equal_energies(*meetings, branch, lines);
  if (const auto states = table_if_there(directory / "beyond_fold.csv");
      states && (branch.empty() || branch == "oblate"))
    add_sharp_rims(*states, lines);
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
