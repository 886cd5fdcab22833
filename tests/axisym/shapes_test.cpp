// Start shapes, redistribution of nodes, and the correction of area and volume.
#include "axisym/redistribute.h"
#include "axisym/shape_class.h"
#include "model/numerics/quadrature.h"
#include "tests/axisym/cases.h"

#include <Eigen/Cholesky>

#include <stdexcept>

namespace sbeh::axisym {
namespace {

using namespace test;

// What `correct_area_volume` promises, relative.
constexpr double correction = 1e-12;

// ---- start shapes -------------------------------------------------------------------------------

TEST(Spheroid, has_the_area_and_reduced_volume_asked_for) {
  for (const bool prolate : {false, true})
    for (const double v : {0.4, 0.6, 0.7, 0.8, 0.95, 0.999})
      for (const int elements : {16, 48}) {
        const Nodes X = spheroid(v, prolate, elements, 0.5);
        EXPECT_EQ(element_count(X), elements);
        EXPECT_NEAR(area(X) / (4 * pi), 1, correction) << "V_r = " << v;
        EXPECT_NEAR(reduced_volume(area(X), volume(X)) / v, 1, 3 * correction) << "V_r = " << v;
        const double polar = X(1, 0), equatorial = X.row(0).maxCoeff();
        EXPECT_EQ(polar > equatorial, prolate) << "V_r = " << v;
        EXPECT_EQ(X(0, 0), 0);
        EXPECT_EQ(X(0, X.cols() - 1), 0);
      }
}

TEST(Spheroid, holds_area_and_volume_however_flat_or_thin) {
  for (const int elements : {8, 48})
    for (const bool prolate : {false, true})
      for (const double v : {0.2, 0.05, 0.01}) {
        const Nodes X = spheroid(v, prolate, elements, 0.5);
        EXPECT_NEAR(area(X) / (4 * pi), 1, 1e-12) << elements << ' ' << prolate << ' ' << v;
        EXPECT_NEAR(reduced_volume(area(X), volume(X)) / v, 1, 1e-11)
            << elements << ' ' << prolate << ' ' << v;
      }
}

TEST(Spheroid, of_reduced_volume_1_is_the_sphere) {
  const Nodes X = spheroid(1, false, 24, 0.5);
  EXPECT_NEAR(area(X) / (4 * pi), 1, correction);
  const Eigen::ArrayXd radius = X.colwise().norm();
  // Scaled to area 4π: that of the cubics errs by less than h⁴ with h = π/24.
  EXPECT_LT((radius - 1).abs().maxCoeff(), std::pow(pi / 24, 4));
}

TEST(Spheroid, from_semi_axes_keeps_their_ratio_and_has_area_4_pi) {
  const Nodes X = spheroid(3., 2., 24, 0.5);
  EXPECT_NEAR(area(X) / (4 * pi), 1, 1e-14);
  const double scale = X(1, 0) / 2;
  const auto from_axis = X.row(0).array() / 3, along_axis = X.row(1).array() / 2;
  const Eigen::ArrayXd radius = (from_axis.square() + along_axis.square()).sqrt() / scale;
  // The joints lie on it, the nodes between on the cubics through the Gauss-Lobatto points.
  const auto joints = Eigen::seq(0, Eigen::last, 3);
  EXPECT_LT((radius(joints) - 1).abs().maxCoeff(), 1e-13);
  EXPECT_LT((radius - 1).abs().maxCoeff(), std::pow(pi / 24, 4));
}

TEST(Spheroid, refuses_what_is_none) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double v : {0., -0.1, 1.0001, nan})
    EXPECT_THROW(spheroid(v, false, 16, 0.5), std::invalid_argument) << v;
  EXPECT_THROW(spheroid(0., 1., 16, 0.5), std::invalid_argument);
  EXPECT_THROW(spheroid(1., -1., 16, 0.5), std::invalid_argument);
  EXPECT_THROW(spheroid(nan, 1., 16, 0.5), std::invalid_argument);
}

TEST(ZonalSum, is_made_of_orthonormal_harmonics) {
  // Gauss–Legendre in cos θ, exact for the products up to degree 10.
  const model::IntervalRule rule = model::gauss_rule(8);
  for (int l = 0; l <= 5; ++l)
    for (int k = 0; k <= 5; ++k) {
      double product = 0;
      for (int q = 0; q < rule.size(); ++q) {
        const double theta = std::acos(2 * rule.points[q] - 1);
        const std::array<Mode, 1> a{{{l, 1}}}, b{{{k, 1}}};
        product += 2 * pi * 2 * rule.weights[q] * zonal_sum(a, theta) * zonal_sum(b, theta);
      }
      EXPECT_NEAR(product, l == k ? 1 : 0, 1e-14) << l << ' ' << k;
    }
}

