#include "tools/picture/chart/chart.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPoints2D.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>

namespace sbeh::picture {
namespace {

constexpr double label_size = 0.85, line_height = 1.2;   // of the text
constexpr double tick_length = 5.0, label_offset = 7.0;  // pixels at the usual size of letters

void set_axis(vtkAxis* axis, const Axis& wanted, double text_size, double unit) {
  const bool visible = !wanted.ticks.empty() || !wanted.title.empty();
  axis->SetVisible(visible);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(wanted.low, wanted.high);
  axis->SetTitle("");
  axis->SetGridVisible(false);
  axis->GetPen()->SetColor(dark_grey.red, dark_grey.green, dark_grey.blue);
  axis->GetPen()->SetWidth(float(1.2 * unit));
  axis->SetTickLength(float(tick_length * unit));
  axis->SetLabelOffset(float(label_offset * unit));
  set_font(axis->GetLabelProperties(), label_size * text_size);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (std::size_t i = 0; i < wanted.ticks.size(); ++i) {
    positions->InsertNextValue(wanted.ticks[i]);
    labels->InsertNextValue(displayable(wanted.labels[i]));
  }
  axis->SetCustomTickPositions(positions, labels);
}

// Beyond the labels.
void draw_titles(Canvas& canvas, const Rect& inside, const Axis& x, const Axis& y,
                 double text_size) {
  const double to_labels = canvas.unit() * label_offset;
  double widest = 0.0;
  for (const std::string& label : y.labels)
    if (!label.empty()) widest = std::max(widest, canvas.text_width(label, label_size * text_size));
  canvas.text(inside.centre_x(),
              inside.y - to_labels - (line_height * label_size + 0.5) * text_size, x.title,
              {.size = text_size});
  canvas.text(inside.x - to_labels - widest - 0.9 * text_size, inside.centre_y(), y.title,
              {.size = text_size, .upward = true});
}

Axis legible(const Canvas& canvas, const Axis& axis, bool upright, double length,
             double text_size) {
  constexpr double gap = 0.4, least_tick = 0.2;  // of the text
  const Axis plain = without_lesser_ticks(axis, length, least_tick * text_size);
  std::vector<double> extents;
  for (const std::string& label : plain.labels)
    extents.push_back(label.empty() ? 0.0
                      : upright     ? line_height * label_size * text_size
                                    : canvas.text_width(label, label_size * text_size));
  return without_crowd(plain, extents, length, upright ? 0.0 : gap * text_size);
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

// A line with a colour per point, one in pieces, or marks of one colour. VTK's own lines have one colour, and its marks end the
// program in VTK 9.3, which asks for a colour per point.
class Plot : public vtkPlotLine {
 public:
  static Plot* New();

  std::vector<unsigned char> colours;  // of the points: red, green, blue, opacity (GL2PS wants all)
  std::vector<int> pieces;             // of a dashed line: their numbers of points

  bool Paint(vtkContext2D* painter) override {
    if (!this->Visible || !this->Points) return false;
    auto* points = static_cast<float*>(this->Points->GetVoidPointer(0));
    const auto n = std::size_t(this->Points->GetNumberOfPoints());
    painter->ApplyPen(this->Pen);
    for (auto* from = points; const int count : pieces) {
      painter->DrawPoly(from, count);
      from += 2 * count;
    }
    if (!pieces.empty()) return true;
    if (colours.empty()) {
      painter->ApplyBrush(this->Brush);
      painter->GetPen()->SetWidth(this->MarkerSize);
      painter->DrawMarkers(this->MarkerStyle, false, points, int(n));
      return true;
    }
    std::vector<float> middles;  // the pieces between them close the gaps at the joints
    for (std::size_t i = 2; i < 2 * n; ++i) middles.push_back(0.5f * (points[i - 2] + points[i]));
    painter->DrawPoly(middles.data(), int(n - 1), colours.data(), 4);
    painter->DrawPoly(points, int(n), colours.data(), 4);
    return true;
  }
};

vtkStandardNewMacro(Plot);

int style_of(Marker marker) {
  switch (marker) {
    case Marker::full:
    case Marker::hollow:
    case Marker::dotted:
      return vtkPlotPoints::SQUARE;
    case Marker::cross:
      return vtkPlotPoints::CROSS;
    case Marker::plus:
      return vtkPlotPoints::PLUS;
    case Marker::diamond:
      return vtkPlotPoints::DIAMOND;
    case Marker::circle:
      return vtkPlotPoints::CIRCLE;
  }
  return vtkPlotPoints::SQUARE;
}

}  // namespace

double below_axis(double text_size) { return 2.5 * text_size + std::max(18.0, 0.9 * text_size); }

Chart::Chart(Canvas& canvas, const Rect& inside, double text_size, const Axis& x, const Axis& y) {
  if (!x.ticks.empty() && !y.ticks.empty())
    require_room(inside, std::max(5.0 * text_size, 0.9 * canvas.text_width(x.title, text_size)),
                 4.0 * text_size);
  unit_ = canvas.unit();
  vtkNew<vtkChartXY> chart;
  chart->SetAutoSize(false);
  chart->SetAutoAxes(false);  // an axis without curves stays
  chart->SetRenderEmpty(true);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  chart->SetSize(
      vtkRectf(float(inside.x), float(inside.y), float(inside.width), float(inside.height)));
  canvas.add(chart);
  chart_ = chart;
  inside_ = inside;
  x_ = {x.low, x.high};
  y_ = {y.low, y.high};
  const Axis shown_x = legible(canvas, x, false, inside.width, text_size),
             shown_y = legible(canvas, y, true, inside.height, text_size);
  set_axis(chart->GetAxis(vtkAxis::BOTTOM), shown_x, text_size, unit_);
  set_axis(chart->GetAxis(vtkAxis::LEFT), shown_y, text_size, unit_);
  draw_titles(canvas, inside, shown_x, shown_y, text_size);
}

Points Chart::to_pixels(const Points& points) const {
  Points pixels;
  for (const auto& [x, y] : points)
    pixels.push_back(
        {(x - x_.low) / x_.width() * inside_.width, (y - y_.low) / y_.width() * inside_.height});
  return pixels;
}

Points Chart::to_data(const Points& pixels) const {
  Points points;
  for (const auto& [x, y] : pixels)
    points.push_back(
        {x_.low + x / inside_.width * x_.width(), y_.low + y / inside_.height * y_.width()});
  return points;
}

void Chart::curve(const Points& points, const LineStyle& style) {
  if (points.size() < 2) return;
  vtkNew<Plot> plot;
  Points all;
  const LineStyle drawn{style.colour, unit_ * style.width, style.pattern};
  for (const Points& piece : drawn_pieces(to_pixels(points), drawn)) {
    if (piece.size() < 2) continue;
    plot->pieces.push_back(int(piece.size()));
    const Points data = to_data(piece);
    all.insert(all.end(), data.begin(), data.end());
  }
  plot->SetInputData(table_of(all), 0, 1);
  plot->SetColor(style.colour.red, style.colour.green, style.colour.blue, 255);
  plot->GetPen()->SetWidth(float(drawn.width));
  chart_->AddPlot(plot);
}

void Chart::coloured_curve(const Points& points, const std::vector<Colour>& colours, double width) {
  if (points.size() < 2) return;
  curve(points, {.colour = dark_grey, .width = width + 1.6});
  vtkNew<Plot> plot;
  plot->SetInputData(table_of(points), 0, 1);
  for (const Colour& c : colours)
    plot->colours.insert(plot->colours.end(), {c.red, c.green, c.blue, 255});
  plot->GetPen()->SetWidth(float(unit_ * width));
  chart_->AddPlot(plot);
}

void Chart::markers(const Points& points, Marker marker, Colour colour, double size) {
  if (points.empty()) return;
  vtkNew<Plot> plot;
  plot->SetInputData(table_of(points), 0, 1);
  plot->SetColor(colour.red, colour.green, colour.blue, 255);
  plot->SetMarkerStyle(style_of(marker));
  plot->SetMarkerSize(float(size));
  chart_->AddPlot(plot);
  if (marker == Marker::hollow) markers(points, Marker::full, white, size - 4.0);
  if (marker == Marker::dotted) markers(points, Marker::circle, white, 0.5 * size);
}

}  // namespace sbeh::picture
