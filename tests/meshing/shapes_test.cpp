// Spheres, ellipsoids, harmonics, implicit surfaces and revolved profiles: measures and refusals.
#include "meshing/implicit.h"
#include "meshing/quality.h"
#include "meshing/revolution.h"
#include "tests/meshing/cases.h"

#include <Eigen/QR>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace sbeh::meshing {
namespace {

using namespace test;

// Sums over thousands of triangles: their rounding.
constexpr double rounding = 1e-12;

TEST(SphericalHarmonics, are_orthonormal) {
  constexpr int highest = 5, n = highest + 1;  // the rule is exact for products up to degree 10
  const model::IntervalRule rule = model::gauss_rule(n);
  std::vector<Harmonic> all;
  for (int l = 0; l <= highest; ++l)
    for (int m = -l; m <= l; ++m) all.push_back({l, m, 1});
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(Eigen::Index(all.size()), Eigen::Index(all.size()));
  Eigen::VectorXd values(gram.rows());
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const double z = 1 - 2 * rule.points[i], s = std::sqrt(1 - z * z), phi = pi * j / n;
      for (std::size_t k = 0; k < all.size(); ++k)
        values[Eigen::Index(k)] =
            spherical_harmonic(all[k].l, all[k].m, {s * std::cos(phi), s * std::sin(phi), z});
      gram += 2 * rule.weights[i] * pi / n * values * values.transpose();
    }
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff(),
            1e-13);
}

TEST(SphericalHarmonics, are_those_of_the_standard_library) {
  for (const int l : {0, 1, 2, 5, 12})
    for (int m = 0; m <= l; ++m)
      for (const double theta : {0.01, 0.7, 1.6, 3.1}) {
        const double phi = 0.4, sign = m % 2 == 0 ? 1 : -1;  // its own factor (−1)^m
        const Vector3d d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                         std::cos(theta));
        const double zonal =
            sign * std::sph_legendre(unsigned(l), unsigned(m), theta) * (m > 0 ? std::sqrt(2) : 1);
        EXPECT_NEAR(spherical_harmonic(l, m, d), zonal * std::cos(m * phi), 1e-12);
        if (m > 0) {
          EXPECT_NEAR(spherical_harmonic(l, -m, d), zonal * std::sin(m * phi), 1e-12);
        }
      }
}

TEST(SphericalHarmonics, that_do_not_exist_are_refused) {
  EXPECT_THROW(spherical_harmonic(-1, 0, Vector3d::UnitZ()), std::invalid_argument);
  EXPECT_THROW(spherical_harmonic(2, 3, Vector3d::UnitZ()), std::invalid_argument);
  EXPECT_THROW(spherical_harmonic(2, -3, Vector3d::UnitZ()), std::invalid_argument);
}

TEST(EllipsoidMesh, has_the_area_and_reduced_volume_asked_for) {
  for (const bool prolate : {false, true})
    for (const double v : {0.6, 0.8, 0.95, 0.999})
      for (const int order : {1, 2, 3}) {
        const Resolution resolution{.triangles = 1280, .order = order};
        if (order == 1 && v == 0.999) continue;  // plain triangles do not reach it
        const CurvedMesh mesh = ellipsoid(v, prolate, resolution);
        EXPECT_NEAR(area(mesh) / (4 * pi), 1, rounding) << v;
        EXPECT_NEAR(reduced_volume(mesh) / v, 1, rounding) << v;
        const Vector3d axes = mesh.nodes.rowwise().maxCoeff();
        EXPECT_EQ(axes[2] > axes[0], prolate) << v;
        // One spheroid through all nodes: x² + y² = a² − (a/c)² z².
        Eigen::MatrixX2d A(mesh.node_count(), 2);
        A << Eigen::VectorXd::Ones(mesh.node_count()), mesh.nodes.row(2).cwiseAbs2().transpose();
        const Eigen::VectorXd b = mesh.nodes.topRows(2).colwise().squaredNorm().transpose();
        EXPECT_LT((A * A.colPivHouseholderQr().solve(b) - b).cwiseAbs().maxCoeff(), 1e-13) << v;
      }
}

