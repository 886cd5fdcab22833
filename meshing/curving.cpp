#include "meshing/curving.h"

#include "meshing/half_edge_mesh.h"
#include "model/numerics/lagrange.h"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

namespace sbeh::meshing {

namespace {

// Nodes on each edge and inside each triangle.
int on_edge(int order) { return order - 1; }
int inside(int order) { return (order - 1) * (order - 2) / 2; }

HalfEdgeMesh closed_half_edges(const TriangleMesh& mesh) {
  HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  const int F = mesh.triangle_count(), V = mesh.point_count(), E = int(half_edges.n_edges());
  if (V - E + F != 2 || 2 * E != 3 * F)
    throw std::invalid_argument(fmt::format(
        "no closed surface of sphere topology: {} points, {} edges, {} triangles", V, E, F));
  return half_edges;
}

// The half-edge of a triangle that starts at this point.
OpenMesh::SmartHalfedgeHandle half_edge_from(OpenMesh::SmartFaceHandle face, int point) {
  OpenMesh::SmartHalfedgeHandle h = face.halfedge();
  while (h.from().idx() != point) h = h.next();
  return h;
}

}  // namespace

Eigen::MatrixXi numbered_nodes(const TriangleMesh& mesh, int order) {
  const int size = model::TriangleElement(order).size();  // throws for another order
  const HalfEdgeMesh half_edges = closed_half_edges(mesh);
  const int first_on_edge = mesh.point_count();
  const int first_inside = first_on_edge + on_edge(order) * int(half_edges.n_edges());
  Eigen::MatrixXi nodes(size, mesh.triangle_count());
  nodes.topRows<3>() = mesh.triangles;
  for (const auto face : half_edges.faces()) {
    const int t = face.idx();
    int row = 3;
    OpenMesh::SmartHalfedgeHandle h = half_edge_from(face, mesh.triangles(0, t));
    for (int side = 0; side < 3; ++side, h = h.next()) {
      // The first half-edge of the two counts upwards, its opposite downwards.
      const bool upwards = h.idx() == h.edge().h0().idx();
      for (int k = 0; k < on_edge(order); ++k)
        nodes(row++, t) = first_on_edge + on_edge(order) * h.edge().idx()
                        + (upwards ? k : on_edge(order) - 1 - k);
    }
    for (int k = 0; k < inside(order); ++k) nodes(row++, t) = first_inside + inside(order) * t + k;
  }
  return nodes;
}

CurvedMesh curved(const TriangleMesh& mesh, int order, const Projection& onto_surface) {
  return curved(mesh, order, Placement([&](int t, const Eigen::Vector3d& barycentric) {
                  const Eigen::Matrix3d corner = mesh.points(Eigen::all, mesh.triangles.col(t));
                  return onto_surface(corner * barycentric);
                }));
}

CurvedMesh curved(const TriangleMesh& mesh, int order, const Placement& place) {
  CurvedMesh result{.order = order, .triangles = numbered_nodes(mesh, order), .nodes = {}};
  const Eigen::Matrix2Xd x = model::TriangleElement(order).nodes();
  Eigen::Matrix3Xd flat(3, x.cols());  // barycentric coordinates of the nodes
  flat << Eigen::RowVectorXd::Ones(x.cols()) - x.colwise().sum(), x;

  const int V = mesh.point_count(), nodes = result.triangles.maxCoeff() + 1;
  result.nodes.resize(3, nodes);
  result.nodes.leftCols(V) = mesh.points;
  std::vector<bool> placed(std::size_t(nodes), false);
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (Eigen::Index k = 3; k < x.cols(); ++k) {
      const int node = result.triangles(k, t);
      if (placed[std::size_t(node)]) continue;
      placed[std::size_t(node)] = true;
      result.nodes.col(node) = place(t, flat.col(k));
    }
  return result;
}

TriangleMesh corners(const CurvedMesh& mesh) {
  return {mesh.nodes.leftCols(mesh.vertex_count()), mesh.triangles.topRows<3>()};
}

}  // namespace sbeh::meshing