TEST(HarmonicSphere, follows_its_modes_up_to_the_scale_of_area_4_pi) {
  const std::array<Mode, 2> modes{{{2, 0.1}, {3, -0.05}}};
  const Nodes X = harmonic_sphere(modes, 32, 0.5);
  EXPECT_NEAR(area(X) / (4 * pi), 1, 1e-14);
  const double scale = X(1, 0) / (1 + zonal_sum(modes, 0));
  double miss = 0;
  for (Eigen::Index i = 0; i < X.cols(); i += 3) {
    const double theta = std::atan2(X(0, i), X(1, i));
    miss = std::max(miss, std::abs(X.col(i).norm() / scale - 1 - zonal_sum(modes, theta)));
  }
  EXPECT_LT(miss, 1e-13);  // every joint lies on it
}

const std::vector<std::vector<Mode>> mode_lists{
    {{2, 0.04}},         {{2, -0.04}},
    {{3, 0.01}},         {{2, 0.04}, {3, 0.02}},
    {{2, 3.}, {5, -1.}}, {{4, 1e-4}, {6, 2e-4}, {7, -1e-4}}};

TEST(HarmonicSphere, has_the_reduced_volume_asked_for_at_the_ratios_of_its_modes) {
  for (const auto& modes : mode_lists)
    for (const double v : {0.9, 0.999}) {
      const Nodes X = harmonic_sphere(modes, v, 48, 0.5);
      EXPECT_NEAR(area(X) / (4 * pi), 1, 1e-12);
      EXPECT_NEAR(reduced_volume(area(X), volume(X)) / v, 1, 1e-12);
      // r = scale (1 + factor Σ): scale and factor by least squares at the joints.
      const Eigen::Index joints = X.cols() / 3 + 1;
      Eigen::MatrixX2d forms(joints, 2);
      Eigen::VectorXd r(joints);
      for (Eigen::Index i = 0; i < joints; ++i) {
        r[i] = X.col(3 * i).norm();
        forms.row(i) << 1, zonal_sum(modes, std::atan2(X(0, 3 * i), X(1, 3 * i)));
      }
      const Eigen::Vector2d fit = (forms.transpose() * forms).ldlt().solve(forms.transpose() * r);
      EXPECT_LT((forms * fit - r).cwiseAbs().maxCoeff(), 1e-12);
      EXPECT_GT(fit[1] / fit[0], 0);
    }
}

TEST(HarmonicSphere, refuses_a_reduced_volume_that_its_modes_do_not_have) {
  for (const double v : {0., 1., 1.2, -0.1, std::nan("")})
    EXPECT_THROW(harmonic_sphere(mode_lists[0], v, 24, 0.5), std::invalid_argument) << v;
  for (const auto& modes : mode_lists)
    EXPECT_THROW(harmonic_sphere(modes, 0.05, 24, 0.5), std::invalid_argument);
}

TEST(HarmonicSphere, refuses_negative_degrees_and_negative_radii) {
  const std::array<Mode, 1> negative{{{-1, 0.1}}}, large{{{2, 4.}}};
  EXPECT_THROW(harmonic_sphere(negative, 16, 0.5), std::invalid_argument);
  EXPECT_THROW(harmonic_sphere(large, 16, 0.5), std::invalid_argument);
}

// ---- perturbations ------------------------------------------------------------------------------

// The largest distance along the normals between the perturbed curve and one displaced by the sum alone.
double beyond_first_order(const Nodes& X, const std::vector<Mode>& modes) {
  const Nodes Y = perturbed(X, modes), n = node_normals(X);
  const double middle = (X(1, 0) + X(1, X.cols() - 1)) / 2;  // of symmetric curves
  double largest = 0;
  for (Eigen::Index i = 0; i < X.cols(); ++i) {
    const double asked = zonal_sum(modes, std::atan2(X(0, i), X(1, i) - middle));
    largest = std::max(largest, std::abs((Y - X).col(i).dot(n.col(i)) - asked));
  }
  return largest;
}

TEST(Perturbed, is_displaced_along_the_normals_at_the_same_area_and_volume) {
  for (const bool prolate : {false, true})
    for (const double v : {0.4, 0.7, 0.95})
      for (const int l : {1, 2, 3, 6}) {
        const Nodes X = spheroid(v, prolate, 48, 0.5);
        const Nodes Y = perturbed(X, std::vector<Mode>{{l, 0.003}});
        EXPECT_NEAR(area(Y) / area(X), 1, correction);
        EXPECT_NEAR(volume(Y) / volume(X), 1, correction);
        EXPECT_GT((Y - X).cwiseAbs().maxCoeff(), 0.001);
      }
}

