#include "meshing/curving.h"

#include "meshing/half_edge_mesh.h"
#include "model/numerics/lagrange.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

// Nodes in the order of model::TriangleElement.
Eigen::MatrixXi numbered(const HalfEdgeMesh& mesh, int order) {
  const int on_edge = order - 1, inside = (order - 1) * (order - 2) / 2;
  const int first_on_edge = int(mesh.n_vertices());
  const int first_inside = first_on_edge + on_edge * int(mesh.n_edges());
  Eigen::MatrixXi triangles(3 + 3 * on_edge + inside, mesh.n_faces());
  for (const auto face : mesh.faces()) {
    int row = 0;
    for (const auto h : face.halfedges()) triangles(row++, face.idx()) = h.from().idx();
    for (const auto h : face.halfedges()) {
      // The first half-edge of the two counts upwards, its opposite downwards.
      const bool upwards = h.idx() == h.edge().h0().idx();
      for (int k = 0; k < on_edge; ++k)
        triangles(row++, face.idx()) =
            first_on_edge + on_edge * h.edge().idx() + (upwards ? k : on_edge - 1 - k);
    }
    for (int k = 0; k < inside; ++k)
      triangles(row++, face.idx()) = first_inside + inside * face.idx() + k;
  }
  return triangles;
}

}  // namespace

CurvedMesh curved(const TriangleMesh& mesh, int order, const Projection& onto_surface) {
  const model::TriangleElement element(order);
  const Eigen::MatrixXd flat = [&] {  // 3 x nodes of an element: barycentric coordinates
    const Eigen::Matrix2Xd x = element.nodes();
    Eigen::MatrixXd b(3, x.cols());
    b << Eigen::RowVectorXd::Ones(x.cols()) - x.colwise().sum(), x;
    return b;
  }();
  const HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  const int F = mesh.triangle_count(), V = mesh.point_count(), E = int(half_edges.n_edges());
  if (V - E + F != 2 || 2 * E != 3 * F)
    throw std::invalid_argument(fmt::format(
        "no closed surface of sphere topology: {} points, {} edges, {} triangles", V, E, F));

  CurvedMesh result{.order = order, .triangles = numbered(half_edges, order), .nodes = {}};
  result.nodes.resize(3, V + (order - 1) * E + (order - 1) * (order - 2) / 2 * F);
  result.nodes.leftCols(V) = mesh.points;
  std::vector<bool> placed(std::size_t(result.node_count()), false);
  for (int t = 0; t < F; ++t) {
    Eigen::Matrix3d corner;
    for (int k = 0; k < 3; ++k) corner.col(k) = mesh.points.col(result.triangles(k, t));
    for (int k = 3; k < element.size(); ++k) {
      const int node = result.triangles(k, t);
      if (placed[std::size_t(node)]) continue;
      placed[std::size_t(node)] = true;
      result.nodes.col(node) = onto_surface(corner * flat.col(k));
    }
  }
  return result;
}

TriangleMesh corners(const CurvedMesh& mesh) {
  return {mesh.nodes.leftCols(mesh.vertex_count()), mesh.triangles.topRows<3>()};
}

}  // namespace sbeh::meshing
