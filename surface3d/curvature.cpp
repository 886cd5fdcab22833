#include "surface3d/curvature.h"

#include "model/numerics/area_volume.h"
#include "surface3d/linear/conjugate_gradient.h"
#include "surface3d/parallel.h"

#include <Eigen/IterativeLinearSolvers>

#include <array>
#include <limits>
#include <span>

namespace sbeh::surface3d {

namespace {

// A mass matrix, but for what ν and the node normals differ: a few dozen iterations lead to rounding, which
// may keep the residual above the tolerance. NaN where it fails.
Field solve_curvature(const SparseMatrix& matrix, const Field& rhs) {
  constexpr double tolerance = 1e-14, accepted = 1e-11;
  constexpr int most_iterations = 300;
  Eigen::BiCGSTAB<SparseMatrix> solver(matrix);
  solver.setTolerance(tolerance);
  solver.setMaxIterations(most_iterations);
  Field H = solver.solve(rhs);
  if (!(solver.error() < accepted)) H.setConstant(std::numeric_limits<double>::quiet_NaN());
  return H;
}

// Integrals over a triangle, row: test function.
struct Sums {
  using Scalar = Eigen::Matrix<double, 10, 10>;
  Scalar mass = Scalar::Zero();     // (φ_b, φ_a)
  Scalar cosines = Scalar::Zero();  // (φ_b ν, φ_a n_a)
  /// (ν, φ_a), then −(∇_C x, ∇_C φ_a n_a) of each of the positions x.
  Eigen::Matrix<double, 10, 5> rhs = Eigen::Matrix<double, 10, 5>::Zero();
};

using Positions = std::span<const Nodes* const>;  // one or two

Sums sums_on(const Triangulation& mesh, int e, const Nodes& X, const Nodes& node_normals,
             Positions positions) {
  const ElementNodes local = on_element(mesh, e, X), n = on_element(mesh, e, node_normals);
  std::array<ElementNodes, 2> places, forces;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    places[k] = on_element(mesh, e, *positions[k]);
    forces[k].setZero();
  }
  Sums sums;
  for (const ShapeValues& s : assembly_points()) {
    const SurfacePoint p = surface_point(local, s);
    const Shapes phi(s.phi.data());
    const ElementField weighted = p.dS * phi,
                       test = phi.cwiseProduct(n.transpose() * (p.dS * p.nu()));
    sums.mass.noalias() += weighted * phi.transpose();
    sums.rhs.leftCols<3>().noalias() += weighted * p.nu().transpose();
    sums.cosines.noalias() += test * phi.transpose();  // (H1)
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const Eigen::Matrix<double, 3, 2> slope = p.dS * gradient_at(places[k], p);
      for (int i = 0; i < 2; ++i)
        forces[k].noalias() -=
            slope.col(i) * Shapes(p.grad[std::size_t(i)].data()).transpose();  // (H1)
    }
  }
  for (std::size_t k = 0; k < positions.size(); ++k)
    sums.rhs.col(3 + Eigen::Index(k)) = n.cwiseProduct(forces[k]).colwise().sum().transpose();
  return sums;
}

}  // namespace

