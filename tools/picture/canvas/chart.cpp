#include "tools/picture/canvas/chart.h"

#include "tools/picture/canvas/lines.h"

#include <fmt/format.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sbeh::picture {
namespace {

std::string power_of_ten(int exponent) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

std::string decade_label(int exponent, int factor) {
  if (exponent >= -3 && exponent <= 3) {
    return fmt::format("{:g}", factor * std::pow(10.0, exponent));
  }
  return factor == 1 ? power_of_ten(exponent)
                     : fmt::format("{}·{}", factor, power_of_ten(exponent));
}

void set_axis(vtkAxis* axis, const Axis& wanted, double text_size) {
  const bool visible = !wanted.ticks.empty() || !wanted.title.empty();
  axis->SetVisible(visible);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(wanted.low, wanted.high);
  axis->SetTitle(visible ? displayable(wanted.title) : "");
  axis->SetGridVisible(false);
  axis->GetPen()->SetColor(dark_grey.red, dark_grey.green, dark_grey.blue);
  axis->GetPen()->SetWidth(1.2f);
  set_font(axis->GetLabelProperties(), 0.85 * text_size);
  set_font(axis->GetTitleProperties(), text_size);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (std::size_t i = 0; i < wanted.ticks.size(); ++i) {
    positions->InsertNextValue(wanted.ticks[i]);
    labels->InsertNextValue(displayable(wanted.labels[i]));
  }
  axis->SetCustomTickPositions(positions, labels);
}

vtkNew<vtkTable> table_of(const Points& points) {
  vtkNew<vtkTable> table;
  std::array<vtkNew<vtkFloatArray>, 2> columns;
  for (int c = 0; c < 2; ++c) {
    columns[c]->SetName(c == 0 ? "x" : "y");
    for (const auto& point : points) columns[c]->InsertNextValue(float(point[c]));
    table->AddColumn(columns[c]);
  }
  return table;
}

}  // namespace

Axis linear_axis(double low, double high, double length, double spacing, std::string title) {
  if (!(high > low)) {
    const double margin = low == 0.0 ? 0.5 : 0.05 * std::abs(low);
    low -= margin;
    high += margin;
  }
  const double step = vtkAxis::NiceMinMax(low, high, float(length), float(spacing));
  const int decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-6)));
  Axis axis{.low = low, .high = high, .title = std::move(title), .ticks = {}, .labels = {}};
  for (double tick = low; tick < high + 0.5 * step; tick += step) {
    const double clean = std::abs(tick) < 1e-6 * step ? 0.0 : tick;
    axis.ticks.push_back(clean);
    axis.labels.push_back(fmt::format("{:.{}f}", clean, decimals));
  }
  return axis;
}

Axis cropped(const Axis& axis, double low, double high) {
  const double rounding = 1e-9 * (high - low);
  Axis result{.low = low, .high = high, .title = axis.title, .ticks = {}, .labels = {}};
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    if (axis.ticks[i] < low - rounding || axis.ticks[i] > high + rounding) continue;
    result.ticks.push_back(axis.ticks[i]);
    result.labels.push_back(axis.labels[i]);
  }
  return result;
}

Axis decade_axis(double log_low, double log_high, std::string title) {
  if (log_high - log_low < 0.3) {  // less than a factor of 2
    log_low -= 0.2;
    log_high += 0.2;
  }
  const double decades = log_high - log_low;
  Axis axis{.low = log_low, .high = log_high, .title = std::move(title), .ticks = {}, .labels = {}};
  for (int exponent = int(std::floor(log_low)); exponent <= int(std::ceil(log_high)); ++exponent) {
    for (int factor = 1; factor < 10; ++factor) {
      const double tick = exponent + std::log10(double(factor));
      if (tick < log_low - 1e-9 || tick > log_high + 1e-9) continue;
      const bool labelled =
          factor == 1 || (decades < 2.3 && (factor == 2 || factor == 5)) || decades < 0.8;
      axis.ticks.push_back(tick);
      axis.labels.push_back(labelled ? decade_label(exponent, factor) : "");
    }
  }
  return axis;
}

double below_axis(double text_size) { return 2.5 * text_size + 18.0; }

Chart::Chart(Canvas& canvas, const Rect& inside, double text_size, const Axis& x, const Axis& y) {
  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetAutoAxes(false);  // an axis without curves stays
  chart->SetRenderEmpty(true);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  chart->SetSize(
      vtkRectf(float(inside.x), float(inside.y), float(inside.width), float(inside.height)));
  canvas.add(chart);
  chart_ = chart;
  set_axis(chart->GetAxis(vtkAxis::BOTTOM), x, text_size);
  set_axis(chart->GetAxis(vtkAxis::LEFT), y, text_size);
}

void Chart::curve(const Points& points, const LineStyle& style) {
  if (points.size() < 2) return;
  vtkNew<vtkPlotLine> plot;
  plot->SetInputData(table_of(points), 0, 1);
  plot->SetColor(style.colour.red, style.colour.green, style.colour.blue, 255);
  plot->GetPen()->SetWidth(float(style.width));
  plot->GetPen()->SetLineType(style.dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  chart_->AddPlot(plot);
}

void Chart::coloured_curve(const Points& points, const std::vector<Colour>& colours, double width) {
  if (points.size() < 2) return;
  vtkNew<ColouredLine> plot;
  plot->SetInputData(table_of(points), 0, 1);
  plot->set_colours(colours);
  plot->GetPen()->SetWidth(float(width));
  chart_->AddPlot(plot);
}

void Chart::markers(const Points& points, Marker marker, Colour colour, double size) {
  if (points.empty()) return;
  vtkNew<vtkPlotPoints> plot;
  plot->SetInputData(table_of(points), 0, 1);
  plot->SetColor(colour.red, colour.green, colour.blue, 255);
  plot->SetMarkerStyle(marker == Marker::cross ? vtkPlotPoints::CROSS : vtkPlotPoints::SQUARE);
  plot->SetMarkerSize(float(size));
  chart_->AddPlot(plot);
  if (marker == Marker::hollow) markers(points, Marker::full, white, size - 4.0);
}

}  // namespace sbeh::picture
