#include "surface3d/curvature.h"

#include "model/numerics/area_volume.h"
#include "surface3d/mesh_equation.h"
#include "surface3d/parallel.h"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace sbeh::surface3d {

namespace {

// Mass matrices are well conditioned: diagonally preconditioned Krylov methods solve them to rounding
// within a few dozen iterations.
constexpr double mass_tolerance = 1e-14;
constexpr int mass_iterations = 300;
constexpr double mass_accepted = 1e-11;  // rounding may keep the residual above the tolerance

constexpr double failed = std::numeric_limits<double>::quiet_NaN();

using Local = MeshEquation::Scalar;

// NaN where it fails.
Field solve_curvature(const SparseMatrix& matrix, const Field& rhs) {
  Eigen::BiCGSTAB<SparseMatrix> solver(matrix);
  solver.setTolerance(mass_tolerance);
  solver.setMaxIterations(mass_iterations);
  Field H = solver.solve(rhs);
  if (!(solver.error() < mass_accepted)) H.setConstant(failed);
  return H;
}
Field solve_mass(const SparseMatrix& matrix, const Field& rhs, const Field& guess) {
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(mass_tolerance);
  solver.setMaxIterations(mass_iterations);
  Field x = solver.solveWithGuess(rhs, guess);
  if (!(solver.error() < mass_accepted)) x.setConstant(failed);
  return x;
}

template <std::size_t N>
struct Curvatures {
  Nodes node_normals, normals;
  std::array<Field, N> H;
  bool ok() const {
    return normals.allFinite()
        && std::ranges::all_of(H, [](const Field& h) { return h.allFinite(); });
  }
};

// The normals of X and the curvatures of some positions on X, all in one loop over the triangles.
template <std::size_t N>
Curvatures<N> curvatures(const Triangulation& mesh, const Nodes& X, const Positions<N>& positions) {
  Curvatures<N> c{.node_normals = node_normals(mesh, X), .normals = Nodes(3, mesh.nodes), .H = {}};
  SparseMatrix mass = mesh.scalars.zero(), cosines = mass;
  Eigen::Matrix<double, Eigen::Dynamic, 3 + int(N)> rhs;
  rhs.setZero(mesh.nodes, 3 + int(N));
  for_each_by_colour(mesh, [&](int e) {
    const ElementNodes local = on_element(mesh, e, X);
    Local local_mass = Local::Zero();
    Eigen::Matrix<double, 10, 3 + int(N)> vectors = decltype(vectors)::Zero();
    CurvatureEquation<N> equation(mesh, e, c.node_normals, positions);
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(local, s);
      const Shapes phi(s.phi.data());
      const ElementField weighted = p.dS * phi;
      local_mass.noalias() += weighted * phi.transpose();
      vectors.template leftCols<3>().noalias() += weighted * p.nu().transpose();
      equation.add(p, phi);
    }
    vectors.template rightCols<int(N)>() = equation.rhs();
    mesh.scalars.add(e, local_mass, mass);
    mesh.scalars.add(e, equation.matrix(), cosines);
    for (int a = 0; a < 10; ++a) rhs.row(mesh.triangles(a, e)) += vectors.row(a);
  });
  if (!rhs.allFinite()) return c.normals.setConstant(failed), c;
  in_parallel(3 + int(N), [&](int k) {
    if (k < int(N))
      c.H[std::size_t(k)] = solve_curvature(cosines, rhs.col(3 + k));
    else
      c.normals.row(k - int(N)) =
          solve_mass(mass, rhs.col(k - int(N)), c.node_normals.row(k - int(N)).transpose())
              .transpose();
  });
  c.normals.colwise().normalize();
  return c;
}

}  // namespace

std::optional<Curvature> curvature_of(const Triangulation& mesh, const Nodes& X) {
  Curvatures<1> c = curvatures<1>(mesh, X, {&X});
  if (!c.ok()) return {};
  return Curvature{std::move(c.node_normals), std::move(c.normals), std::move(c.H[0])};
}

std::optional<CurvatureFrom> curvature_of(const Triangulation& mesh, const Nodes& X,
                                          const Nodes& position) {
  Curvatures<2> c = curvatures<2>(mesh, X, {&X, &position});
  if (!c.ok()) return {};
  return CurvatureFrom{{std::move(c.node_normals), std::move(c.normals), std::move(c.H[0])},
                       std::move(c.H[1])};
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
    const AreaVolume now = area_and_volume(mesh, moved(c));
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
  const AreaVolume now = area_and_volume(mesh, X);
  const auto c = model::solve_area_volume(miss, slope, is_sphere(mesh, now.area, now.volume));
  if (c) X = moved(*c);
  return c.has_value();
}

}  // namespace sbeh::surface3d
