#include "tools/picture/canvas/layer.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextDevice2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <cmath>

namespace sbeh::picture {
namespace {

void set_text_style(vtkTextProperty* property, const TextStyle& style) {
  set_font(property, style.size);
  property->SetColor(style.colour.red / 255.0, style.colour.green / 255.0,
                     style.colour.blue / 255.0);
  property->SetOrientation(style.upward ? 90.0 : 0.0);
  property->SetVerticalJustificationToCentered();
  switch (style.align) {
    case Align::left:
      property->SetJustificationToLeft();
      break;
    case Align::centre:
      property->SetJustificationToCentered();
      break;
    case Align::right:
      property->SetJustificationToRight();
      break;
  }
}

}  // namespace

vtkStandardNewMacro(Layer);

void Layer::fill(const Rect& rect, Colour colour) {
  const unsigned key = colour.red << 16u | colour.green << 8u | colour.blue;
  const auto left = float(rect.x), right = float(rect.right());
  const auto bottom = float(rect.y), top = float(rect.top());
  auto& quads = quads_[key];
  quads.insert(quads.end(), {left, bottom, right, bottom, right, top, left, top});
}

void Layer::add_line(const Points& points, const LineStyle& style, bool joined) {
  Line line{{}, style, joined};
  for (const auto& [x, y] : points) line.points.insert(line.points.end(), {float(x), float(y)});
  if (points.size() > 1) lines_.push_back(std::move(line));
}

void Layer::line(const Points& points, const LineStyle& style) { add_line(points, style, true); }

void Layer::segments(const Points& ends, const LineStyle& style) { add_line(ends, style, false); }

void Layer::text(double x, double y, const std::string& text, const TextStyle& style) {
  texts_.push_back({float(std::round(x)), float(std::round(y)), displayable(text), style});
}

bool Layer::Paint(vtkContext2D* painter) {
  for (auto& [key, quads] : quads_) {
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->GetBrush()->SetColor(key >> 16u & 255u, key >> 8u & 255u, key & 255u);
    painter->GetBrush()->SetOpacity(255);
    painter->GetDevice()->DrawQuad(quads.data(), int(quads.size() / 2));
  }
  for (auto& line : lines_) {
    painter->GetPen()->SetLineType(line.style.dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
    painter->GetPen()->SetWidth(float(line.style.width));
    painter->GetPen()->SetColor(line.style.colour.red, line.style.colour.green,
                                line.style.colour.blue, 255);
    const int count = int(line.points.size() / 2);
    if (line.joined) {
      painter->DrawPoly(line.points.data(), count);
    } else {
      painter->DrawLines(line.points.data(), count);
    }
  }
  for (const auto& text : texts_) {
    set_text_style(painter->GetTextProp(), text.style);
    painter->DrawString(text.x, text.y, text.text.c_str());
  }
  return true;
}

}  // namespace sbeh::picture
