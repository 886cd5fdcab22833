#include "surface3d/curvature.h"

#include "model/numerics/area_volume.h"

#include <Eigen/IterativeLinearSolvers>

#include <cmath>

namespace sbeh::surface3d {

namespace {

// Mass matrices are well conditioned: diagonally preconditioned Krylov methods solve them to rounding
// within a few dozen iterations.
constexpr double mass_tolerance = 1e-14;
constexpr int mass_iterations = 300;
constexpr double mass_accepted = 1e-11;  // rounding may keep the residual above the tolerance

using ElementMass = Eigen::Matrix<double, 10, 10>;

}  // namespace

Field mean_curvature(const Triangulation& mesh, const Nodes& X, const Nodes& n) {
  return mean_curvature(mesh, X, n, X);
}

Field mean_curvature(const Triangulation& mesh, const Nodes& X, const Nodes& n,
                     const Nodes& position) {
  SparseMatrix mass = mesh.scalars.zero();
  Field rhs = Field::Zero(mesh.nodes);
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X), local_n = on_element(mesh, e, n),
                       local_position = on_element(mesh, e, position);
    ElementMass matrix = ElementMass::Zero();
    ElementField vector = ElementField::Zero();
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(local, s);
      const Shapes phi(s.phi.data());
      const ElementField cosine = local_n.transpose() * p.nu();
      matrix += (p.dS * phi.cwiseProduct(cosine)) * phi.transpose();
      const Eigen::Matrix<double, 3, 2> slope = gradient_at(local_position, p);
      for (int k = 0; k < 2; ++k)
        vector -= p.dS
                * Shapes(p.grad[std::size_t(k)].data())
                      .cwiseProduct(local_n.transpose() * slope.col(k));
    }
    mesh.scalars.add(e, matrix, mass);
    mesh.scalars.add(e, vector, rhs);
  }
  if (!rhs.allFinite()) return {};
  Eigen::BiCGSTAB<SparseMatrix> solver(mass);
  solver.setTolerance(mass_tolerance);
  solver.setMaxIterations(mass_iterations);
  Field H = solver.solve(rhs);
  if (!H.allFinite() || !(solver.error() < mass_accepted)) return {};
  return H;
}

Nodes projected_normals(const Triangulation& mesh, const Nodes& X) {
  SparseMatrix mass = mesh.scalars.zero();
  Eigen::MatrixX3d rhs = Eigen::MatrixX3d::Zero(mesh.nodes, 3);
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    ElementMass matrix = ElementMass::Zero();
    ElementNodes vector = ElementNodes::Zero();
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(local, s);
      const Shapes phi(s.phi.data());
      matrix += (p.dS * phi) * phi.transpose();
      vector += p.nu() * (p.dS * phi).transpose();
    }
    mesh.scalars.add(e, matrix, mass);
    for (int a = 0; a < 10; ++a) rhs.row(mesh.triangles(a, e)) += vector.col(a).transpose();
  }
  if (!rhs.allFinite()) return {};
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(mass);
  solver.setTolerance(mass_tolerance);
  solver.setMaxIterations(mass_iterations);
  Nodes n(3, mesh.nodes);
  for (int k = 0; k < 3; ++k) {
    n.row(k) = solver.solve(rhs.col(k)).transpose();
    if (!(solver.error() < mass_accepted)) return {};
  }
  n.colwise().normalize();
  if (!n.allFinite()) return {};
  return n;
}

std::optional<Curvature> curvature_of(const Triangulation& mesh, const Nodes& X) {
  Curvature c{
      .node_normals = node_normals(mesh, X), .normals = projected_normals(mesh, X), .H = {}};
  c.H = mean_curvature(mesh, X, c.node_normals);
  if (c.normals.size() == 0 || c.H.size() == 0) return {};
  return c;
}

model::ShapeOperator<double> shape_operator(const SurfacePoint& p, const ElementNodes& normals,
                                            double H) {
  const Eigen::Matrix2d slope = p.frame.leftCols<2>().transpose() * gradient_at(normals, p);
  model::ShapeOperator<double> B = -(slope + slope.transpose()) / 2;
  B.diagonal().array() += (H - B.trace()) / 2;
  return B;
}

bool correct_area_volume(const Triangulation& mesh, Nodes& X, double area_asked,
                         double volume_asked) {
  const Nodes n = node_normals(mesh, X);
  const Field H = mean_curvature(mesh, X, n);
  if (H.size() == 0) return false;
  const Nodes shift = n * H.asDiagonal();
  const auto moved = [&](const Eigen::Vector2d& c) -> Nodes { return X + c[0] * n + c[1] * shift; };
  const auto miss = [&](const Eigen::Vector2d& c) -> Eigen::Vector2d {
    const Nodes Y = moved(c);
    return {area(mesh, Y) / area_asked - 1, volume(mesh, Y) / volume_asked - 1};
  };
  const auto slope = [&](const Eigen::Vector2d& c) -> Eigen::Matrix2d {
    const Nodes Y = moved(c);
    Eigen::Matrix2d J = Eigen::Matrix2d::Zero();
    for_each_point(
        mesh, Y, diagnostic_points(), [&](int e, const ShapeValues& s, const SurfacePoint& p) {
          int k = 0;
          for (const Nodes* direction : {&n, &shift}) {
            const ElementNodes W = on_element(mesh, e, *direction);
            const double divergence = p.frame.leftCols<2>().cwiseProduct(gradient_at(W, p)).sum();
            J.col(k++) += p.dS
                        * Eigen::Vector2d(divergence / area_asked,
                                          value_at(W, s).dot(p.nu()) / volume_asked);
          }
        });
    return J;
  };
  const auto c =
      model::solve_area_volume(miss, slope, is_sphere(mesh, area(mesh, X), volume(mesh, X)));
  if (c) X = moved(*c);
  return c.has_value();
}

}  // namespace sbeh::surface3d
