#include "meshing/closest_point.h"

#include "meshing/quality.h"
#include "model/numerics/lagrange.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace sbeh::meshing {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using Monomials = Eigen::Matrix<double, 10, 1>;

Monomials monomials(const Vector2d& at) {
  const double u = at[0], v = at[1];
  Monomials m;
  m << 1, u, v, u * u, u * v, v * v, u * u * u, u * u * v, u * v * v, v * v * v;
  return m;
}

// Derivatives of the monomials: by u, v, uu, uv, vv.
Eigen::Matrix<double, 10, 5> slopes(const Vector2d& at) {
  const double u = at[0], v = at[1];
  Eigen::Matrix<double, 10, 5> d;
  d.col(0) << 0, 1, 0, 2 * u, v, 0, 3 * u * u, 2 * u * v, v * v, 0;
  d.col(1) << 0, 0, 1, 0, u, 2 * v, 0, u * u, 2 * u * v, 3 * v * v;
  d.col(2) << 0, 0, 0, 2, 0, 0, 6 * u, 2 * v, 0, 0;
  d.col(3) << 0, 0, 0, 0, 1, 0, 0, 2 * u, 2 * v, 0;
  d.col(4) << 0, 0, 0, 0, 0, 2, 0, 0, 2 * u, 6 * v;
  return d;
}

// The reference triangle: three functions >= 0 and their gradients.
const std::array<Vector2d, 3> inward{Vector2d(-1, -1), Vector2d(1, 0), Vector2d(0, 1)};
std::array<double, 3> inside(const Vector2d& at) { return {1 - at[0] - at[1], at[0], at[1]}; }
bool on_boundary(const Vector2d& at) {
  constexpr double rounding = 1e-12;
  const auto c = inside(at);
  return *std::min_element(c.begin(), c.end()) < rounding;
}

// The step of Newton's method where it may go: along a side that it would leave through, nowhere
// from a corner that it would leave.
Vector2d allowed_step(const Vector2d& at, const Vector2d& gradient, const Matrix2d& hessian) {
  constexpr double rounding = 1e-15;
  const auto leaves = [&](const Vector2d& step, std::size_t side) {
    return inside(at)[side] <= rounding && inward[side].dot(step) < 0;
  };
  const Vector2d step = -hessian.inverse() * gradient;
  for (std::size_t side = 0; side < 3; ++side) {
    if (!leaves(step, side)) continue;
    const Vector2d along(-inward[side][1], inward[side][0]);
    const Vector2d sideways = -along * (along.dot(gradient) / along.dot(hessian * along));
    for (const std::size_t other : {(side + 1) % 3, (side + 2) % 3})
      if (leaves(sideways, other)) return Vector2d::Zero();
    return sideways;
  }
  return step;
}

// The part of the step up to the boundary.
double longest_way(const Vector2d& at, const Vector2d& step) {
  double way = 1;
  for (std::size_t side = 0; side < 3; ++side) {
    const double change = inward[side].dot(step);
    if (change < 0) way = std::min(way, std::max(inside(at)[side], 0.) / -change);
  }
  return way;
}

// Rounding must not keep a point off the side that it has reached.
Vector2d snapped(Vector2d at) {
  constexpr double rounding = 1e-15;
  for (int k = 0; k < 2; ++k)
    if (at[k] < rounding) at[k] = 0;
  if (inside(at)[0] < rounding) at[0] = 1 - at[1];
  return at;
}

std::vector<std::vector<int>> neighbours(const CurvedMesh& mesh) {
  std::vector<std::vector<int>> at_corner(std::size_t(mesh.vertex_count()));
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) at_corner[std::size_t(mesh.triangles(k, t))].push_back(t);
  std::vector<std::vector<int>> around(std::size_t(mesh.triangle_count()));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    auto& list = around[std::size_t(t)];
    for (int k = 0; k < 3; ++k)
      for (const int other : at_corner[std::size_t(mesh.triangles(k, t))])
        if (other != t) list.push_back(other);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return around;
}

}  // namespace

