#include "studies/compare/compare.h"

#include "tools/picture/chart/legend.h"
#include "tools/picture/studies/method_style.h"
#include "tools/picture/studies/studies.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

using studies::Witness;

// One method's points, in the order of the file.
struct Curve {
  Witness method;
  Points section{};   // (r, z)
  Points distance{};  // (arc length, |distance|)
  double largest = 0.0;

  // Nodes, which are no curve.
  bool is_marked() const { return studies::is_in_3d(method); }
  Marker marker() const {
    if (method == Witness::states) return Marker::plus;
    return method == Witness::harmonics ? Marker::diamond : Marker::full;
  }
  LineStyle style() const { return style_of(method); }
};

std::vector<Curve> read_curves(const std::filesystem::path& file, double unit) {
  std::vector<Curve> curves;
  for (const studies::PlacedPoint& point : studies::read_rows(studies::placed_columns(), file)) {
    if (curves.empty() || curves.back().method != point.method)
      curves.push_back({.method = point.method});
    Curve& curve = curves.back();
    const double distance = unit * std::abs(point.distance);
    curve.section.push_back({unit * point.r, unit * point.z});
    curve.distance.push_back({unit * point.arc_length, distance});
    curve.largest = std::max(curve.largest, distance);
  }
  if (curves.empty())
    throw InputError(file.string() + ": has no rows: no method has found a profile.");
  return curves;
}

struct Box {
  double r = 0.0, length = 0.0;
  Range z;
};
Box box_of(const std::vector<Curve>& curves) {
  Box box;
  for (const Curve& curve : curves)
    for (std::size_t i = 0; i < curve.section.size(); ++i) {
      box.r = std::max(box.r, curve.section[i][0]);
      box.z.include(curve.section[i][1]);
      box.length = std::max(box.length, curve.distance[i][0]);
    }
  return box;
}

Points other_half(const Points& half) {
  Points mirrored;
  for (const auto& [r, z] : half) mirrored.push_back({-r, z});
  return mirrored;
}

void draw_curve(Chart& chart, const Curve& curve, const Points& points, double text) {
  if (curve.is_marked())
    chart.markers(points, curve.marker(), curve.style().colour,
                  (curve.marker() == Marker::full ? 0.18 : 0.36) * text);
  else
    chart.curve(points, curve.style());
}

void draw_section(Canvas& canvas, const Rect& inside, double text, const Axis& r, const Axis& z,
                  const std::vector<Curve>& curves) {
  Chart chart(canvas, inside, text, r, z);
  for (const Curve& curve : curves)
    for (const Points& half : {curve.section, other_half(curve.section)})
      draw_curve(chart, curve, half, text);
}

// Whole decades, without lesser ticks between.
Axis decades(double low, double high, std::string title) {
  const Axis all = decade_axis(std::floor(std::log10(low)), std::ceil(std::log10(high) + 0.05),
                               std::move(title));
  Axis axis{.low = all.low, .high = all.high, .title = all.title};
  for (std::size_t i = 0; i < all.ticks.size(); ++i)
    if (!all.labels[i].empty()) {
      axis.ticks.push_back(all.ticks[i]);
      axis.labels.push_back(all.labels[i]);
    }
  return axis;
}

// Distances far below the largest, such as where curves cross, stay on the lower edge.
void draw_distances(Canvas& canvas, const Rect& inside, double text, const Axis& s,
                    const std::string& title, const std::vector<Curve>& curves) {
  Range largest;
  for (const Curve& curve : curves)
    if (curve.largest > 0.0) largest.include(curve.largest);
  if (largest.low > largest.high) return;  // there is nothing but the first method
  const Axis y = decades(std::max(1e-3 * largest.low, 1e-16), largest.high, title);
  Chart chart(canvas, inside, text, s, y);
  for (const Curve& curve : curves) {
    if (curve.largest == 0.0) continue;
    Points points;
    for (const auto& [length, distance] : curve.distance)
      points.push_back({length, std::log10(std::max(distance, std::pow(10.0, y.low)))});
    draw_curve(chart, curve, points, text);
  }
}

}  // namespace

void draw_compared_profiles(Canvas& canvas, const Options& options) {
  if (!std::filesystem::exists(options.directory / "profiles.csv")) {
    if (!options.only.empty()) fmt::print("no profiles: the comparison is one of an evolution\n");
    return;
  }
  const std::vector<Curve> curves =
      read_curves(options.directory / "profiles.csv", options.factor(studies::dimension::length));
  const double text = options.text_size();
  std::vector<LegendEntry> legend;
  legend.reserve(curves.size());
  for (const Curve& curve : curves)
    legend.push_back(curve.is_marked() ? marker_entry(curve.marker(), curve.style().colour,
                                                      std::string(name(curve.method)) + " (nodes)")
                                       : line_entry(curve.style(), name(curve.method)));
  const Box box = box_of(curves);
  const double left = 5.6 * text, right = 1.6 * text, below = below_axis(text);
  const double width = options.width(1000.0);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double distances = 13.0 * text;  // height of the lower chart
  const double fixed = 2.0 * below + distances + legend_at + 3.6 * text;
  const double highest = options.height(1500.0) - fixed;
  // One scale for r and z, as large as width and height allow.
  const double margin = 0.06 * std::max(box.r, 0.5 * box.z.width());
  const double across = 2.0 * (box.r + margin), up = box.z.width() + 2.0 * margin;
  const double scale = std::min((width - left - right) / across, std::max(highest, text) / up);
  const double height = options.height(fixed + scale * up);
  const Rect section{left + 0.5 * (width - left - right - scale * across),
                     height - 1.2 * text - scale * up, scale * across, scale * up};
  const Rect lower{left, legend_at + 0.8 * text + below, width - left - right, distances};

  const auto titled = [&](const std::string& title) {
    return options.titled(title, studies::dimension::length);
  };
  const auto axis = [&](double low, double high, const char* title) {
    return exact_axis(low, high, scale * (high - low), 4.0 * text, titled(title));
  };
  canvas.start(width, height, options.unit());
  draw_section(canvas, section, text, axis(-box.r - margin, box.r + margin, "r"),
               axis(box.z.low - margin, box.z.high + margin, "z"), curves);
  const Axis s = exact_axis(0.0, box.length, lower.width, 5.0 * text,
                            titled(std::string("arc length of ") + name(curves.front().method)));
  draw_distances(canvas, lower, text, s, titled("distance"), curves);
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "profiles", options.output());
}

}  // namespace sbeh::picture
