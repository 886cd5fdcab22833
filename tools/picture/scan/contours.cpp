#include "tools/picture/scan/contours.h"

#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStripper.h>

#include <cmath>

namespace sbeh::picture {
namespace {

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
  const auto id = [&](std::size_t i, std::size_t j) { return vtkIdType(i * y.size() + j); };
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
  return lines;
}

}  // namespace sbeh::picture