ClosestPoint::ClosestPoint(const CurvedMesh& mesh)
    : mesh_(mesh), around_(neighbours(mesh)), nearest_(nearest_triangle(lattice(mesh))) {
  const Eigen::Matrix2Xd nodes = model::TriangleElement(mesh.order).nodes();
  const Eigen::Index size = nodes.cols();
  Eigen::MatrixXd at_nodes(size, size);
  for (Eigen::Index a = 0; a < size; ++a)
    at_nodes.row(a) = monomials(nodes.col(a)).head(size).transpose();
  to_monomials_.setZero();
  to_monomials_.topLeftCorner(size, size) = at_nodes.inverse();
  for (const auto t : mesh.triangles.colwise())
    polynomial_.emplace_back(mesh.nodes(Eigen::all, t) * to_monomials_.leftCols(size).transpose());
}

ClosestPoint::Found ClosestPoint::on_triangle(int triangle, const Vector2d& start,
                                              const Vector3d& x) const {
  constexpr int iterations = 40, halvings = 10;
  constexpr double rounding = 1e-14;
  const auto& X = polynomial_[std::size_t(triangle)];
  const auto distance = [&](const Vector2d& at) { return (X * monomials(at) - x).norm(); };
  Vector2d at = snapped(start);
  double now = distance(at);
  for (int i = 0; i < iterations; ++i) {
    const Eigen::Matrix<double, 3, 5> d = X * slopes(at);
    const Vector3d miss = X * monomials(at) - x;
    const Eigen::Matrix<double, 3, 2> tangents = d.leftCols<2>();
    const Matrix2d metric = tangents.transpose() * tangents;
    Matrix2d hessian = metric;
    hessian(0, 0) += miss.dot(d.col(2));
    hessian(0, 1) += miss.dot(d.col(3));
    hessian(1, 0) = hessian(0, 1);
    hessian(1, 1) += miss.dot(d.col(4));
    if (!(hessian.determinant() > 0.1 * metric.determinant() && hessian.trace() > 0))
      hessian = metric;
    Vector2d step = allowed_step(at, tangents.transpose() * miss, hessian);
    step *= longest_way(at, step);
    if (!(step.norm() > rounding)) break;
    int halved = 0;
    while (!(distance(at + step) <= now) && ++halved < halvings) step /= 2;
    if (halved == halvings) break;
    at = snapped(at + step);
    now = distance(at);
  }
  return {{triangle, at}, now};
}

Vector2d ClosestPoint::nearest_node(int triangle, const Vector3d& x) const {
  const Eigen::Matrix2Xd nodes = model::TriangleElement(mesh_.order).nodes();
  const Eigen::Matrix3Xd X = mesh_.nodes(Eigen::all, mesh_.triangles.col(triangle));
  Eigen::Index best = 0;
  (X.colwise() - x).colwise().squaredNorm().minCoeff(&best);
  return nodes.col(best);
}

SurfacePlace ClosestPoint::operator()(const Vector3d& x) const {
  const int parts = mesh_.order * mesh_.order;
  const TrianglePlace near = nearest_(x);
  const int triangle = near.triangle / parts;
  const Eigen::Matrix<double, 2, 3> corners =
      model::TriangleElement(mesh_.order)
          .nodes()(Eigen::all, small_triangles(mesh_.order)[std::size_t(near.triangle % parts)]);
  Found best = on_triangle(triangle, corners * near.barycentric, x);
  if (on_boundary(best.place.at))
    for (const int other : around_[std::size_t(triangle)]) {
      const Found found = on_triangle(other, nearest_node(other, x), x);
      if (found.distance < best.distance) best = found;
    }
  return best.place;
}

Vector3d ClosestPoint::point(const SurfacePlace& place) const {
  return polynomial_[std::size_t(place.triangle)] * monomials(place.at);
}

double ClosestPoint::value(const Eigen::VectorXd& field, const SurfacePlace& place) const {
  const auto nodes = mesh_.triangles.col(place.triangle);
  const Eigen::VectorXd shapes =
      to_monomials_.leftCols(nodes.size()).transpose() * monomials(place.at);
  return shapes.dot(field(nodes));
}

Projection onto(std::shared_ptr<const ClosestPoint> surface) {
  return [surface](const Vector3d& x) { return surface->point((*surface)(x)); };
}

}  // namespace sbeh::meshing
