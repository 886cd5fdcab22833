// Spectral curves, and exact derivatives of the energy on them.
#include "tests/axisym/spectral/cases.h"

#include <limits>
#include <random>

namespace sbeh::axisym {
namespace {

using namespace test;

// --- curves

TEST(SpectralCurve, sphere_is_exact_with_any_grading) {
  for (const Grading& grading : {Grading{}, Grading{.a = 0.9, .x0 = 0.45}}) {
    const auto on = basis(Symmetry::none, 60, grading);
    Eigen::Matrix2Xd circle(2, 4001);
    for (int j = 0; j <= 4000; ++j)
      circle.col(j) << std::sin(pi * j / 4000), std::cos(pi * j / 4000);
    const Curve sphere{.basis = on, .length = pi, .b = curve_through(circle, on).b};
    const Problem problem = Problem::classical(on);
    const Expansion e = expand(problem, pack(sphere)).value();
    // ψ is piecewise linear between samples, which is exact on a circle.
    EXPECT_NEAR(e.energy, 8 * pi, 1e-10);
    EXPECT_NEAR(e.measures[0], 4 * pi, 1e-10);
    EXPECT_NEAR(e.measures[1], 4 * pi / 3, 1e-10);
    EXPECT_NEAR(e.measures[2], 0, 1e-10);
    EXPECT_LT((mean_curvature(sphere).array() + 2).abs().maxCoeff(), 1e-8);
    EXPECT_LT((pole_curvatures(sphere).array() + 2).abs().maxCoeff(), 1e-8);
  }
}

TEST(SpectralCurve, minima_are_closed_and_regular_at_the_poles) {
  for (const Branch branch : branches) {
    const Curve curve = minimum(branch, 0.6).value().curve();
    const Problem whole =
        Problem::classical(basis(Symmetry::none, curve.basis->cutoff, curve.basis->grading));
    const VectorXd measures = expand(whole, pack(on_basis(curve, whole.basis))).value().measures;
    EXPECT_LT((measures - target_of(whole, 0.6)).cwiseAbs().maxCoeff(), rounding) << name(branch);
    // Both principal curvatures agree at a pole: H there is twice the meridian's, and the curvature on
    // the points tends to it quadratically.
    const VectorXd H = mean_curvature(curve);
    const auto s = [&](int j) {
      return curve.length * curve.basis->grading.sigma(curve.basis->x[j]);
    };
    const double s0 = s(0), s1 = s(1);
    const double slope = (H[1] - H[0]) / (s1 * s1 - s0 * s0);
    EXPECT_NEAR(H[0] - slope * s0 * s0, pole_curvatures(curve)[0], 1e-4) << name(branch);
    const Eigen::Matrix2Xd points = profile(curve, 400);
    EXPECT_EQ(points(0, 0), 0);
    EXPECT_EQ(points(0, points.cols() - 1), 0);
    EXPECT_GT(points.row(0).segment(1, points.cols() - 2).minCoeff(), 0);
  }
}

TEST(SpectralCurve, survives_the_way_through_its_polygon) {
  const Curve curve = minimum(Branch::stomatocyte, 0.6).value().curve();
  const Curve back = curve_through(profile(curve, 2000), basis_for(Branch::stomatocyte, 0.6, 24));
  EXPECT_NEAR(back.length, curve.length, 1e-4);
  for (double sigma = 0.05; sigma < 1; sigma += 0.1)
    EXPECT_NEAR(angle(back, sigma), angle(curve, sigma), 2e-3) << sigma;
}

TEST(SpectralCurve, refuses_what_it_cannot_hold) {
  EXPECT_THROW(basis(Symmetry::none, 1), std::invalid_argument);
  EXPECT_THROW(basis(Symmetry::top_bottom, 20, {.a = 0.5, .x0 = 0.3}), std::invalid_argument);
  EXPECT_THROW(curve_through(Eigen::Matrix2Xd::Zero(2, 3), basis(Symmetry::none, 8)),
               std::invalid_argument);
}

// --- derivatives

struct Case {
  const char* label;
  Problem problem;
  VectorXd y, multipliers;
};
using Vector5d = Eigen::Vector<double, 5>;
// No solutions of anything: start shapes and an order that have nothing to do with each other.
std::vector<Case> cases() {
  Material general;
  general.L1 = 0.05, general.L2 = 0.031, general.L3 = -0.023;
  general.residual_stiffness = 0.017;
  general.spontaneous_curvature = -0.7;
  general.flexoelectric = model::Polynomial({0.3, -0.8, 0.5});
  general.potential = model::Potential({0.3, -0.2, 1.1, -4., 5., 0.7});
  const auto whole = basis(Symmetry::none, 16, {.a = 0.6, .x0 = 0.4});
  const auto half = basis(Symmetry::top_bottom, 16, {.a = 0.5});
  const Curve cup = invaginated_sphere(0.6, whole), oblate = spheroid(0.7, false, half);
  // Bumps on the cup, as high as a curve of these modes bears.
  Curve bumpy = cup;
  for (Eigen::Index i = 0; i < bumpy.b.size(); ++i) bumpy.b[i] += 0.03 * std::sin(2.3 * double(i));
  // Area difference, conserved order, area per lipid, and functions that are given.
  Material stretched = general, coupled = general, packed = general;
  stretched.area_difference = {0.7, -21.};
  stretched.kappa_powers = model::Polynomial({0.4, -0.3, 0.2, 0.5});
  stretched.kappa_gauss_powers = model::Polynomial({-0.1, 0.2, -0.6});
  coupled.area_difference = {std::numeric_limits<double>::infinity(), -23.};
  coupled.order = model::OrderDynamics::conserved;
  coupled.mean_order = 0.37;
  packed.lipid_density = model::Polynomial({0.8, 0.4, -0.1});
  const auto wavy = [](int n) {
    VectorXd c(n);
    for (int k = 0; k < n; ++k) c[k] = 0.5 * std::cos(3. * k) / (1 + k * k);
    return c;
  };
  return {
      {"classical, no symmetry", Problem::classical(whole), pack(cup),
       Eigen::Vector3d(1.3, 2.1, -0.4)},
      {"classical, symmetric", Problem::classical(half), pack(oblate), Eigen::Vector2d(1.3, 2.1)},
      {"ordered, no symmetry", Problem{general, whole}, pack(cup, wavy(whole->modes() + 1)),
       Eigen::Vector3d(1.3, 2.1, -0.4)},
      {"ordered, symmetric", Problem{Material{}, half}, pack(oblate, wavy(half->modes() + 1)),
       Eigen::Vector2d(1.3, 2.1)},
      {"area difference", Problem{stretched, whole}, pack(bumpy, wavy(whole->modes() + 1)),
       Eigen::Vector3d(1.3, 2.1, -0.4)},
      {"area difference, uniform order", Problem::of(stretched, model::Model::SSH, half),
       pack(oblate), Eigen::Vector2d(1.3, 2.1)},
      {"bilayer couple of conserved order", Problem{coupled, whole},
       pack(bumpy, wavy(whole->modes() + 1)), Vector5d(1.3, 2.1, -0.4, 0.6, -1.7)},
      {"area per lipid", Problem{packed, whole}, pack(bumpy, wavy(whole->modes() + 1)),
       Eigen::Vector3d(1.3, 2.1, -0.4)}};
}

VectorXd random_direction(Eigen::Index size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  VectorXd v(size);
  for (Eigen::Index i = 0; i < size; ++i) v[i] = uniform(generator) / double(1 + i % 17);
  return v;
}

// By sums over the polygon of a curve that closes: another rule, and other formulas.
TEST(SpectralLagrangian, has_the_measures_of_its_polygon) {
  Material material;
  material.area_difference = {std::numeric_limits<double>::infinity(), -23.};
  material.order = model::OrderDynamics::conserved;
  material.mean_order = 0.37;
  const Problem problem{material, basis(Symmetry::none, 64)};
  Curve curve = spheroid(0.7, false, problem.basis);
  for (Eigen::Index i = 1; i < 16; i += 2) curve.b[i] += 0.05 / double(i);  // even k
  VectorXd order = VectorXd::Zero(problem.order_modes());
  order.head(4) << 0.5, 0.1, -0.2, 0.05;
  const auto sums = [&](int intervals) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // A, W₂, ∫β dS
    double r = 0;
    const double ds = curve.length / intervals;
    for (int j = 0; j < intervals; ++j) {
      const double x = (j + 0.5) / intervals, half = 0.5 / intervals;
      const double psi = angle(curve, x), middle = r + ds / 2 * std::cos(psi);
      double beta = 0;
      for (int k = 0; k < 4; ++k) beta += order[k] * std::cos(k * pi * x);
      const double turn = (angle(curve, x + half) - angle(curve, x - half)) / ds;
      sum += 2 * pi * middle * ds * Eigen::Vector3d(1, -turn - std::sin(psi) / middle, beta);
      r += ds * std::cos(psi);
    }
    return sum;
  };
  const auto square = [&](int n) -> Eigen::Vector3d { return (4 * sums(2 * n) - sums(n)) / 3; };
  const Eigen::Vector3d sum = (16 * square(2000) - square(1000)) / 15;  // orders 2 and 4 taken out
  const VectorXd measures = expand(problem, pack(curve, order)).value().measures;
  ASSERT_EQ(measures.size(), 5);
  EXPECT_NEAR(measures[0], sum[0], 1e-9);
  EXPECT_NEAR(measures[3], sum[1], 1e-9);
  EXPECT_NEAR(measures[4], sum[2] - 0.37 * sum[0], 1e-9);
}

// h = 1e-4: the next term of the series is (kh)⁴ ≈ 1e-11, rounding 1e-16/h = 1e-12 of the values.
constexpr double h = 1e-4, accuracy = 1e-8;

TEST(SpectralLagrangian, gradients_are_the_differences_of_energy_and_measures) {
  for (const Case& c : cases()) {
    const Expansion e = expand(c.problem, c.y).value();
    for (const unsigned seed : {1u, 2u, 3u}) {
      const VectorXd v = random_direction(c.y.size(), seed);
      const auto along = [&](double t) { return expand(c.problem, c.y + t * v).value(); };
      const double energy = difference([&](double t) { return along(t).energy; }, h);
      EXPECT_NEAR(e.gradient.dot(v), energy, accuracy * (1 + e.gradient.norm())) << c.label;
      const VectorXd measures =
          difference([&](double t) -> VectorXd { return along(t).measures; }, h);
      EXPECT_LT((e.jacobian * v - measures).norm(), accuracy * (1 + e.jacobian.norm())) << c.label;
    }
  }
}

TEST(SpectralLagrangian, hessian_is_symmetric_and_the_difference_of_the_gradient) {
  for (const Case& c : cases()) {
    const MatrixXd H = hessian(c.problem, c.y, c.multipliers);
    EXPECT_LT((H - H.transpose()).norm(), 1e-12 * H.norm()) << c.label;
    for (const unsigned seed : {4u, 5u}) {
      const VectorXd v = random_direction(c.y.size(), seed);
      const VectorXd expected = difference(
          [&](double t) -> VectorXd {
            const Expansion e = expand(c.problem, c.y + t * v).value();
            return e.gradient + e.jacobian.transpose() * c.multipliers;
          },
          h);
      EXPECT_LT((H * v - expected).norm(), accuracy * H.norm()) << c.label;
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym
