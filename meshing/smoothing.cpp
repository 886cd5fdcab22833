#include "meshing/smoothing.h"

#include "meshing/half_edge_mesh.h"
#include "meshing/icosphere.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace sbeh::meshing {

namespace {

using Eigen::Vector3d;

// One Jacobi sweep.
void move_points(HalfEdgeMesh& mesh, const Projection& onto_surface, const SizeField& size) {
  const Eigen::Index count = Eigen::Index(mesh.n_vertices());
  Eigen::Matrix3Xd centre = Eigen::Matrix3Xd::Zero(3, count), normal = centre;
  Eigen::VectorXd total = Eigen::VectorXd::Zero(count);
  for (const auto face : mesh.faces()) {
    std::array<OpenMesh::SmartVertexHandle, 3> c;
    std::size_t k = 0;
    for (const auto vertex : face.vertices()) c[k++] = vertex;
    const Vector3d a = point(mesh, c[0]), b = point(mesh, c[1]), d = point(mesh, c[2]);
    const Vector3d twice_area = (b - a).cross(d - a), centroid = (a + b + d) / 3;
    double weight = twice_area.norm();
    if (size) weight /= std::pow(size(centroid), 4);
    for (const auto vertex : c) {
      centre.col(vertex.idx()) += weight * centroid;
      total[vertex.idx()] += weight;
      normal.col(vertex.idx()) += twice_area;
    }
  }
  for (const auto vertex : mesh.vertices()) {
    const int i = vertex.idx();
    const Vector3d x = point(mesh, vertex), n = normal.col(i).normalized();
    const Vector3d way = centre.col(i) / total[i] - x;
    set_point(mesh, vertex, onto_surface(x + way - way.dot(n) * n));
  }
}

// Cotangent of the angle at `tip` in the triangle with the corners a, b.
double cotangent(const Vector3d& tip, const Vector3d& a, const Vector3d& b) {
  const Vector3d u = a - tip, v = b - tip;
  return u.dot(v) / u.cross(v).norm();
}

// The edge ab between the triangles abc and bad should rather be cd: the angles at c and d sum to
// more than π, and the new triangles face the way of the old ones.
bool should_flip(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  constexpr double tie = 1e-6;  // edges of equal right to exist stay
  if (cotangent(c, a, b) + cotangent(d, a, b) > -tie) return false;
  const Vector3d outward = (b - a).cross(c - a) + (d - a).cross(b - a);
  return (d - c).cross(b - c).dot(outward) > 0 && (a - c).cross(d - c).dot(outward) > 0;
}

int flip_edges(HalfEdgeMesh& mesh) {
  int flips = 0;
  for (const auto edge : mesh.edges()) {
    const auto h = edge.h0();
    const auto c = h.next().to(), d = h.opp().next().to();
    if (!should_flip(point(mesh, h.from()), point(mesh, h.to()), point(mesh, c), point(mesh, d)))
      continue;
    if (h.from().valence() < 4 || h.to().valence() < 4 || !mesh.is_flip_ok(edge)) continue;
    mesh.flip(edge);
    ++flips;
  }
  return flips;
}

}  // namespace

void smooth(TriangleMesh& mesh, const Projection& onto_surface, const SizeField& size, int sweeps) {
  constexpr int flip_passes = 10;  // they end by themselves long before, except for rounding
  HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    move_points(half_edges, onto_surface, size);
    for (int pass = 0; pass < flip_passes && flip_edges(half_edges) > 0; ++pass) {
    }
  }
  mesh = triangle_mesh(half_edges);
}

TriangleMesh refined(TriangleMesh mesh, int times, const Projection& onto_surface,
                     const SizeField& size, int sweeps) {
  for (int level = 0;; ++level) {
    for (int i = 0; i < mesh.point_count(); ++i)
      mesh.points.col(i) = onto_surface(mesh.points.col(i));
    smooth(mesh, onto_surface, size, sweeps);
    if (level == times) return mesh;
    mesh = subdivided(mesh);
  }
}

}  // namespace sbeh::meshing