TEST(HarmonicSphere, has_the_reduced_volume_asked_for_and_its_nodes_on_the_shape) {
  const std::vector<Harmonic> modes{{2, 0, 0.3}, {3, -2, 0.1}};
  for (const double v : {0.8, 0.9, 0.99}) {
    const CurvedMesh mesh = harmonic_sphere(modes, v, {.triangles = 1280});
    EXPECT_NEAR(reduced_volume(mesh) / v, 1, rounding);
    // One factor for all nodes.
    const Vector3d first = mesh.nodes.col(0);
    const double factor = (first.norm() - 1) / harmonic_sum(modes, first.normalized());
    for (const auto x : mesh.nodes.colwise())
      EXPECT_NEAR(x.norm(), 1 + factor * harmonic_sum(modes, x.normalized()), 1e-14);
  }
  EXPECT_THROW(harmonic_sphere(modes, 0.05, {}), std::invalid_argument);
  EXPECT_THROW(harmonic_sphere(modes, 1, {}), std::invalid_argument);
}

// Discs, needles and blades, round which no even triangles go: the volume is exact to the order of the mesh.
TEST(EllipsoidMesh, is_made_of_slender_triangles_where_it_is_sharp) {
  const std::vector<Vector3d> slender{{1, 1, 0.1}, {1, 1, 0.05}, {1, 1, 0.03}, {0.02, 1, 1},
                                      {20, 1, 1},  {1, 50, 1},   {30, 5, 1},   {1, 2, 100}};
  for (const Vector3d& axes : slender)
    for (const int order : {2, 3}) {
      const CurvedMesh mesh = ellipsoid(axes, {.triangles = 720, .order = order});
      EXPECT_NEAR(mesh.triangle_count(), 720, 0.15 * 720);
      EXPECT_NEAR(volume(mesh) / (4 * pi / 3 * axes.prod()), 1, order == 3 ? 1e-4 : 1e-3);
      EXPECT_GT(min_jacobian(mesh), 0) << axes.transpose();
      EXPECT_EQ(quality_of(mesh).self_intersections, 0) << axes.transpose();
    }
}

TEST(EllipsoidMesh, of_reduced_volume_1_is_the_sphere) {
  const CurvedMesh mesh = ellipsoid(1, false, {.triangles = 1280});
  const Eigen::ArrayXd radius = mesh.nodes.colwise().norm();
  EXPECT_LT(radius.maxCoeff() / radius.minCoeff() - 1, 1e-15);
  EXPECT_NEAR(area(mesh) / (4 * pi), 1, rounding);
}

TEST(EllipsoidMesh, refuses_what_is_none) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double v : {0., -0.1, 1.0001, nan, 1e-3})
    EXPECT_THROW(ellipsoid(v, false, {}), std::invalid_argument) << v;
  EXPECT_THROW(ellipsoid(1 - 1e-14, false, {}), std::invalid_argument);  // above that of the mesh
  EXPECT_THROW(ellipsoid({1, 1, 0}, {}), std::invalid_argument);
  EXPECT_THROW(ellipsoid({1, nan, 1}, {}), std::invalid_argument);
  EXPECT_THROW(ellipsoid({1, 1, 101}, {}), std::invalid_argument);
}

