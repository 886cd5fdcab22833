// Reading VTU and VTP with VTK's own readers: all their encodings and compressions.
#include "studies/io/errors.h"
#include "studies/mesh_files/formats.h"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <vector>

namespace sbeh::studies {

namespace {

// Reads; throws with the first error VTK reports, and keeps VTK from printing it.
template <class Reader>
auto read(Reader* reader, const std::string& file) {
  std::string first_error;
  vtkNew<vtkCallbackCommand> remember;
  remember->SetClientData(&first_error);
  remember->SetCallback([](vtkObject*, unsigned long, void* data, void* text) {
    auto& error = *static_cast<std::string*>(data);
    if (error.empty() && text) error = static_cast<const char*>(text);
  });
  reader->AddObserver(vtkCommand::ErrorEvent, remember);
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (first_error.empty() && reader->GetErrorCode() == 0) return reader->GetOutput();
  throw InputError(fmt::format("{}: is damaged or cut off: VTK cannot read it", file));
}

// Cells by their points' numbers alone, which may be anything in a damaged file.
struct Cells {
  std::vector<std::vector<int>> points;
  std::vector<int> numbers;  // in the file
  int left_out = 0;          // points and lines
};

bool is_point_or_line(int type) {
  for (const int known : {VTK_EMPTY_CELL, VTK_VERTEX, VTK_POLY_VERTEX, VTK_LINE, VTK_POLY_LINE,
                          VTK_QUADRATIC_EDGE, VTK_CUBIC_LINE, VTK_LAGRANGE_CURVE})
    if (type == known) return true;
  return false;
}

bool is_triangle(int type) {
  return type == VTK_TRIANGLE || type == VTK_QUADRATIC_TRIANGLE || type == VTK_LAGRANGE_TRIANGLE;
}

// As faces, which are several where the cell is a strip; none for cells of other kinds.
std::vector<std::vector<int>> faces_of(int type, const std::vector<int>& p) {
  if (is_triangle(type) && (p.size() == 3 || p.size() == 6 || p.size() == 10)) return {p};
  if (type == VTK_PIXEL && p.size() == 4) return {{p[0], p[1], p[3], p[2]}};
  if ((type == VTK_QUAD || type == VTK_POLYGON) && p.size() >= 3) return {p};
  std::vector<std::vector<int>> faces;
  if (type == VTK_TRIANGLE_STRIP)
    for (std::size_t i = 2; i < p.size(); ++i)
      faces.push_back({p[i - (i % 2 == 0 ? 2 : 1)], p[i - (i % 2 == 0 ? 1 : 2)], p[i]});
  return faces;
}

std::vector<int> points_of_cell(vtkDataSet& data, vtkIdType cell, const std::string& file) {
  vtkNew<vtkIdList> ids;
  data.GetCellPoints(cell, ids);
  std::vector<int> points;
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k) {
    const vtkIdType point = ids->GetId(k);
    if (point < 0 || point >= data.GetNumberOfPoints())
      throw InputError(fmt::format("{}: cell {}: point {}: there are only {}", file, cell, point,
                                   data.GetNumberOfPoints()));
    points.push_back(int(point));
  }
  return points;
}

Cells cells_of(vtkDataSet& data, const std::string& file) {
  Cells cells;
  for (vtkIdType t = 0; t < data.GetNumberOfCells(); ++t) {
    const int type = data.GetCellType(t);
    const std::vector<int> points = points_of_cell(data, t, file);
    if (is_point_or_line(type)) {
      ++cells.left_out;
      continue;
    }
    const auto faces = faces_of(type, points);
    if (faces.empty())
      throw InputError(fmt::format(
          "{}: cell {} (VTK's type {}, {} points): must be a triangle of order 1, 2 or 3, or a "
          "plain polygon: export the surface alone",
          file, t, type, points.size()));
    for (const auto& face : faces) {
      cells.points.push_back(face);
      cells.numbers.push_back(int(t));
    }
  }
  return cells;
}

bool is_curved(const Cells& cells, vtkDataSet& data) {
  return !cells.points.empty() && is_triangle(data.GetCellType(cells.numbers[0]))
      && cells.points[0].size() > 3;
}

// All of one order.
Eigen::MatrixXi matrix_of(const Cells& cells, const std::string& file) {
  const std::size_t size = cells.points[0].size();
  Eigen::MatrixXi matrix(Eigen::Index(size), Eigen::Index(cells.points.size()));
  for (std::size_t t = 0; t < cells.points.size(); ++t) {
    if (cells.points[t].size() != size)
      throw InputError(fmt::format(
          "{}: cell {} has {} points, cell {} has {}: all triangles must be of one order", file,
          cells.numbers[t], cells.points[t].size(), cells.numbers[0], size));
    matrix.col(Eigen::Index(t)) =
        Eigen::Map<const Eigen::VectorXi>(cells.points[t].data(), Eigen::Index(size));
  }
  return matrix;
}

Eigen::Matrix3Xd points_of(vtkDataSet& data) {
  Eigen::Matrix3Xd points(3, data.GetNumberOfPoints());
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) data.GetPoint(i, points.col(i).data());
  return points;
}

// By name: components x tuples.
NodeFields arrays_of(vtkFieldData& data) {
  NodeFields fields;
  for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
    vtkDataArray* array = data.GetArray(a);
    if (!array || !array->GetName()) continue;
    Eigen::MatrixXd values(array->GetNumberOfComponents(), array->GetNumberOfTuples());
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      array->GetTuple(i, values.col(i).data());
    fields[array->GetName()] = values;
  }
  return fields;
}

}  // namespace

MeshFile read_vtk(const std::string& file, bool poly_data) {
  vtkNew<vtkXMLPolyDataReader> poly_reader;
  vtkNew<vtkXMLUnstructuredGridReader> grid_reader;
  vtkDataSet* data = nullptr;
  if (poly_data)
    data = read(poly_reader.Get(), file);
  else
    data = read(grid_reader.Get(), file);
  const Cells cells = cells_of(*data, file);
  MeshFile result{{}, left_out(cells.left_out, "points or lines")};
  const Eigen::Matrix3Xd points = points_of(*data);
  const meshing::Names names{meshing::counted(int(points.cols())), cells.numbers};
  if (is_curved(cells, *data))
    result.mesh = CurvedCellsFile{.cells = {points, matrix_of(cells, file), names},
                                  .fields = arrays_of(*data->GetPointData()),
                                  .globals = arrays_of(*data->GetFieldData())};
  else
    result.mesh = PlainFile{{points, cells.points, names}};
  return result;
}

}  // namespace sbeh::studies
