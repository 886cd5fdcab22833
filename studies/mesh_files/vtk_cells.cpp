#include "studies/mesh_files/vtk_cells.h"

#include "studies/io/errors.h"

#include <fmt/format.h>
#include <vtkCellType.h>

namespace sbeh::studies {

namespace {

struct Faces {
  std::vector<std::vector<int>> points;
  std::vector<int> cells;
  int left_out = 0;  // points and lines
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

// Several where the cell is a strip; none for cells of other kinds.
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

Faces faces_of(const std::vector<VtkCell>& cells, long point_count, const std::string& file) {
  Faces faces;
  for (std::size_t t = 0; t < cells.size(); ++t) {
    const auto& [type, points] = cells[t];
    for (const long point : points)
      if (point < 0 || point >= point_count)
        throw InputError(
            fmt::format("{}: cell {}: point {}: there are only {}", file, t, point, point_count));
    if (is_point_or_line(type)) {
      ++faces.left_out;
      continue;
    }
    const auto of_cell = faces_of(type, {points.begin(), points.end()});
    if (of_cell.empty())
      throw InputError(fmt::format(
          "{}: cell {} (VTK's type {}, {} points): must be a triangle of order 1, 2 or 3, or a "
          "plain polygon: export the surface alone",
          file, t, type, points.size()));
    for (const auto& face : of_cell) {
      faces.points.push_back(face);
      faces.cells.push_back(int(t));
    }
  }
  return faces;
}

// All of one order.
Eigen::MatrixXi matrix_of(const Faces& faces, const std::string& file) {
  const std::size_t size = faces.points[0].size();
  Eigen::MatrixXi matrix(Eigen::Index(size), Eigen::Index(faces.points.size()));
  for (std::size_t t = 0; t < faces.points.size(); ++t) {
    if (faces.points[t].size() != size)
      throw InputError(fmt::format(
          "{}: cell {} has {} points, cell {} has {}: all triangles must be of one order", file,
          faces.cells[t], faces.points[t].size(), faces.cells[0], size));
    matrix.col(Eigen::Index(t)) =
        Eigen::Map<const Eigen::VectorXi>(faces.points[t].data(), Eigen::Index(size));
  }
  return matrix;
}

}  // namespace

MeshFile mesh_of(const Eigen::Matrix3Xd& points, const std::vector<VtkCell>& cells,
                 const std::string& file) {
  const Faces faces = faces_of(cells, points.cols(), file);
  MeshFile result{{}, left_out(faces.left_out, "points or lines")};
  const meshing::Names names{meshing::counted(int(points.cols())), faces.cells};
  const bool is_curved = !faces.points.empty() && faces.points[0].size() > 3
                      && is_triangle(cells[std::size_t(faces.cells[0])].type);
  if (is_curved)
    result.mesh = CurvedCellsFile{{points, matrix_of(faces, file), names}, {}, {}};
  else
    result.mesh = PlainFile{{points, faces.points, names}};
  return result;
}

}  // namespace sbeh::studies
