#include "studies/report/svg_chart.h"

#include "studies/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

namespace sbeh::studies {

namespace {

// Pixels of the drawing; it is scaled to the width of its place.
constexpr double width = 480, height = 270, left = 82, right = 14, top = 12, bottom = 40;

struct Tick {
  double at;  // on the axis: the value, or its logarithm
  std::string label;
};

struct ShownAxis {
  AxisScale scale;
  double low = 1e300, high = -1e300;

  // The value's place on the axis; nan where it has none.
  double place(double value) const {
    return scale == AxisScale::linear ? value : value > 0 ? std::log10(value) : std::nan("");
  }
  void include(double at) {
    low = std::min(low, at);
    high = std::max(high, at);
  }
  // A little room around the curves, and some around a constant.
  void widen() {
    const double size = std::max(std::abs(low), std::abs(high));
    const bool constant = scale == AxisScale::linear ? high - low <= 1e-6 * size : high == low;
    const double margin = !constant                              ? 0.04 * (high - low)
                        : scale == AxisScale::linear && size > 0 ? 0.1 * size
                                                                 : 1;
    low -= margin;
    high += margin;
  }
  std::vector<Tick> ticks() const;
};

std::vector<Tick> ShownAxis::ticks() const {
  const double rough = (high - low) / 5, power = std::pow(10, std::floor(std::log10(rough)));
  double step = power;
  for (const double factor : {2., 5., 10.})
    if (step < rough) step = factor * power;
  if (scale == AxisScale::logarithmic) step = std::max(1., std::ceil(step));
  const int decimals = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  std::vector<Tick> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    const double at = k == 0 ? 0 : k * step;
    ticks.push_back({at, scale == AxisScale::linear ? fmt::format("{:.{}f}", at, decimals)
                         : at == 0                  ? "1"
                                                    : fmt::format("1e{:.0f}", at)});
  }
  return ticks;
}

// The least place that is shown on the axis of y.
double floor_of(const std::vector<ChartLine>& lines, const ShownAxis& y) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), shown_decades = 16;
  if (y.scale == AxisScale::linear) return -infinity;
  double highest = -infinity;
  for (const ChartLine& line : lines)
    for (const double value : line.y)
      if (std::isfinite(value)) highest = std::fmax(highest, y.place(value));
  return highest - shown_decades;
}

struct Place {
  double x, y;
};
using Curve = std::vector<Place>;

// Curves on the axes; points too close to tell apart are one.
std::vector<Curve> placed(const std::vector<ChartLine>& lines, ShownAxis& x, ShownAxis& y) {
  const double floor = floor_of(lines, y);
  std::vector<Curve> curves;
  for (const ChartLine& line : lines) {
    Curve& curve = curves.emplace_back();
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      const Place p{x.place(line.x[i]), y.place(line.y[i])};
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || p.y < floor) continue;
      curve.push_back(p);
      x.include(p.x);
      y.include(p.y);
    }
  }
  return curves;
}

// Told apart without colours too.
const char* dashes(std::size_t line) {
  constexpr const char* patterns[] = {"none", "8 3", "2 3", "8 3 2 3"};
  return patterns[line % std::size(patterns)];
}

std::string legend_of(const std::vector<ChartLine>& lines, const std::vector<Curve>& curves) {
  if (lines.size() < 2) return "";
  std::string text;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (curves[k].size() > 1)
      text += fmt::format(
          " <svg class=\"key\" viewBox=\"0 0 30 8\"><path d=\"M0 4H30\" stroke=\"var(--c{0})\" "
          "stroke-width=\"2.5\" stroke-dasharray=\"{1}\"/></svg>&nbsp;{2}",
          k, dashes(k), html::escaped(lines[k].name));
  return text;
}

bool has_a_line(const std::vector<Curve>& curves) {
  return std::ranges::any_of(curves, [](const Curve& c) { return c.size() > 1; });
}

struct ShownAxes {
  ShownAxis x, y;

  explicit ShownAxes(const ChartFrame& frame) : x{frame.x}, y{frame.y} {}
  void leave_room() {
    if (x.high == x.low) x.widen();
    y.widen();
  }
};

// The chart; empty without a line.
std::string drawn(const ChartFrame& frame, const std::vector<ChartLine>& lines,
                  const std::vector<Curve>& curves, const ShownAxes& axes) {
  if (!has_a_line(curves)) return "";
  const ShownAxis &x = axes.x, &y = axes.y;
  const auto across = [&](double at) {
    return left + (width - left - right) * (at - x.low) / (x.high - x.low);
  };
  const auto up = [&](double at) {
    return height - bottom - (height - top - bottom) * (at - y.low) / (y.high - y.low);
  };
  std::string text = fmt::format(
      "<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\" fill=\"none\" "
      "font-size=\"12\">\n",
      width, height, html::escaped(frame.title));
  for (const Tick& tick : x.ticks())
    text += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"var(--line)\"/><text x=\"{0:.1f}\" y=\"{3}\" "
        "text-anchor=\"middle\" fill=\"var(--soft)\">{4}</text>\n",
        across(tick.at), top, height - bottom, height - bottom + 16, tick.label);
  for (const Tick& tick : y.ticks())
    text += fmt::format(
        "<path d=\"M{1} {0:.1f}H{2}\" stroke=\"var(--line)\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\" fill=\"var(--soft)\">{5}</text>\n",
        up(tick.at), left, width - right, left - 6, up(tick.at) + 4, tick.label);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    std::string path;
    Place last{-1, -1};
    for (const Place& p : curves[k]) {
      const Place at{across(p.x), up(p.y)};
      if (!path.empty() && std::hypot(at.x - last.x, at.y - last.y) < 0.5) continue;
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x, at.y);
      last = at;
    }
    text += fmt::format(
        "<path d=\"{0}\" stroke=\"var(--c{1})\" stroke-width=\"1.8\" stroke-dasharray=\"{2}\"/>\n",
        path, k, dashes(k));
  }
  return text
       + fmt::format(
             "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\" fill=\"var(--ink)\">{}</text>\n"
             "<text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\" "
             "fill=\"var(--ink)\">{}</text>\n"
             "</svg><figcaption>{}{}</figcaption></figure>\n",
             left + (width - left - right) / 2, height - 6, html::escaped(frame.x_name),
             top + (height - top - bottom) / 2, html::escaped(frame.y_name),
             html::escaped(frame.title), legend_of(lines, curves));
}

}  // namespace

std::string svg_chart(const ChartFrame& frame, const std::vector<ChartLine>& lines) {
  return svg_charts({{frame, lines}});
}

std::string svg_charts(const std::vector<Chart>& charts) {
  using Kind = std::tuple<std::string, std::string, AxisScale, AxisScale>;
  const auto kind_of = [](const ChartFrame& f) { return Kind{f.x_name, f.y_name, f.x, f.y}; };
  std::map<Kind, ShownAxes> axes;
  std::vector<std::vector<Curve>> curves;
  for (const auto& [frame, lines] : charts) {
    ShownAxes& of_kind = axes.try_emplace(kind_of(frame), frame).first->second;
    ShownAxes own = of_kind;
    curves.push_back(placed(lines, own.x, own.y));
    if (has_a_line(curves.back())) of_kind = own;
  }
  for (auto& [kind, shown] : axes) shown.leave_room();
  std::string text;
  for (std::size_t k = 0; k < charts.size(); ++k)
    text += drawn(charts[k].frame, charts[k].lines, curves[k], axes.at(kind_of(charts[k].frame)));
  return text;
}

}  // namespace sbeh::studies