TEST(Perturbed, errs_by_the_square_of_the_amplitude_where_the_modes_keep_area_and_volume) {
  // Odd modes of a curve that is symmetric at the equator.
  for (const int l : {3, 5}) {
    const Nodes X = spheroid(0.7, false, 48, 0.5);
    const double large = beyond_first_order(X, {{l, 0.01}}),
                 small = beyond_first_order(X, {{l, 0.001}});
    EXPECT_NEAR(std::log10(large / small), 2, 0.1) << l;
  }
}

TEST(Perturbed, a_sphere_has_the_volume_that_the_modes_leave_it) {
  const Nodes X = spheroid(1, false, 48, 0.5);
  for (const double a : {0.02, 0.04}) {
    const Nodes Y = perturbed(X, std::vector<Mode>{{2, a}});
    EXPECT_NEAR(area(Y) / area(X), 1, correction);
    // A = 4πR² (1 + (l − 1)(l + 2) a²/8π + O(a³)) at the volume of the sphere of radius R.
    EXPECT_NEAR((1 - reduced_volume(area(Y), volume(Y))) / (a * a), 1.5 * 4 / (8 * pi), a);
  }
}

TEST(Perturbed, refuses_what_is_too_large_for_the_curve) {
  for (const double v : {0.3, 0.6})
    for (const auto& modes : std::vector<std::vector<Mode>>{{{1, 3.}}, {{2, -2.}}, {{4, 2.}}})
      EXPECT_THROW(perturbed(spheroid(v, false, 48, 0.5), modes), std::invalid_argument) << v;
}

// ---- redistribution -----------------------------------------------------------------------------

// A smooth curve without symmetry, with β = exp(z) on it.
State egg(int elements) {
  State s{.X = Nodes(2, 3 * elements + 1), .beta = Field(3 * elements + 1)};
  for (Eigen::Index i = 0; i < s.X.cols(); ++i) {
    const double t = pi * double(i) / double(s.X.cols() - 1), a = 1 + 0.2 * std::cos(t);
    s.X.col(i) << a * std::sin(t), 0.7 * std::cos(t);
    s.beta[i] = std::exp(s.X(1, i));
  }
  s.X(0, 0) = s.X(0, s.X.cols() - 1) = 0;
  return s;
}

TEST(Redistribute, keeps_area_volume_and_fields_to_the_order_of_cubic_interpolation) {
  // New nodes on the old cubics, equidistant in arc length: as for nodes on any curve, order 4.
  OrderTable A("area moved by redistribution", "h"), V("volume", "h"),
      B("beta - exp z at nodes", "h");
  for (const int elements : {12, 24, 48}) {
    const State before = egg(elements), after = redistribute(before, 2.);
    ASSERT_EQ(after.X.cols(), before.X.cols());
    A.add(1. / elements, area(after.X) / area(before.X) - 1);
    V.add(1. / elements, volume(after.X) / volume(before.X) - 1);
    B.add(1. / elements,
          (after.beta.array() - after.X.row(1).transpose().array().exp()).abs().maxCoeff());
    EXPECT_EQ(after.X(0, 0), 0);
    EXPECT_EQ(after.X(0, after.X.cols() - 1), 0);
    EXPECT_EQ(after.X.col(0), before.X.col(0));
  }
  constexpr double slack =
      0.3;  // places come from a piecewise linear measure: not quite smooth in h
  EXPECT_GT(A.print(), 4 - slack);
  EXPECT_GT(V.print(), 4 - slack);
  EXPECT_GT(B.print(), 4 - slack);
}

TEST(Redistribute, without_grading_makes_all_elements_equally_long) {
  // Places are found on an arc length that is linear on 16 pieces per element. With a stretch that
  // changes by the share δ over an element, a joint is off by at most (1/8)(δ/16)/16 of an element,
  // and a length by twice that: δ/1024.
  State one_phase = egg(24);
  one_phase.beta.setConstant(model::full_order);
  const Eigen::VectorXd before = element_lengths(one_phase.X);
  const Eigen::Index n = before.size();
  const double delta =
      (before.tail(n - 1).array() / before.head(n - 1).array() - 1).abs().maxCoeff();
  const Eigen::VectorXd after = element_lengths(redistribute(one_phase, 0).X);
  EXPECT_LT((after.array() / after.mean() - 1).abs().maxCoeff(), delta / 1024);
  EXPECT_GT((before.array() / before.mean() - 1).abs().maxCoeff(), 100 * delta / 1024);
}

