#include "tools/picture/canvas/geometry.h"

#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

// The part of a segment inside, by Liang and Barsky; empty when there is none.
using Point = Points::value_type;
std::optional<std::pair<Point, Point>> clipped(const Point& from, const Point& to,
                                               const Rect& inside) {
  double begin = 0, end = 1;
  const auto limit = [&](double start, double change, double low, double high) {
    if (change == 0) return start >= low && start <= high;
    double enter = (low - start) / change, leave = (high - start) / change;
    if (enter > leave) std::swap(enter, leave);
    begin = std::max(begin, enter);
    end = std::min(end, leave);
    return begin < end;
  };
  const double dx = to[0] - from[0], dy = to[1] - from[1];
  if (!limit(from[0], dx, inside.x, inside.right()) || !limit(from[1], dy, inside.y, inside.top()))
    return {};
  return std::pair(Point{from[0] + begin * dx, from[1] + begin * dy},
                   Point{from[0] + end * dx, from[1] + end * dy});
}

vtkNew<vtkPolyData> cells_with_values(const std::vector<double>& x, const std::vector<double>& y,
                                      const std::vector<std::vector<double>>& values) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> scalars;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < y.size(); ++j) {
      points->InsertNextPoint(x[i], y[j], 0.0);
      scalars->InsertNextValue(values[i][j]);
    }
  }
  vtkNew<vtkCellArray> cells;
  const auto id = [&](std::size_t i, std::size_t j) {
    return vtkIdType(i) * vtkIdType(y.size()) + vtkIdType(j);
  };
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    for (std::size_t j = 0; j + 1 < y.size(); ++j) {
      const double sum = values[i][j] + values[i + 1][j] + values[i + 1][j + 1] + values[i][j + 1];
      if (!std::isfinite(sum)) continue;
      const vtkIdType corners[4] = {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
      cells->InsertNextCell(4, corners);
    }
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  mesh->GetPointData()->SetScalars(scalars);
  return mesh;
}

}  // namespace

double length_of(const Points& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
  return length;
}

std::vector<Points> clipped(const Points& line, const Rect& inside) {
  std::vector<Points> pieces;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto piece = clipped(line[i - 1], line[i], inside);
    if (!piece) continue;
    if (pieces.empty() || pieces.back().back() != piece->first) pieces.push_back({piece->first});
    pieces.back().push_back(piece->second);
  }
  return pieces;
}

std::vector<Points> dashes(const Points& line, const std::vector<double>& lengths) {
  if (lengths.empty() || line.empty()) return {line};
  std::vector<Points> pieces{{line.front()}};
  std::size_t k = 0;  // of the length we are in
  double left = lengths[0];
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto &from = line[i - 1], &to = line[i];
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    double travelled = 0.0;
    while (length - travelled > left) {
      travelled += left;
      const double share = travelled / length;
      const Point turn{from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
      if (k % 2 == 0)
        pieces.back().push_back(turn);
      else
        pieces.push_back({turn});
      k = (k + 1) % lengths.size();
      left = lengths[k];
    }
    left -= length - travelled;
    if (k % 2 == 0) pieces.back().push_back(to);
  }
  return pieces;
}

namespace {

bool meet(const Point& a, const Point& b, double distance) {
  return std::abs(a[0] - b[0]) <= distance && std::abs(a[1] - b[1]) <= distance;
}

// Lines that end where another begins are one. VTK's points of one place differ by rounding to single precision.
std::vector<Points> in_one(std::vector<Points> pieces, double distance) {
  std::vector<Points> lines;
  while (!pieces.empty()) {
    Points line = std::move(pieces.back());
    pieces.pop_back();
    for (std::size_t k = 0; k < pieces.size();) {
      Points& other = pieces[k];
      if (meet(line.front(), other.front(), distance) || meet(line.front(), other.back(), distance))
        std::ranges::reverse(line);
      if (meet(line.back(), other.back(), distance)) std::ranges::reverse(other);
      if (!meet(line.back(), other.front(), distance)) {
        ++k;
        continue;
      }
      line.insert(line.end(), other.begin() + 1, other.end());
      pieces.erase(pieces.begin() + std::ptrdiff_t(k));
      k = 0;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

std::vector<Points> contour_lines(const std::vector<double>& x, const std::vector<double>& y,
                                  const std::vector<std::vector<double>>& values, double level) {
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(cells_with_values(x, y, values));
  contour->SetValue(0, level);
  vtkNew<vtkStripper> joined;
  joined->SetInputConnection(contour->GetOutputPort());
  joined->Update();

  std::vector<Points> lines;
  vtkPolyData* output = joined->GetOutput();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (output->GetLines()->InitTraversal(); output->GetLines()->GetNextCell(size, ids);) {
    Points& line = lines.emplace_back();
    for (vtkIdType k = 0; k < size; ++k) {
      const double* p = output->GetPoint(ids[k]);
      line.push_back({p[0], p[1]});
    }
  }
  const double extent = std::max(std::abs(x.back() - x.front()), std::abs(y.back() - y.front()));
  return in_one(std::move(lines), 1e-6 * extent);
}

}  // namespace sbeh::picture
