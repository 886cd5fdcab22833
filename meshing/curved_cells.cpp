#include "meshing/curved_cells.h"

#include "meshing/curving.h"
#include "meshing/measures.h"
#include "meshing/near_points.h"
#include "meshing/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

// The points of a cell seen from the other side.
std::vector<int> turned(int order) {
  if (order == 2) return {0, 2, 1, 5, 4, 3};
  return {0, 2, 1, 8, 7, 6, 5, 4, 3, 9};
}

// The points on edges that have only one cell.
std::vector<bool> points_at_open_edges(const CurvedCells& cells, const CellCorners& corner) {
  const std::vector<bool> open = meshing::points_at_open_edges(corner.mesh);
  std::vector<bool> loose(std::size_t(cells.points.cols()), false);
  for (std::size_t i = 0; i < corner.points.size(); ++i)
    loose[std::size_t(corner.points[i])] = open[i];
  const int on_edge = cells.order() - 1;
  for (int t = 0; t < cells.cells.cols(); ++t)
    for (int side = 0; side < 3; ++side)
      if (open[std::size_t(corner.mesh.triangles(side, t))]
          && open[std::size_t(corner.mesh.triangles((side + 1) % 3, t))])
        for (int k = 0; k < on_edge; ++k)
          loose[std::size_t(cells.cells(3 + on_edge * side + k, t))] = true;
  return loose;
}

void join_points(CellRepair& repair) {
  CurvedCells& cells = repair.cells;
  const CellCorners corner = corners(cells);
  const Eigen::VectorXd of_corners = edge_scale(corner.mesh);
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(cells.points.cols());
  for (int t = 0; t < cells.cells.cols(); ++t)
    for (const int point : cells.cells.col(t))
      scale[point] = of_corners(corner.mesh.triangles.col(t)).minCoeff();
  const NearPoints near = near_points(cells.points, scale, points_at_open_edges(cells, corner));
  for (int& point : cells.cells.reshaped()) point = near.first[std::size_t(point)];
  if (near.joined > 0)
    repair.done.push_back(fmt::format("points joined with others: {}, {}", near.joined,
                                      near.farthest > 0
                                          ? fmt::format("at most {:.2g} apart", near.farthest)
                                          : "of the same coordinates"));
}

void turn(CurvedCells& cells, int t) {
  const Eigen::VectorXi cell = cells.cells.col(t);
  cells.cells.col(t) = cell(turned(cells.order()));
}

}  // namespace

CellCorners corners(const CurvedCells& cells) {
  const auto of_corners = cells.cells.topRows<3>().reshaped();
  const std::set<int> used(of_corners.begin(), of_corners.end());
  CellCorners result{{}, {used.begin(), used.end()}, {{}, cells.names.triangles}};
  std::vector<int> place(std::size_t(cells.points.cols()), -1);
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    place[std::size_t(result.points[i])] = int(i);
    if (!cells.names.points.empty())
      result.names.points.push_back(cells.names.points[std::size_t(result.points[i])]);
  }
  result.mesh.points = cells.points(Eigen::all, result.points);
  result.mesh.triangles =
      cells.cells.topRows<3>().unaryExpr([&](int p) { return place[std::size_t(p)]; });
  return result;
}

JoinedCells joined(const CurvedCells& cells) {
  const CellCorners corner = corners(cells);
  JoinedCells result{{.order = cells.order(),
                      .triangles = numbered_nodes(corner.mesh, cells.order()),
                      .nodes = {}},
                     corner.points};
  const Eigen::MatrixXi& nodes = result.mesh.triangles;
  result.points.resize(std::size_t(nodes.maxCoeff()) + 1, -1);
  const auto name = [&](int point) { return cells.names.points[std::size_t(point)]; };
  for (Eigen::Index t = 0; t < nodes.cols(); ++t)
    for (Eigen::Index k = 3; k < nodes.rows(); ++k) {
      int& known = result.points[std::size_t(nodes(k, t))];
      if (known >= 0 && known != cells.cells(k, t))
        throw std::invalid_argument(fmt::format(
            "cell {}: its point {} on an edge is not that of the neighbour, {}",
            cells.names.triangles[std::size_t(t)], name(cells.cells(k, t)), name(known)));
      known = cells.cells(k, t);
    }
  result.mesh.nodes = cells.points(Eigen::all, result.points);
  return result;
}

CellRepair repaired(const CurvedCells& cells) {
  CellRepair repair{cells, {}};
  join_points(repair);
  const std::vector<int> against = turned_triangles(corners(repair.cells).mesh);
  for (const int t : against) turn(repair.cells, t);
  if (!against.empty())
    repair.done.push_back(
        fmt::format("cells turned to the orientation of their neighbours: {}", against.size()));
  if (volume(corners(repair.cells).mesh) < 0) {
    for (int t = 0; t < repair.cells.cells.cols(); ++t) turn(repair.cells, t);
    repair.done.push_back(fmt::format("cells turned outward: {}", repair.cells.cells.cols()));
  }
  return repair;
}

}  // namespace sbeh::meshing
