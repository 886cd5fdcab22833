#include "meshing/smoothing.h"

#include "meshing/edge_orbits.h"
#include "meshing/half_edge_mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace sbeh::meshing {

namespace {

using Eigen::Vector3d;

// Corners and area vector of a triangle.
struct Face {
  std::array<int, 3> corner;
  std::array<Vector3d, 3> x;
  Vector3d area;  // times the outward normal
};

template <class Visit>
void for_each_face(const HalfEdgeMesh& mesh, Visit&& visit) {
  Face f;
  for (const auto face : mesh.faces()) {
    std::size_t k = 0;
    for (const auto vertex : face.vertices()) {
      f.corner[k] = vertex.idx();
      f.x[k++] = point(mesh, vertex);
    }
    f.area = (f.x[1] - f.x[0]).cross(f.x[2] - f.x[0]) / 2;
    visit(f);
  }
}

// Neighbours may differ in size by little: triangles stay nearly equilateral.
void limit_growth(const HalfEdgeMesh& mesh, Eigen::VectorXd& size) {
  constexpr double growth = 1.1;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto edge : mesh.edges()) {
      double &a = size[edge.v0().idx()], &b = size[edge.v1().idx()];
      if (a > growth * b || b > growth * a) {
        (a > b ? a : b) = growth * std::min(a, b);
        changed = true;
      }
    }
  }
}

// |H| is the length of the area's gradient per area.
Eigen::VectorXd sizes_by_curvature(const HalfEdgeMesh& mesh, double grading) {
  const Eigen::Index count = Eigen::Index(mesh.n_vertices());
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, count);
  Eigen::VectorXd share = Eigen::VectorXd::Zero(count);
  for_each_face(mesh, [&](const Face& f) {
    const Vector3d n = f.area.normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      gradient.col(f.corner[k]) += n.cross(f.x[(k + 2) % 3] - f.x[(k + 1) % 3]) / 2;
      share[f.corner[k]] += f.area.norm() / 3;
    }
  });
  const double R = std::sqrt(share.sum() / (4 * std::numbers::pi));
  const Eigen::ArrayXd H = gradient.colwise().norm().transpose().cwiseQuotient(share);
  Eigen::VectorXd size = 1 / (1 + grading * R * H / 2);
  limit_growth(mesh, size);
  return size;
}

// Wanted edge lengths at the vertices.
Eigen::VectorXd wanted_sizes(const HalfEdgeMesh& mesh, const Smoothing& aim) {
  Eigen::VectorXd size = Eigen::VectorXd::Ones(Eigen::Index(mesh.n_vertices()));
  if (aim.size)
    for (const auto vertex : mesh.vertices()) size[vertex.idx()] = aim.size(point(mesh, vertex));
  else if (aim.grading > 0)
    size = sizes_by_curvature(mesh, aim.grading);
  return size;
}

// One Jacobi sweep.
void move_points(HalfEdgeMesh& mesh, const Projection& onto_surface, const Smoothing& aim) {
  const Eigen::Index count = Eigen::Index(mesh.n_vertices());
  const Eigen::VectorXd size = wanted_sizes(mesh, aim);
  Eigen::Matrix3Xd centre = Eigen::Matrix3Xd::Zero(3, count), normal = centre;
  Eigen::VectorXd total = Eigen::VectorXd::Zero(count);
  for_each_face(mesh, [&](const Face& f) {
    const auto [i, j, k] = f.corner;
    const double mean_size = (size[i] + size[j] + size[k]) / 3;
    const double weight = std::pow(f.area.norm() / std::pow(mean_size, 4), aim.evenness);
    const Vector3d centroid = (f.x[0] + f.x[1] + f.x[2]) / 3;
    for (const int vertex : f.corner) {
      centre.col(vertex) += weight * centroid;
      total[vertex] += weight;
      normal.col(vertex) += f.area;
    }
  });
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

int flip_edges(HalfEdgeMesh& mesh, const MeshSymmetry& symmetry) {
  int flips = 0;
  for (const SmartEdge edge : mesh.edges()) {
    const auto h = edge.h0();
    const auto c = h.next().to(), d = h.opp().next().to();
    if (!should_flip(point(mesh, h.from()), point(mesh, h.to()), point(mesh, c), point(mesh, d)))
      continue;
    const std::vector<SmartEdge> orbit = orbit_of(mesh, edge, symmetry);
    if (!may_flip(mesh, orbit)) continue;
    for (const SmartEdge other : orbit) mesh.flip(other);
    flips += int(orbit.size());
  }
  return flips;
}

void take_symmetric_part(HalfEdgeMesh& mesh, const MeshSymmetry& symmetry) {
  Eigen::Matrix3Xd points(3, Eigen::Index(mesh.n_vertices()));
  for (const auto vertex : mesh.vertices()) points.col(vertex.idx()) = point(mesh, vertex);
  points = symmetry.symmetric_part(points);
  for (const auto vertex : mesh.vertices()) set_point(mesh, vertex, points.col(vertex.idx()));
}

}  // namespace

void project(TriangleMesh& mesh, const Projection& onto_surface) {
  for (int i = 0; i < mesh.point_count(); ++i)
    mesh.points.col(i) = onto_surface(mesh.points.col(i));
}

void smooth(TriangleMesh& mesh, const Projection& onto_surface, const Smoothing& aim, int sweeps) {
  constexpr int flip_passes = 10;  // they end by themselves long before, except for rounding
  const MeshSymmetry symmetry =
      symmetry_of_triangles(mesh, aim.symmetry);  // points keep their numbers
  HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    move_points(half_edges, onto_surface, aim);
    if (!aim.symmetry.is_trivial()) take_symmetric_part(half_edges, symmetry);
    for (int pass = 0; pass < flip_passes && flip_edges(half_edges, symmetry) > 0; ++pass) {
    }
  }
  mesh = triangle_mesh(half_edges);
}

double min_angle(const TriangleMesh& mesh) {
  double steepest = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      steepest = std::max(steepest, cotangent(mesh.points.col(mesh.triangles(k, t)),
                                              mesh.points.col(mesh.triangles((k + 1) % 3, t)),
                                              mesh.points.col(mesh.triangles((k + 2) % 3, t))));
  return std::atan2(1, steepest) * 180 / std::numbers::pi;
}

}  // namespace sbeh::meshing
