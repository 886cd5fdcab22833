#include "studies/diagram/diagram_table.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/section/cut.h"
#include "tools/picture/studies/studies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace sbeh::picture {
namespace {

using studies::Bifurcation;

// What is one line of the picture, at one value after the other.
struct LineKey {
  std::string kind, branch, from;
  int leg;
  auto operator<=>(const LineKey&) const = default;  // NOLINT(modernize-use-nullptr): false alarm
};
using PointsByLine = std::map<LineKey, Points>;

// Where a curve would be at this value, going on as it came.
double expected(const Points& curve, double value) {
  const auto& end = curve.back();
  if (curve.size() < 2) return end[0];
  const auto& before = curve[curve.size() - 2];
  return end[0] + (value - end[1]) * (end[0] - before[0]) / (end[1] - before[1]);
}

// Neighbouring values are joined where V_r differs from what is expected by less than `reach`: the nearest, each once.
std::vector<Points> joined(const Points& points, double step, double reach) {
  std::vector<Points> curves;
  for (const auto& point : points) {  // by ascending value
    Points* nearest = nullptr;
    double least = reach;
    for (Points& curve : curves) {
      const auto& end = curve.back();
      const double rise = point[1] - end[1];
      if (rise > 1e-9 && rise < 1.5 * step
          && std::abs(point[0] - expected(curve, point[1])) < least) {
        least = std::abs(point[0] - expected(curve, point[1]));
        nearest = &curve;
      }
    }
    if (nearest)
      nearest->push_back(point);
    else
      curves.push_back({point});
  }
  return curves;
}

Colour colour_of(std::string_view branch) {
  if (branch.starts_with("oblate")) return {0, 84, 159};
  if (branch.starts_with("prolate")) return {213, 94, 0};
  if (branch.starts_with("pear")) return {148, 52, 148};
  return {0, 158, 115};
}

LineStyle style_of(const LineKey& line) {
  LineStyle style{.colour = colour_of(line.branch), .width = 2.0};
  if (line.kind == "fold") style.pattern = Pattern::dashed;
  if (line.kind == "limit") style.pattern = Pattern::dotted;
  if (line.kind == "equal_energy") style = {.colour = black, .width = 3.0};
  if (line.kind.starts_with("mode")) {
    style.width = 1.0;
    style.pattern = Pattern::dash_dotted;
  }
  return style;
}

const char* title_of(studies::DiagramKind kind) {
  switch (kind) {
    case studies::DiagramKind::spontaneous_curvature:
      return "spontaneous curvature c₀ = −H₀";
    case studies::DiagramKind::bilayer_coupling:
      return "area difference Δa = −W₂/8π";
    default:
      return "preferred area difference Δa₀";
  }
}

std::vector<LegendEntry> legend_of(const PointsByLine& lines) {
  std::vector<LegendEntry> entries;
  const auto any = [&](const auto& is) {
    return std::ranges::any_of(lines, [&](const auto& line) { return is(line.first); });
  };
  for (const char* branch : {"oblate", "prolate", "stomatocyte", "pear"})
    if (any([&](const LineKey& l) { return l.branch.starts_with(branch); }))
      entries.push_back(line_entry({.colour = colour_of(branch), .width = 2.6}, branch));
  struct Meaning {
    const char *kind, *text;
  };
  for (const auto& [kind, text] :
       {Meaning{"symmetry_loss", "loses its symmetry to it"}, Meaning{"fold", "fold"},
        Meaning{"limit", "necks close"}, Meaning{"mode", "mode changes sign"}})
    if (any([&, k = kind](const LineKey& l) { return l.kind.starts_with(k); })) {
      LineStyle style = style_of({kind, "", "", 0});
      style.colour = dark_grey;
      entries.push_back(line_entry(style, text));
    }
  if (any([](const LineKey& l) { return l.kind == "equal_energy"; }))
    entries.push_back(line_entry(style_of({"equal_energy", "", "", 0}), "equal energy"));
  return entries;
}

// Of shapes.csv: the lowest minima, where they stand.
struct PlacedShape {
  std::array<double, 2> at;
  Colour colour;
  Cut cut;
};
std::vector<PlacedShape> placed_shapes(const std::filesystem::path& file) {
  std::vector<PlacedShape> shapes;
  if (!std::filesystem::exists(file)) return shapes;
  std::map<int, std::pair<studies::DiagramShapeRow, Points>> all;
  for (const auto& row : studies::read_rows(studies::diagram_shape_columns(), file)) {
    auto& [first, points] = all.try_emplace(row.number, row, Points{}).first->second;
    points.push_back({row.r, row.z});
  }
  for (const auto& [number, shape] : all) {
    const auto& [row, points] = shape;
    Eigen::Matrix2Xd profile(2, Eigen::Index(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      profile.col(Eigen::Index(i)) << points[i][0], points[i][1];
    shapes.push_back({{row.reduced_volume, row.value},
                      colour_of(row.branch),
                      mirrored({profile, axisym::Field::Zero(profile.cols())})});
  }
  return shapes;
}

}  // namespace

void draw_phase_diagram(Canvas& canvas, const Options& options) {
  const studies::DiagramInput input = studies::read_diagram(options.directory / "run.toml");
  PointsByLine lines;
  for (const Bifurcation& row :
       studies::read_rows(studies::bifurcation_columns(), options.directory / "bifurcations.csv"))
    lines[{row.kind, row.branch, row.from, row.leg}].push_back(
        {row.at.reduced_volume, row.at.value});
  const double text = options.text_size(), width = options.width(1100.0);
  const auto legend = legend_of(lines);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = below_axis(text) + 0.8 * text + legend_at;
  const double height = options.height(0.8 * width + below);
  const Rect inside{5.2 * text, below, width - 6.8 * text, height - below - 1.6 * text};
  require_room(inside, 12.0 * text, 10.0 * text);
  const double low = input.values.front(), high = input.values.back(),
               margin = std::max(0.02 * (high - low), 1e-3);
  const Axis x = exact_axis(input.least_volume, 1.0, inside.width, 4.0 * text, "reduced volume Vᵣ"),
             y = exact_axis(low - margin, high + margin, inside.height, 3.2 * text,
                            title_of(input.kind));
  double step = 0.0;  // the widest of the values
  for (std::size_t k = 1; k < input.values.size(); ++k)
    step = std::max(step, input.values[k] - input.values[k - 1]);

  canvas.start(width, height, options.unit());
  Chart chart(canvas, inside, text, x, y);
  for (auto& [key, points] : lines) {
    std::ranges::stable_sort(points, {}, [](const auto& p) { return p[1]; });
    const LineStyle style = style_of(key);
    const double reach =
        key.kind == "limit" ? 0.03 : 0.08;  // limits of other spheres are other lines
    for (const Points& curve : joined(points, step, reach)) {
      if (curve.size() > 1)
        chart.curve(curve, style);
      else
        chart.markers(curve, Marker::full, style.colour, 0.25 * text);
    }
  }
  for (const PlacedShape& shape : placed_shapes(options.directory / "shapes.csv")) {
    const double side = 3.0 * text,
                 scale = std::min(0.55 * text, 0.5 * side / shape.cut.half_height);
    draw_cuts(canvas,
              {inside.x + x.share(shape.at[0]) * inside.width - 0.5 * side,
               inside.y + y.share(shape.at[1]) * inside.height - 0.5 * side, side, side},
              scale, {{.cut = &shape.cut, .style = {.colour = shape.colour, .width = 1.6}}});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "diagram", options.output());
}

}  // namespace sbeh::picture
