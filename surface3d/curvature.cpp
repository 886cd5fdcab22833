#include "surface3d/curvature.h"

#include "model/numerics/area_volume.h"
#include "surface3d/parallel.h"

#include <Eigen/IterativeLinearSolvers>

#include <limits>

namespace sbeh::surface3d {

namespace {

// Mass matrices are well conditioned: diagonally preconditioned Krylov methods solve them to rounding
// within a few dozen iterations.
constexpr double mass_tolerance = 1e-14;
constexpr int mass_iterations = 300;
constexpr double mass_accepted = 1e-11;  // rounding may keep the residual above the tolerance

}  // namespace

Field mean_curvature(const Triangulation& mesh, const Nodes& X, const Nodes& n) {
  return mean_curvature(mesh, X, n, X);
}

Field mean_curvature(const Triangulation& mesh, const Nodes& X, const Nodes& n,
                     const Nodes& position) {
  using System = ScalarSystem<1>;
  const System system(mesh, [&](int e, System::Matrix& matrix, System::Vectors& vector) {
    const ElementNodes local = on_element(mesh, e, X), local_n = on_element(mesh, e, n),
                       local_position = on_element(mesh, e, position);
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
  });
  if (!system.rhs.allFinite()) return {};
  Eigen::BiCGSTAB<SparseMatrix> solver(system.matrix);
  solver.setTolerance(mass_tolerance);
  solver.setMaxIterations(mass_iterations);
  Field H = solver.solve(system.rhs);
  if (!H.allFinite() || !(solver.error() < mass_accepted)) return {};
  return H;
}

Nodes projected_normals(const Triangulation& mesh, const Nodes& X) {
  using System = ScalarSystem<3>;
  const System system(mesh, [&](int e, System::Matrix& matrix, System::Vectors& vectors) {
    const ElementNodes local = on_element(mesh, e, X);
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(local, s);
      const Shapes phi(s.phi.data());
      matrix += (p.dS * phi) * phi.transpose();
      vectors += (p.dS * phi) * p.nu().transpose();
    }
  });
  if (!system.rhs.allFinite()) return {};
  const Nodes guess = node_normals(mesh, X);
  Nodes n(3, mesh.nodes);
  in_parallel(3, [&](int k) {
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(system.matrix);
    solver.setTolerance(mass_tolerance);
    solver.setMaxIterations(mass_iterations);
    n.row(k) = solver.solveWithGuess(system.rhs.col(k), guess.row(k).transpose()).transpose();
    if (!(solver.error() < mass_accepted)) n(k, 0) = std::numeric_limits<double>::quiet_NaN();
  });
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
    const AreaVolume now = area_and_volume(mesh, moved(c));
    return {now.area / area_asked - 1, now.volume / volume_asked - 1};
  };
  const auto slope = [&](const Eigen::Vector2d& c) -> Eigen::Matrix2d {
    const Eigen::Array4d sum = integrate<4>(
        mesh, moved(c), assembly_points(), [&](int e, const ShapeValues& s, const SurfacePoint& p) {
          Eigen::Array4d rates;  // of A and V
          int k = 0;
          for (const Nodes* direction : {&n, &shift}) {
            const ElementNodes W = on_element(mesh, e, *direction);
            rates[k++] = p.frame.leftCols<2>().cwiseProduct(gradient_at(W, p)).sum() / area_asked;
            rates[k++] = value_at(W, s).dot(p.nu()) / volume_asked;
          }
          return rates;
        });
    return Eigen::Map<const Eigen::Matrix2d>(sum.data());
  };
  const AreaVolume now = area_and_volume(mesh, X);
  const auto c = model::solve_area_volume(miss, slope, is_sphere(mesh, now.area, now.volume));
  if (c) X = moved(*c);
  return c.has_value();
}

}  // namespace sbeh::surface3d