// (H1) without Y, tested with Z = φ_a n_a, is (H ν, Z) = −(∇_C x, ∇_C Z).
std::optional<Curvature> curvature_of(const Triangulation& mesh, const Nodes& X,
                                      const Nodes* from) {
  const std::array positions{&X, from};
  const int count = from ? 2 : 1;
  Curvature c{.node_normals = node_normals(mesh, X),
              .normals = Nodes::Zero(3, mesh.nodes),
              .H = Field::Zero(mesh.nodes),
              .H_from = Field::Zero(from ? mesh.nodes : 0),
              .mass = mesh.scalars.zero()};
  SparseMatrix cosines = c.mass;
  Eigen::Matrix<double, Eigen::Dynamic, 5> rhs;
  rhs.setZero(mesh.nodes, 5);
  for_each_by_colour(mesh, [&](int e) {
    const Sums sums =
        sums_on(mesh, e, X, c.node_normals, Positions(positions).first(std::size_t(count)));
    mesh.scalars.add(e, sums.mass, c.mass);
    mesh.scalars.add(e, sums.cosines, cosines);
    for (int a = 0; a < 10; ++a) rhs.row(mesh.triangles(a, e)) += sums.rhs.row(a);
  });
  sum_over_ranks(mesh, c.mass);
  sum_over_ranks(mesh, cosines);
  sum_over_ranks(mesh, rhs);
  if (!rhs.allFinite()) return {};
  in_parallel(count + 1, [&](int k) {
    constexpr std::array by{0, 2,
                            1};  // of two ranks one solves for the normals, the other for the rest
    const int rank = k == count ? by[2] : by[std::size_t(k)];
    if (rank % mesh.ranks.count() != mesh.ranks.rank()) return;
    if (k == count)
      c.normals = solve_mass(c.mass, Nodes(rhs.leftCols<3>().transpose()), c.node_normals);
    else
      (k == 0 ? c.H : c.H_from) = solve_curvature(cosines, rhs.col(3 + k));
  });
  for (Field* H : {&c.H, &c.H_from}) sum_over_ranks(mesh, *H);
  sum_over_ranks(mesh, c.normals);
  c.normals.colwise().normalize();
  if (!(c.normals.allFinite() && c.H.allFinite() && c.H_from.allFinite())) return {};
  return c;
}

double total_mean_curvature(const Triangulation& mesh, const Nodes& X, const Field& H) {
  return integrate<1>(mesh, X, diagnostic_points(), [&](int e) {
    return [H_nodes = on_element(mesh, e, H)](const ShapeValues& s, const SurfacePoint&) {
      return Eigen::Array<double, 1, 1>(value_at(H_nodes, s));
    };
  })[0];
}

model::ShapeOperator<double> shape_operator(const SurfacePoint& p, const ElementNodes& normals,
                                            double H) {
  const Eigen::Matrix2d slope = p.frame.leftCols<2>().transpose() * gradient_at(normals, p);
  model::ShapeOperator<double> B = -(slope + slope.transpose()) / 2;
  B.diagonal().array() += (H - B.trace()) / 2;
  return B;
}

bool correct_area_volume(const Triangulation& mesh, Nodes& X, double area, double volume) {
  const auto curvature = curvature_of(mesh, X);
  return curvature && correct_area_volume(mesh, X, curvature->H, area, volume);
}

bool correct_area_volume(const Triangulation& mesh, Nodes& X, const Field& H, double area_asked,
                         double volume_asked) {
  const Nodes n = node_normals(mesh, X);
  const Nodes shift = n * H.asDiagonal();
  const auto moved = [&](const Eigen::Vector2d& c) -> Nodes { return X + c[0] * n + c[1] * shift; };
  const auto miss = [&](const Eigen::Vector2d& c) -> Eigen::Vector2d {
    const Target now = area_and_volume(mesh, moved(c));
    return {now.area / area_asked - 1, now.volume / volume_asked - 1};
  };
  const auto slope = [&](const Eigen::Vector2d& c) -> Eigen::Matrix2d {
    const Eigen::Array4d sum = integrate<4>(mesh, moved(c), assembly_points(), [&](int e) {
      return [=, directions = std::array{on_element(mesh, e, n), on_element(mesh, e, shift)}](
                 const ShapeValues& s, const SurfacePoint& p) {
        Eigen::Array4d rates;  // of A and V
        int k = 0;
        for (const ElementNodes& W : directions) {
          rates[k++] = p.frame.leftCols<2>().cwiseProduct(gradient_at(W, p)).sum() / area_asked;
          rates[k++] = value_at(W, s).dot(p.nu()) / volume_asked;
        }
        return rates;
      };
    });
    return Eigen::Map<const Eigen::Matrix2d>(sum.data());
  };
  const Target now = area_and_volume(mesh, X);
  const auto c = model::solve_area_volume(miss, slope, is_sphere(mesh, now.area, now.volume));
  if (c) X = moved(*c);
  return c.has_value();
}

}  // namespace sbeh::surface3d
