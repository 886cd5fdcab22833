#include "studies/seifert/seifert.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/studies/studies.h"

#include <algorithm>
#include <map>

namespace sbeh::picture {
namespace {

using axisym::Branch;

struct BranchCurve {
  Branch branch;
  LineStyle style;
};
const std::vector<BranchCurve> branch_curves{
    {Branch::oblate, {.colour = {0, 84, 159}, .width = 2.6}},
    {Branch::prolate, {.colour = {213, 94, 0}, .width = 2.6}},
    {Branch::stomatocyte, {.colour = {0, 158, 115}, .width = 2.6}},
};

// Points (V_r, F/8πκ) by witness and branch, V_r ascending; witnesses in the order of the file.
struct Branches {
  std::vector<std::string> witnesses;
  std::map<std::pair<std::string, Branch>, Points> points;
};

Branches read_branches(const std::filesystem::path& file) {
  Branches all;
  for (const auto& [witness, shape] : studies::read_rows(studies::branch_columns(), file)) {
    if (std::ranges::find(all.witnesses, witness) == all.witnesses.end())
      all.witnesses.push_back(witness);
    all.points[{witness, shape.branch}].push_back({shape.reduced_volume, shape.energy});
  }
  for (auto& [key, points] : all.points) std::ranges::sort(points);
  if (all.points.empty())
    throw InputError(file.string() + " has no rows; run `sbeh seifert` again.");
  return all;
}

Points special_points(const std::filesystem::path& file) {
  Points points;
  for (const studies::PointRow& row : studies::read_rows(studies::point_columns(), file))
    points.push_back({row.point.reduced_volume, row.point.energy});
  return points;
}

}  // namespace

void draw_classical_diagram(Canvas& canvas, const Options& options) {
  const Branches all = read_branches(options.directory / "branches.csv");
  const Points special = special_points(options.directory / "points.csv");
  const double text = options.text_size();
  std::vector<LegendEntry> legend;
  for (const BranchCurve& branch : branch_curves)
    legend.push_back(line_entry(branch.style, sbeh::name(branch.branch)));
  std::string others;
  for (std::size_t i = 1; i < all.witnesses.size(); ++i)
    others += (i > 1 ? ", " : "") + all.witnesses[i];
  if (!others.empty()) legend.push_back(marker_entry(Marker::hollow, dark_grey, others));
  legend.push_back(marker_entry(Marker::full, black, "special points"));

  const double width = options.width(1100.0), height = options.height(800.0);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = below_axis(text) + 0.8 * text + legend_at;
  const Rect inside{5.2 * text, below, width - 6.8 * text, height - below - 1.6 * text};
  Range volumes, energies;
  for (const auto& [key, points] : all.points)
    for (const auto& [volume, energy] : points) {
      volumes.include(volume);
      energies.include(energy);
    }
  const Axis x =
      linear_axis(volumes.low, volumes.high, inside.width, 4.0 * text, "reduced volume Vᵣ");
  const Axis y = linear_axis(energies.low, energies.high, inside.height, 3.2 * text, "F / 8πκ");

  canvas.start(width, height, options.unit());
  Chart chart(canvas, inside, text, x, y);
  for (const BranchCurve& branch : branch_curves)
    for (std::size_t i = 0; i < all.witnesses.size(); ++i) {
      const auto at = all.points.find({all.witnesses[i], branch.branch});
      if (at == all.points.end()) continue;
      if (i == 0)
        chart.curve(at->second, branch.style);
      else
        chart.markers(at->second, Marker::hollow, branch.style.colour, 0.45 * text);
    }
  chart.markers(special, Marker::full, black, 0.6 * text);
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "branches", options.output());
}

}  // namespace sbeh::picture
