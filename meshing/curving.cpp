#include "meshing/curving.h"

#include "meshing/half_edge_mesh.h"
#include "meshing/measures.h"
#include "model/numerics/lagrange.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <array>
#include <cassert>
#include <stdexcept>
#include <vector>

namespace sbeh::meshing {

using Eigen::Vector3d;

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

namespace {

/// The point at s in [0, 1] along a side of a triangle, on the surface.
using AlongSide = std::function<Vector3d(int triangle, int side, double s)>;
/// The interior node of a triangle whose other nodes are placed, 3 x 9.
using Inside = std::function<Vector3d(int triangle, const Eigen::Matrix3Xd& others)>;

// Points that divide a curve into `parts` of equal length, without its ends.
std::vector<Vector3d> divide(const std::function<Vector3d(double)>& curve, int parts) {
  constexpr int chords = 9;  // by which lengths are measured
  std::array<Vector3d, chords + 1> x;
  std::array<double, chords + 1> length{};
  for (int k = 0; k <= chords; ++k) {
    x[std::size_t(k)] = curve(double(k) / chords);
    if (k > 0)
      length[std::size_t(k)] =
          length[std::size_t(k - 1)] + (x[std::size_t(k)] - x[std::size_t(k - 1)]).norm();
  }
  std::vector<Vector3d> points;
  for (int part = 1, k = 1; part < parts; ++part) {
    const double wanted = length.back() * part / parts;
    while (length[std::size_t(k)] < wanted && k < chords) ++k;
    const double before = length[std::size_t(k - 1)], after = length[std::size_t(k)];
    points.push_back(curve((k - 1 + (wanted - before) / (after - before)) / chords));
  }
  return points;
}

CurvedMesh with_nodes(const TriangleMesh& mesh, int order, const AlongSide& along_side,
                      const Inside& inside_of) {
  CurvedMesh result{.order = order, .triangles = numbered_nodes(mesh, order), .nodes = {}};
  const int V = mesh.point_count(), nodes = result.triangles.maxCoeff() + 1;
  result.nodes.resize(3, nodes);
  result.nodes.leftCols(V) = mesh.points;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int side = 0; side < 3 && order > 1; ++side) {
      const int from = mesh.triangles(side, t), to = mesh.triangles((side + 1) % 3, t);
      if (from > to) continue;  // the neighbour does it
      const auto points = divide([&](double s) { return along_side(t, side, s); }, order);
      for (int k = 0; k < on_edge(order); ++k)
        result.nodes.col(result.triangles(3 + on_edge(order) * side + k, t)) =
            points[std::size_t(k)];
    }
  for (int t = 0; t < mesh.triangle_count() && inside(order) > 0; ++t) {
    const Eigen::VectorXi others = result.triangles.col(t).head<9>();
    result.nodes.col(result.triangles(9, t)) = inside_of(t, result.nodes(Eigen::all, others));
  }
  return result;
}

// The point of the surface over `foot` in the direction n: a projection that has another direction,
// such as a radial one, is asked again from where it went astray.
Vector3d over(const Vector3d& foot, const Vector3d& n, const Projection& onto_surface) {
  constexpr int corrections = 8;
  const auto astray = [&](const Vector3d& y) { return Vector3d(y - foot - (y - foot).dot(n) * n); };
  Vector3d x = foot, y = onto_surface(x), miss = astray(y);
  for (int i = 0; i < corrections; ++i) {
    const Vector3d next_x = x - miss, next = onto_surface(next_x), next_miss = astray(next);
    if (!(next_miss.norm() < miss.norm())) break;  // rounding, or too coarse to see the surface
    x = next_x;
    y = next;
    miss = next_miss;
  }
  return y;
}

}  // namespace

CurvedMesh curved(const TriangleMesh& mesh, int order, const Projection& onto_surface) {
  const Eigen::Matrix3Xd normals = point_normals(mesh);
  const auto along_side = [&](int t, int side, double s) -> Vector3d {
    const int from = mesh.triangles(side, t), to = mesh.triangles((side + 1) % 3, t);
    const Vector3d n = normals.col(from) + normals.col(to);
    return over((1 - s) * mesh.points.col(from) + s * mesh.points.col(to), n.normalized(),
                onto_surface);
  };
  // Where a cubic would have it that is a quadratic inside.
  const auto inside_of = [&](int t, const Eigen::Matrix3Xd& X) -> Vector3d {
    const Vector3d n = normals(Eigen::all, mesh.triangles.col(t)).rowwise().sum();
    return over(X.rightCols<6>().rowwise().sum() / 4 - X.leftCols<3>().rowwise().sum() / 6,
                n.normalized(), onto_surface);
  };
  return with_nodes(mesh, order, along_side, inside_of);
}

CurvedMesh curved(const TriangleMesh& mesh, int order, const Placement& place) {
  const auto along_side = [&](int t, int side, double s) -> Vector3d {
    Vector3d barycentric = Vector3d::Zero();
    barycentric[side] = 1 - s;
    barycentric[(side + 1) % 3] = s;
    return place(t, barycentric);
  };
  const auto inside_of = [&](int t, const Eigen::Matrix3Xd&) -> Vector3d {
    return place(t, Vector3d::Constant(1. / 3));
  };
  return with_nodes(mesh, order, along_side, inside_of);
}

CurvedMesh of_order(const CurvedMesh& mesh, int order) {
  assert(order >= mesh.order);
  if (order == mesh.order) return mesh;
  CurvedMesh result{.order = order, .triangles = numbered_nodes(corners(mesh), order), .nodes = {}};
  result.nodes.resize(3, result.triangles.maxCoeff() + 1);
  const model::TriangleElement element(mesh.order), finer(order);
  const Eigen::Matrix2Xd places = finer.nodes();
  for (Eigen::Index k = 0; k < places.cols(); ++k) {
    const Eigen::VectorXd phi = element.values(places.col(k));
    for (int t = 0; t < mesh.triangle_count(); ++t)
      result.nodes.col(result.triangles(k, t)) =
          mesh.nodes(Eigen::all, mesh.triangles.col(t)) * phi;
  }
  result.nodes.leftCols(mesh.vertex_count()) = mesh.nodes.leftCols(mesh.vertex_count());
  return result;
}

TriangleMesh corners(const CurvedMesh& mesh) {
  return {mesh.nodes.leftCols(mesh.vertex_count()), mesh.triangles.topRows<3>()};
}

}  // namespace sbeh::meshing
