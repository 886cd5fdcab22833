#include "tools/picture/canvas/items.h"

#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLContextDevice2D.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <utility>

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

vtkStandardNewMacro(Ground);
vtkStandardNewMacro(Layer);
vtkStandardNewMacro(Image);

bool Ground::Paint(vtkContext2D* painter) {
  auto* device = vtkOpenGLContextDevice2D::SafeDownCast(painter->GetDevice());
  if (!device) return false;
  const int* size = device->GetRenderWindow()->GetSize();
  auto& projection = device->GetProjectionMatrix()->Element;  // set anew by VTK for every rendering
  for (int c = 0; c < 2; ++c) {
    projection[c][c] = 2.0 / size[c];
    projection[c][3] = -1.0;
  }
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(255, 255, 255, 255);
  painter->DrawRect(0.0f, 0.0f, float(size[0]), float(size[1]));
  return true;
}

void Layer::add_fill(const Rect& rect, Colour colour) {
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

void Layer::add_text(double x, double y, const std::string& text, const TextStyle& style) {
  texts_.push_back({float(std::round(x)), float(std::round(y)), displayable(text), style});
}

bool Layer::Paint(vtkContext2D* painter) {
  for (auto& [key, corners] : quads_) {
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->GetBrush()->SetColor(key >> 16u & 255u, key >> 8u & 255u, key & 255u);
    painter->GetBrush()->SetOpacity(255);
    painter->GetDevice()->DrawQuad(corners.data(), int(corners.size() / 2));
  }
  for (auto& [points, style, joined] : lines_) {
    painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter->GetPen()->SetWidth(float(style.width));
    painter->GetPen()->SetColor(style.colour.red, style.colour.green, style.colour.blue, 255);
    const int count = int(points.size() / 2);
    if (joined)
      painter->DrawPoly(points.data(), count);
    else
      painter->DrawLines(points.data(), count);
  }
  for (const Text& text : texts_) {
    set_text_style(painter->GetTextProp(), text.style);
    painter->DrawString(text.x, text.y, text.text.c_str());
  }
  return true;
}

bool Image::Paint(vtkContext2D* painter) {
  painter->DrawImage(float(x), float(y), image);
  return true;
}

}  // namespace sbeh::picture
