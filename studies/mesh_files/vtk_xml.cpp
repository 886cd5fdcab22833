// Reading VTU and VTP with VTK's own readers: all their encodings and compressions.
#include "meshing/curving.h"
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

#include <algorithm>
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

// Cell by cell, by their points' numbers alone, which may be anything in a damaged file.
Eigen::MatrixXi cells_of(vtkDataSet& data, const std::string& file) {
  Eigen::MatrixXi cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < data.GetNumberOfCells(); ++t) {
    const int type = data.GetCellType(t);
    data.GetCellPoints(t, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    const bool triangle =
        type == VTK_TRIANGLE || type == VTK_QUADRATIC_TRIANGLE || type == VTK_LAGRANGE_TRIANGLE;
    if (!triangle || (size != 3 && size != 6 && size != 10))
      throw InputError(fmt::format(
          "{}: cell {} (VTK's type {}, {} points): must be a triangle of order 1, 2 or 3", file, t,
          type, size));
    if (t == 0) cells.resize(size, data.GetNumberOfCells());
    if (size != cells.rows())
      throw InputError(fmt::format(
          "{}: cell {} has {} points, cell 0 has {}: all triangles must be of one order", file, t,
          size, cells.rows()));
    for (vtkIdType k = 0; k < size; ++k) {
      const vtkIdType point = ids->GetId(k);
      if (point < 0 || point >= data.GetNumberOfPoints())
        throw InputError(fmt::format("{}: cell {}: point {}: there are only {}", file, t, point,
                                     data.GetNumberOfPoints()));
      cells(k, t) = int(point);
    }
  }
  return cells;
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

// The numbering of the file becomes that of CurvedMesh; `place[i]` is the file's number of node i.
std::vector<int> renumber(const Eigen::MatrixXi& cells, const meshing::TriangleMesh& corners,
                          const std::vector<int>& corner_points, int order, Eigen::MatrixXi& nodes,
                          const std::string& file) {
  nodes = meshing::numbered_nodes(corners, order);
  std::vector<int> place(std::size_t(nodes.maxCoeff()) + 1, -1);
  std::copy(corner_points.begin(), corner_points.end(), place.begin());
  for (Eigen::Index t = 0; t < cells.cols(); ++t)
    for (Eigen::Index k = 3; k < cells.rows(); ++k) {
      int& known = place[std::size_t(nodes(k, t))];
      if (known >= 0 && known != cells(k, t))
        throw InputError(
            fmt::format("{}: cell {}: its point {} on an edge is not that of the neighbour, {}",
                        file, t, cells(k, t), known));
      known = cells(k, t);
    }
  return place;
}

CurvedFile curved_file(vtkDataSet& data, const Eigen::MatrixXi& cells, int order,
                       const std::string& file) {
  const Eigen::Matrix3Xd points = points_of(data);
  const auto of_corners = cells.topRows<3>().reshaped();
  std::vector<int> corner_points(of_corners.begin(), of_corners.end());
  std::sort(corner_points.begin(), corner_points.end());
  corner_points.erase(std::unique(corner_points.begin(), corner_points.end()), corner_points.end());
  std::vector<int> vertex(std::size_t(points.cols()), -1);
  for (std::size_t v = 0; v < corner_points.size(); ++v)
    vertex[std::size_t(corner_points[v])] = int(v);
  const meshing::TriangleMesh corners{
      points(Eigen::all, corner_points),
      cells.topRows<3>().unaryExpr([&](int p) { return vertex[std::size_t(p)]; })};

  CurvedFile result;
  result.mesh.order = order;
  try {
    const std::vector<int> place =
        renumber(cells, corners, corner_points, order, result.mesh.triangles, file);
    result.mesh.nodes = points(Eigen::all, place);
    for (const auto& [name, values] : arrays_of(*data.GetPointData()))
      result.fields[name] = values(Eigen::all, place);
    for (const auto& [name, values] : arrays_of(*data.GetFieldData()))
      result.globals[name] = values.reshaped();
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", file, error.what()));
  }
  return result;
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
  const Eigen::MatrixXi cells = cells_of(*data, file);
  if (cells.size() == 0) return meshing::TriangleMesh{};
  const int order = cells.rows() == 10 ? 3 : cells.rows() == 6 ? 2 : 1;
  if (order > 1) return curved_file(*data, cells, order, file);
  return meshing::TriangleMesh{points_of(*data), cells};
}

}  // namespace sbeh::studies
