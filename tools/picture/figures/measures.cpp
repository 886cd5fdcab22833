#include "studies/figures/tables.h"
#include "tools/picture/chart/history.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/chart/panels.h"
#include "tools/picture/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::picture {
namespace {

const LineStyle sbeh_style{.colour = {0, 84, 159}, .width = 2.6};
const LineStyle ssh_style{.colour = red, .width = 2.6, .pattern = Pattern::dashed};

using studies::figures::MeasureRow;

// What is earlier looks like the start.
double first_shown(const std::vector<MeasureRow>& rows) {
  if (rows.empty()) return 0.0;
  return std::min(1e-2, std::ranges::max(rows, {}, &MeasureRow::time).time / 100.0);
}

struct Panel {
  double MeasureRow::*quantity;
  const char* title;
};
constexpr Panel panels[] = {{&MeasureRow::energy, "energy U"},
                            {&MeasureRow::W2, "W₂ = ∫ H dS"},
                            {&MeasureRow::order_std, "standard deviation of the order β"}};

struct Curve {
  std::string name;  // with k₀ where there is one
  LineStyle style;
  Points points[3];  // log₁₀ t and the quantity, per panel
};

std::vector<Curve> read_curves(const std::filesystem::path& file) {
  const auto rows = studies::read_rows(studies::figures::measure_columns(), file);
  const double first = first_shown(rows);
  std::vector<Curve> curves;
  for (const auto& [model, style] :
       {std::pair(model::Model::SBEH, sbeh_style), std::pair(model::Model::SSH, ssh_style)}) {
    Curve curve{name(model), style, {}};
    for (const MeasureRow& row : rows) {
      if (row.model != model || !(row.time >= first) || row.time <= 0) continue;
      if (row.residual_stiffness > 0)
        curve.name = fmt::format("{} with k₀ = {:.4g}", name(model), row.residual_stiffness);
      for (int i = 0; i < 3; ++i)
        curve.points[i].push_back({std::log10(row.time), row.*panels[i].quantity});
    }
    if (curve.points[0].size() > 1) curves.push_back(std::move(curve));
  }
  return curves;
}

Axis value_axis(const std::vector<Curve>& curves, int panel, double length, double text) {
  Range range;
  for (const Curve& curve : curves)
    for (const auto& point : curve.points[panel]) range.include(point[1]);
  if (range.width() < 1e-9) range.high = range.low + 0.1;  // of SSH alone: the order does not vary
  const double room = 0.04 * range.width();
  return exact_axis(range.low - room, range.high + room, length, 3.0 * text);
}

}  // namespace

void draw_figure_measures(Canvas& canvas, const Options& options) {
  const std::vector<Curve> curves = read_curves(options.directory / "measures.csv");
  if (curves.empty()) {
    fmt::print("no measures: no run has made two steps\n");
    return;
  }
  Range times;
  std::vector<LegendEntry> legend;
  for (const Curve& curve : curves) {
    times.include(curve.points[0].front()[0]);
    times.include(curve.points[0].back()[0]);
    legend.push_back(line_entry(curve.style, curve.name));
  }
  const Axis time = decade_axis(times.low, times.high, "t");

  const double text = options.text_size();
  double titles = 0.0;
  for (const Panel& panel : panels) titles = std::max(titles, canvas.text_width(panel.title, text));
  const double usual_width = 1600.0 / 3.0;
  const double legend_at =
      legend_height(canvas, legend, options.width(3.0 * usual_width) - 2.0 * text, text);
  const PanelGrid grid = arranged({.count = std::size(panels),
                                   .most_columns = std::size(panels),
                                   .usual_width = usual_width,
                                   .least_width = titles,
                                   .height_by_width = 0.95,
                                   .left = 4.6 * text,
                                   .right = 1.2 * text,
                                   .below = below_axis(text),
                                   .above = 2.6 * text,
                                   .bottom = legend_at + 0.8 * text},
                                  options);
  canvas.start(grid.width, grid.height, options.unit());
  for (int i = 0; i < 3; ++i) {
    const Rect inside = grid.inside(std::size_t(i));
    Chart chart(canvas, inside, text, time, value_axis(curves, i, inside.height, text));
    for (const Curve& curve : curves) chart.curve(curve.points[i], curve.style);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, panels[i].title, {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, grid.width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "measures", options.output());
}

}  // namespace sbeh::picture
