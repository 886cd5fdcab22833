#include "surface3d/curvature.h"

#include "model/numerics/area_volume.h"
#include "surface3d/linear/conjugate_gradient.h"
#include "surface3d/parallel.h"
#include "surface3d/point_tables.h"

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

// Integrals over a triangle.
struct Sums {
  PointTables<32>::Sums<10> mass;     // (φ_b, φ_a), row: b
  PointTables<32>::Sums<10> cosines;  // (φ_b ν, φ_a n_a), row: a
  PointTables<32>::Sums<3> normals;   // (ν, φ_a)
  /// −(∇_C x, ∇_C φ_a n_a) of each of the positions x.
  std::array<ElementField, 2> bending;
};

using Positions = std::span<const Nodes* const>;  // one or two

// (∇_C x, ∇_C φ) is gⁱʲ ∂_i x ∂_j φ.
Sums sums_on(const Triangulation& mesh, int e, const Nodes& X, const Nodes& node_normals,
             Positions positions) {
  using Tables = PointTables<32>;
  const Tables& tables = assembly_tables();
  const TrianglePoints p(tables, on_element(mesh, e, X));
  const ElementNodes n = on_element(mesh, e, node_normals);
  Sums sums;
  sums.mass = tables.against(Tables::Functions(tables.phi * p.dS.matrix().asDiagonal()));
  const Tables::Vectors weighted = p.normal * tables.weights.matrix().asDiagonal();
  sums.normals = tables.against(weighted);
  const Tables::Functions along = n.transpose().lazyProduct(weighted);
  sums.cosines = tables.against(Tables::Functions(along.cwiseProduct(tables.phi)));  // (H1)
  const Tables::Row g_11 = p.dS * p.inverse_11, g_12 = p.dS * p.inverse_12,
                    g_22 = p.dS * p.inverse_22;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const ElementNodes place = on_element(mesh, e, *positions[k]);
    const Tables::Vectors x1 = tables.slopes(place, 0), x2 = tables.slopes(place, 1);
    const Tables::Vectors first = x1 * g_11.matrix().asDiagonal() + x2 * g_12.matrix().asDiagonal(),
                          second =
                              x1 * g_12.matrix().asDiagonal() + x2 * g_22.matrix().asDiagonal();
    const Tables::Sums<3> force =
        tables.against_slopes(first, 0) + tables.against_slopes(second, 1);
    sums.bending[k] = -n.cwiseProduct(force.leftCols<10>()).colwise().sum().transpose();  // (H1)
  }
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
    for (int a = 0; a < 10; ++a) {
      auto row = rhs.row(mesh.triangles(a, e));
      row.leftCols<3>() += sums.normals.col(a).transpose();
      for (int k = 0; k < count; ++k) row[3 + k] += sums.bending[std::size_t(k)][a];
    }
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
    const Nodes place = moved(c);
    const Eigen::Array4d sum = sum_over_triangles<4>(mesh, [&](int e) {
      const auto& tables = assembly_tables();
      const TrianglePoints p(tables, on_element(mesh, e, place));
      Eigen::Array4d rates;  // of A and V
      int k = 0;
      for (const Nodes* direction : {&n, &shift}) {
        const ElementNodes W = on_element(mesh, e, *direction);
        const auto W_1 = tables.slopes(W, 0), W_2 = tables.slopes(W, 1);
        const PointTables<32>::Row mixed = (dot(p.a[0], W_2) + dot(p.a[1], W_1)) / 2;
        rates[k++] = (p.dS * p.trace(dot(p.a[0], W_1), mixed, dot(p.a[1], W_2))).sum() / area_asked;
        rates[k++] = (tables.weights * dot(tables.values(W), p.normal)).sum() / volume_asked;
      }
      return rates;
    });
    return Eigen::Map<const Eigen::Matrix2d>(sum.data());
  };
  const Target now = area_and_volume(mesh, X);
  const auto c = model::solve_area_volume(miss, slope, is_sphere(mesh, now.area, now.volume));
  if (c) X = moved(*c);
  return c.has_value();
}

}  // namespace sbeh::surface3d