TEST(Redistribute, with_grading_makes_elements_short_where_the_curve_bends) {
  const Eigen::VectorXd length = element_lengths(spheroid(0.6, false, 24, 2.));
  const Eigen::Index rim = length.size() / 2;
  EXPECT_LT(length[rim], 0.3 * length[0]);
  // Shares: ∫ (1/ℓ + g |B_ss|/∫|B_ss|) ds is 1 + g in total, so no element is longer than (1 + g)
  // times the mean.
  EXPECT_LT(length.maxCoeff(), 3.01 * length.mean());
}

TEST(Redistribute, changes_the_number_of_elements_when_asked_to) {
  const State s = redistribute(egg(24), 0.5, 40);
  EXPECT_EQ(element_count(s.X), 40);
  EXPECT_EQ(s.beta.size(), s.X.cols());
  EXPECT_NEAR(volume(s.X), volume(egg(24).X), 1e-6);
}

TEST(Redistribute, moves_all_fields_of_a_stationary_state_alike) {
  StationaryState s{egg(24), {}, {}, 3, -4};
  s.H = 2 * s.beta;
  s.Lambda = -s.beta;
  const StationaryState moved = redistribute(s, 1.);
  EXPECT_LT((moved.H - 2 * moved.beta).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((moved.Lambda + moved.beta).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(moved.tension, 3);
  EXPECT_EQ(moved.pressure, -4);
}

// ---- area and volume ----------------------------------------------------------------------------

TEST(CorrectAreaVolume, hits_both) {
  for (const double v : {0.6, 0.7, 0.8, 0.9}) {
    Nodes X = spheroid(v, false, 32, 0.5);
    ASSERT_TRUE(correct_area_volume(X, 4 * pi * 1.01, 4 * pi / 3 * v * 0.995)) << v;
    EXPECT_NEAR(area(X) / (4 * pi * 1.01), 1, correction);
    EXPECT_NEAR(volume(X) / (4 * pi / 3 * v * 0.995), 1, correction);
  }
}

TEST(CorrectAreaVolume, on_a_sphere_meets_the_area_alone) {
  Nodes X = spheroid(1, false, 32, 0.5);
  ASSERT_TRUE(correct_area_volume(X, 4 * pi * 1.02, 4 * pi / 3));
  EXPECT_NEAR(area(X) / (4 * pi * 1.02), 1, correction);
}

TEST(CorrectAreaVolume, refuses_the_impossible_and_leaves_the_curve_alone) {
  const Nodes before = spheroid(0.8, false, 32, 0.5);
  Nodes X = before;
  EXPECT_FALSE(correct_area_volume(X, 4 * pi, 4 * pi / 3 * 1.2));  // more than a sphere holds
  EXPECT_EQ(X, before);
  EXPECT_FALSE(correct_area_volume(X, 4 * pi, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(X, before);

  Nodes point = Nodes::Zero(2, before.cols());
  EXPECT_FALSE(correct_area_volume(point, 4 * pi, 4 * pi / 3));
}

TEST(Necks, have_the_depth_of_a_dumbbell_and_next_to_none_in_a_tube) {
  const int elements = 40, last = 3 * elements;
  const auto profile = [&](auto&& radius) {
    Nodes X(2, last + 1);
    for (int i = 0; i <= last; ++i) {
      const double z = 1 - 2. * i / last;
      X.col(i) << std::sqrt(std::max(0., 1 - std::pow(z, 8))) * radius(z), 5 * z;
    }
    return X;
  };
  const auto waist = necks(profile([](double z) { return 0.5 + z * z; }));
  ASSERT_EQ(waist.size(), 1u);
  EXPECT_EQ(waist[0].node, last / 2);
  EXPECT_EQ(waist[0].radius, 0.5);
  EXPECT_GT(waist[0].depth, 0.4);
  for (const Neck& neck : necks(profile([](double z) { return 0.5 + 1e-13 * std::sin(999 * z); })))
    EXPECT_LT(neck.depth, 1e-12);
}

TEST(Redistribution, leaves_a_uniform_order_uniform_to_the_last_bit) {
  State state{spheroid(0.7, true, 24, 0.5), Field::Constant(73, model::full_order)};
  for (const int elements : {31, 17, 48}) state = redistribute(state, 0.5, elements);
  EXPECT_TRUE((state.beta.array() == model::full_order).all());
}

}  // namespace
}  // namespace sbeh::axisym
