#include "tools/picture/chart/coloured_line.h"

#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPoints2D.h>

#include <cstddef>

namespace sbeh::picture {

namespace {
constexpr int components = 4;  // red, green, blue, opacity: GL2PS wants all four
}

vtkStandardNewMacro(ColouredLine);

void ColouredLine::set_colours(const std::vector<Colour>& colours) {
  colours_.clear();
  for (const Colour& c : colours) {
    colours_.insert(colours_.end(), {c.red, c.green, c.blue, 255});
  }
}

bool ColouredLine::Paint(vtkContext2D* painter) {
  if (!this->Visible || !this->Points) return false;
  auto* points = static_cast<float*>(this->Points->GetVoidPointer(0));
  const auto n = std::size_t(this->Points->GetNumberOfPoints());
  std::vector<float> middles;
  for (std::size_t i = 2; i < 2 * n; ++i) middles.push_back(0.5f * (points[i - 2] + points[i]));

  painter->ApplyPen(this->Pen);
  painter->DrawPoly(middles.data(), int(n - 1), colours_.data(), components);
  painter->DrawPoly(points, int(n), colours_.data(), components);
  return true;
}

}  // namespace sbeh::picture
