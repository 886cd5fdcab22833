// The discrete curvature of spheres and ellipsoids against closed forms, under refinement.
#include "surface3d/curvature.h"

#include "model/energy_density.h"
#include "surface3d/diagnostics.h"
#include "tests/surface3d/cases.h"

#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

// The ellipsoid with these semi-axes; its formulas hold near it as well, where the level set
// x·Dx = const, D = diag(1/a²), through the point is meant.
struct Quadric {
  Eigen::Vector3d axes;
  Eigen::Matrix3d D() const { return axes.cwiseAbs2().cwiseInverse().asDiagonal(); }
  Eigen::Vector3d normal(const Eigen::Vector3d& x) const { return (D() * x).normalized(); }
  Eigen::Matrix3d B(const Eigen::Vector3d& x) const {  // −∇n, Cartesian
    const Eigen::Vector3d n = normal(x);
    const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - n * n.transpose();
    return -P * D() * P / (D() * x).norm();
  }
};

// Errors in the L2 norm, and what is integrated.
struct Errors {
  double H = 0, normal = 0, B = 0, total_gauss = 0, willmore = 0;
};
Errors errors_of(const Quadric& exact, int triangles) {
  const Surface s = surface_of(meshing::ellipsoid(exact.axes, {.triangles = triangles}));
  const auto curvature = curvature_of(*s.mesh, s.state.X);
  EXPECT_TRUE(curvature.has_value());
  Errors sum;
  for_each_point(*s.mesh, s.state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& v, const SurfacePoint& p) {
                   const double H = value_at(on_element(*s.mesh, e, curvature->H), v);
                   const ElementNodes normals = on_element(*s.mesh, e, curvature->normals);
                   const auto B = shape_operator(p, normals, H);
                   EXPECT_NEAR(B.trace(), H, 1e-12);
                   EXPECT_NEAR(B(0, 1), B(1, 0), 1e-12);
                   const Eigen::Matrix3d exact_B = exact.B(p.x);
                   const auto tangents = p.frame.leftCols<2>();
                   sum.H += p.dS * std::pow(H - exact_B.trace(), 2);
                   sum.normal += p.dS * (value_at(normals, v) - exact.normal(p.x)).squaredNorm();
                   sum.B += p.dS * (tangents * B * tangents.transpose() - exact_B).squaredNorm();
                   sum.total_gauss += p.dS * model::gauss_curvature(B);
                   sum.willmore += p.dS * H * H;
                 });
  sum.H = std::sqrt(sum.H);
  sum.normal = std::sqrt(sum.normal);
  sum.B = std::sqrt(sum.B);
  return sum;
}

// ∫ H² over a spheroid with semi-axes a, a, c, by its closed curvatures and a quadrature that
// converges exponentially.
double spheroid_willmore(double a, double c) {
  const Quadric exact{{a, a, c}};
  constexpr int points = 200;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double theta = pi * (k + 0.5) / points, s = std::sin(theta), z = std::cos(theta);
    const double H = exact.B({a * s, 0, c * z}).trace();
    sum += H * H * 2 * pi * a * s * std::hypot(a * z, c * s) * pi / points;
  }
  // The midpoint rule errs by (π/points)²/24 times the jump of the derivative: one Richardson step.
  double half = 0;
  for (int k = 0; k < points / 2; ++k) {
    const double theta = 2 * pi * (k + 0.5) / points, s = std::sin(theta), z = std::cos(theta);
    const double H = exact.B({a * s, 0, c * z}).trace();
    half += H * H * 2 * pi * a * s * std::hypot(a * z, c * s) * 2 * pi / points;
  }
  return (4 * sum - half) / 3;
}

void expect_orders(const Quadric& exact, const std::vector<int>& triangles, double willmore) {
  OrderTable H("mean curvature, L2", "h"), n("  projected normals, L2", "h"),
      B("  shape operator, L2", "h"), K("  total Gauss curvature", "h"), W("  integral of H²", "h");
  for (const int count : triangles) {
    const Errors error = errors_of(exact, count);
    const double h = 1 / std::sqrt(count);
    H.add(h, error.H);
    n.add(h, error.normal);
    B.add(h, error.B);
    K.add(h, error.total_gauss - 4 * pi);
    W.add(h, error.willmore - willmore);
  }
  // Nodes on the surface miss it by O(h⁴) in between, in a pattern of the mesh: two derivatives are
  // lost in H, one in the normals. Integrals see the error of the surface itself.
  EXPECT_NEAR(H.print(), 2, 0.1);
  EXPECT_GT(n.print(), 2.9);
  EXPECT_NEAR(B.print(), 2, 0.1);
  K.print();
  double all = 0;  // over all rows: the error may change its sign
  for (const double order : K.orders()) all += order / double(K.orders().size());
  EXPECT_GT(all, 3.5);
  EXPECT_NEAR(W.print(), 4, 0.1);
}

TEST(Curvature, of_the_sphere_converges) {
  expect_orders({{1, 1, 1}}, {80, 320, 1280, 5120}, 16 * pi);
}

TEST(Curvature, of_an_ellipsoid_converges) {
  expect_orders({{1.2, 1.2, 0.8}}, {80, 320, 1280, 5120}, spheroid_willmore(1.2, 0.8));
}

// The energies that are computed at all points of a triangle at once, against the plain loop over points.
TEST(Curvature, and_order_have_the_energy_of_the_densities_summed_up_point_by_point) {
  Surface s = surface_of(meshing::ellipsoid({1, 0.8, 0.6}, {.triangles = 80}));
  s.state.beta = (0.5 + 0.1 * s.state.X.row(0).array() * s.state.X.row(2).array()).matrix();
  const model::Material material;
  const auto curvature = curvature_of(*s.mesh, s.state.X);
  ASSERT_TRUE(curvature.has_value());
  Energy plain{};
  for_each_point(*s.mesh, s.state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& v, const SurfacePoint& p) {
                   const ElementField beta = on_element(*s.mesh, e, s.state.beta);
                   const double H = value_at(on_element(*s.mesh, e, curvature->H), v);
                   const ElementNodes normals = on_element(*s.mesh, e, curvature->normals);
                   const auto density = model::energy_density(
                       material, value_at(beta, v), gradient_at(beta, p).squaredNorm(), H,
                       model::gauss_curvature(shape_operator(p, normals, H)));
                   plain.distortion += p.dS * density.distortion;
                   plain.bending += p.dS * (density.bending + density.gaussian);
                   plain.thermotropic += p.dS * density.thermotropic;
                 });
  const Energy at_once = energy_by_shape_operator(*s.mesh, material, s.state, *curvature);
  EXPECT_GT(plain.distortion, 0);
  EXPECT_NEAR(at_once.distortion, plain.distortion, 1e-12 * plain.distortion);
  EXPECT_NEAR(at_once.bending, plain.bending, 1e-12 * plain.bending);
  EXPECT_NEAR(at_once.thermotropic, plain.thermotropic, 1e-12 * std::abs(plain.thermotropic));
}

TEST(Curvature, of_a_degenerate_surface_is_refused) {
  const Surface s = uniform_sphere(0.5, 80);
  Nodes X = s.state.X;
  X(1, 7) = std::nan("");
  EXPECT_FALSE(curvature_of(*s.mesh, X).has_value());
  EXPECT_FALSE(curvature_of(*s.mesh, Nodes::Zero(3, X.cols())).has_value());
}

}  // namespace
}  // namespace sbeh::surface3d