TEST(Resolution, refuses_what_cannot_be_meshed) {
  EXPECT_THROW(sphere({.triangles = 19}), std::invalid_argument);
  EXPECT_THROW(sphere({.triangles = 200'001}), std::invalid_argument);
  EXPECT_THROW(sphere({.order = 0}), std::invalid_argument);
  EXPECT_THROW(sphere({.order = 4}), std::invalid_argument);
  EXPECT_THROW(sphere({.grading = -1}), std::invalid_argument);
}

TEST(StarShaped, refuses_shapes_that_bend_too_sharply_for_their_triangles) {
  EXPECT_THROW(ellipsoid({1, 1, 100}, {.triangles = 80}), std::invalid_argument);
}

TEST(HarmonicSphere, refuses_radii_that_are_not_positive) {
  const Harmonic large{2, 0, -3.};
  EXPECT_THROW(harmonic_sphere({&large, 1}, {}), std::invalid_argument);
  EXPECT_THROW(star_shaped([](const Vector3d&) { return std::nan(""); }, {}),
               std::invalid_argument);
}

TEST(Grading, makes_triangles_smaller_where_the_curvature_is_large) {
  // On a flat spheroid |H| is largest at the rim. Mean area of the triangles there over that at the
  // poles, without and with grading.
  const auto ratio = [](double grading) {
    const CurvedMesh mesh =
        ellipsoid(0.7, false, {.triangles = 5120, .order = 1, .grading = grading});
    double rim = 0, poles = 0;
    int at_rim = 0, at_poles = 0;
    const double radius = mesh.nodes.row(0).maxCoeff();
    for (const auto c : mesh.triangles.colwise()) {
      const Eigen::Matrix3d X = mesh.nodes(Eigen::all, c);
      const double A = (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0)).norm() / 2;
      const double distance = X.rowwise().mean().head<2>().norm();
      if (distance > 0.95 * radius) rim += A, ++at_rim;
      if (distance < 0.5 * radius) poles += A, ++at_poles;
    }
    return (rim / at_rim) / (poles / at_poles);
  };
  const double even = ratio(0), graded = ratio(1);
  EXPECT_GT(even, 0.5);
  EXPECT_LT(graded, 0.5 * even);
}

TEST(CorrectAreaVolume, meets_both_and_changes_little_else) {
  const CurvedMesh before = y53({.triangles = 1280});
  for (const double v : {0.73, 0.7376, 0.75}) {
    CurvedMesh mesh = before;
    ASSERT_TRUE(correct_area_volume(mesh, 4 * pi, v));
    EXPECT_NEAR(area(mesh) / (4 * pi), 1, rounding);
    EXPECT_NEAR(reduced_volume(mesh) / v, 1, rounding);
  }
  CurvedMesh mesh = before;
  EXPECT_FALSE(correct_area_volume(mesh, 4 * pi, 0.2));
  EXPECT_EQ(mesh.nodes, before.nodes);
}

TEST(ImplicitSurface, lies_on_the_zero_level_with_about_the_triangles_asked_for) {
  // Two humps: Cassini's oval revolved; not star-shaped about most of its points.
  ImplicitShape shape{.f =
                          [](const Vector3d& x) {
                            const Vector3d focus(0.9, 0, 0);
                            return (x - focus).squaredNorm() * (x + focus).squaredNorm() - 1;
                          },
                      .gradient = {},
                      .centre = {0.5, 0, 0},
                      .radius = 2};
  for (const int count : {320, 1280, 5120}) {
    const CurvedMesh mesh = implicit_surface(shape, {.triangles = count});
    for (const auto x : mesh.nodes.colwise()) EXPECT_NEAR(shape.f(x), 0, 1e-13);
    EXPECT_NEAR(mesh.triangle_count(), count, 0.15 * count);
    const Quality q = quality_of(mesh);
    EXPECT_EQ(q.euler, 2);
    EXPECT_EQ(q.self_intersections, 0);
    EXPECT_GT(q.volume, 0);
    EXPECT_GT(q.min_angle, 30);
    EXPECT_GT(q.min_jacobian, 0.3);
  }
}

TEST(ImplicitSurface, refuses_what_is_none) {
  const auto sphere_at = [](double r) { return [r](const Vector3d& x) { return x.norm() - r; }; };
  EXPECT_THROW(implicit_surface({.f = sphere_at(1), .radius = 0}, {}), std::invalid_argument);
  EXPECT_THROW(implicit_surface({.f = sphere_at(-1), .radius = 2}, {}), std::invalid_argument);
  // A torus about the y axis, with the centre inside of its tube.
  const auto torus = [](const Vector3d& x) {
    return std::hypot(std::hypot(x[0], x[2]) - 1, x[1]) - 0.4;
  };
  EXPECT_THROW(implicit_surface({.f = torus, .centre = {1, 0, 0}, .radius = 3}, {.triangles = 320}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::meshing
