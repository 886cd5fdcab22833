// Classical shapes by shooting: the shape equations, the branches, the special points.
#include "axisym/shooting/seifert_shooting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace sbeh::axisym {
namespace {

using namespace shooting;
using std::numbers::pi;

constexpr Branch branches[] = {Branch::oblate, Branch::prolate, Branch::stomatocyte};

const Pole somewhere{.H = -1.2, .tension = -5, .pressure = -9};  // no closed shape

ClassicalShape shoot(Branch branch, double reduced_volume, const Options& options = {}) {
  return shoot_branch(branch, std::vector{reduced_volume}, options).front();
}
double energy(Branch branch, double reduced_volume) { return shoot(branch, reduced_volume).energy; }
Pole pole_of(const ClassicalShape& s) { return {s.H_pole, s.tension, s.pressure}; }

double largest_difference(const State& a, const State& b) {
  double largest = 0;
  for (int i = 0; i < Row::count; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The order observed in the last of the steps, which halve; prints the table.
template <class Error>
double observed_order(const char* quantity, const std::vector<double>& steps, const Error& error) {
  std::printf("%s\n", quantity);
  double order = std::numeric_limits<double>::quiet_NaN(), last = order;
  for (const double step : steps) {
    const double here = std::abs(error(step));
    order = std::log2(last / here);
    last = here;
    std::printf("  %-10.4g %-10.3e %.2f\n", step, here, order);
  }
  return order;
}

// --- The initial value problem -----------------------------------------------------------------------

TEST(ShapeEquations, have_the_unit_sphere_as_their_solution_when_P_is_twice_Sigma) {
  const double Sigma = 0.7;
  const Pole pole{-2, Sigma, 2 * Sigma};
  for (const double s : {5e-4, 1.0, 2.5}) {
    State exact;
    exact << s, -2, std::sin(s), Sigma / 2 * std::sin(2 * s), 1 - std::cos(s),
        2 * pi * (1 - std::cos(s)), pi / 3 * std::pow(1 - std::cos(s), 2) * (2 + std::cos(s)),
        (1 - std::cos(s)) / 2;
    const auto end = integrate(pole, s);
    ASSERT_TRUE(end);
    EXPECT_LT(largest_difference(end->state, exact), 2e-12) << "s = " << s;
  }
}

TEST(ShapeEquations, keep_the_Hamiltonian_at_zero) {
  const auto largest = [](const Pole& pole, double arc_length) {
    const auto states = sample(pole, arc_length, 50);
    double h = 0;
    for (const auto& at : states.colwise()) {
      const double H = at[Row::H], X = at[Row::X], sine = std::sin(at[Row::psi]);
      h = std::max(
          h, std::abs(X / 2 * H * H + H * sine - pole.tension * X + pole.pressure / 2 * X * X * sine
                      + at[Row::gamma] * std::cos(at[Row::psi])));
    }
    return h;
  };
  EXPECT_LT(largest(somewhere, 3), 1e-11);
  for (const Branch branch : branches) {
    const ClassicalShape s = shoot(branch, 0.6);
    EXPECT_LT(largest(pole_of(s), 1.4), 1e-11) << name(branch);
  }
}

TEST(ShapeEquations, have_the_derivatives_that_differences_show) {
  const double s = 1.5, step = 1e-3;
  const auto at = [&](int parameter, double change) {
    Pole pole = somewhere;
    double length = s;
    (parameter == 0   ? pole.H
     : parameter == 1 ? pole.tension
     : parameter == 2 ? pole.pressure
                      : length) += change;
    return integrate(pole, length)->state;
  };
  const auto end = integrate(somewhere, s);
  for (int j = 0; j < 4; ++j) {
    const auto difference = [&](double h) -> State { return (at(j, h) - at(j, -h)) / (2 * h); };
    const State order_6 =
        (64 * difference(step) - 20 * difference(2 * step) + difference(4 * step)) / 45;
    EXPECT_LT(largest_difference(order_6, end->rates.col(j)), 1e-9) << "parameter " << j;
  }
}

TEST(ShapeEquations, have_a_pole_series_of_order_6) {
  const auto state = [](double start) { return integrate(somewhere, 1.5, {1e-15, start})->state; };
  const State exact = state(1e-3);
  const auto error = [&](double start) { return largest_difference(state(start), exact); };
  EXPECT_NEAR(observed_order("state by the end of the series", {0.2, 0.1, 0.05}, error), 6, 0.2);
}

// --- Branches ----------------------------------------------------------------------------------------

TEST(SeifertShapes, fulfil_the_virial_theorem) {
  for (const Branch branch : branches)
    for (const ClassicalShape& s : shoot_branch(branch, std::vector{0.65, 0.6, 0.5})) {
      const double V = 4 * pi / 3 * s.reduced_volume, A = 4 * pi;
      EXPECT_NEAR(3 * s.pressure * V, 2 * s.tension * A, 1e-9)
          << name(branch) << " " << s.reduced_volume;
    }
}

TEST(SeifertShapes, change_their_energy_with_the_volume_by_the_pressure) {
  for (const Branch branch : branches) {
    const double V = 0.6, h = 2e-3;
    const auto s = shoot_branch(branch, std::vector{V - 2 * h, V - h, V, V + h, V + 2 * h});
    const double near = (s[3].energy - s[1].energy) / (2 * h);
    const double far = (s[4].energy - s[0].energy) / (4 * h);
    // The difference of the two is h² times a third derivative; what remains is h⁴.
    EXPECT_NEAR(6 * (4 * near - far) / 3, s[2].pressure, 1e-2 * std::abs(6 * (near - far)) + 1e-9)
        << name(branch);
  }
}

TEST(SeifertShapes, end_at_the_sphere) {
  for (const Branch branch : {Branch::oblate, Branch::prolate}) {
    const ClassicalShape s = shoot(branch, 1), close = shoot(branch, 1 - 1e-7);
    EXPECT_EQ(s.energy, 1);
    EXPECT_EQ(s.H_pole, -2);
    EXPECT_NEAR(close.energy, 1, 2.1e-7);
    // Y₂ of the amplitude √(4π/3 · 1e-7): |H + 2| = 4 √(5/3 · 1e-7).
    EXPECT_NEAR(std::abs(close.H_pole + 2), 4 * std::sqrt(5. / 3 * 1e-7), 1e-6);
    EXPECT_NEAR(close.pressure, s.pressure, 2e-3);
    EXPECT_NEAR(close.tension, s.tension, 1e-3);
    EXPECT_LT((s.profile.colwise().norm().array() - 1).abs().maxCoeff(), 1e-12);
  }
}

TEST(SeifertShapes, leave_the_sphere_with_the_energy_of_the_l_2_mode) {
  // An excess area Δ in the mode l costs (κ/2)·2 l(l+1) Δ; V_r = 1 − 3Δ/8π. For l = 2:
  //   F/(8πκ) = 1 + 2 (1 − V_r) ± O((1 − V_r)^{3/2}), + on the oblates.
  const auto slope = [](Branch branch, double x) { return (energy(branch, 1 - x) - 1) / x; };
  const auto mean = [&](double x) {
    return (slope(Branch::oblate, x) + slope(Branch::prolate, x)) / 2 - 2;
  };
  const auto half_difference = [&](double x) {
    return (slope(Branch::oblate, x) - slope(Branch::prolate, x)) / 2;
  };
  const std::vector<double> steps{4e-3, 2e-3, 1e-3};
  EXPECT_NEAR(observed_order("mean of the slopes - 2", steps, mean), 1, 0.02);
  EXPECT_NEAR(observed_order("half of their difference", steps, half_difference), 0.5, 0.02);
  EXPECT_GT(half_difference(1e-3), 0);
}

// F/(8πκ) and P: the same equations in 80-bit arithmetic at a tolerance of 1e-16.
TEST(SeifertShapes, agree_with_extended_precision) {
  struct Reference {
    Branch branch;
    double reduced_volume, energy, pressure;
  };
  for (const Reference& r :
       {Reference{Branch::oblate, 0.8, 1.45253862856459018, -14.46218504332249433},
        Reference{Branch::oblate, 0.6, 1.95568026704866033, -15.66689877643025267},
        Reference{Branch::oblate, 0.45, 2.35641899660496077, -16.36168469506334614},
        Reference{Branch::prolate, 0.8, 1.38744043244382698, -12.77790855803269049},
        Reference{Branch::prolate, 0.6, 2.06029318670520468, -31.19933902759450830},
        Reference{Branch::prolate, 0.45, 3.27514817077350148, -74.07475671862486908},
        Reference{Branch::stomatocyte, 0.66, 1.96341319550191544, -2.44151488384310238},
        Reference{Branch::stomatocyte, 0.55, 1.98383421384272643, -0.63398914953589513},
        Reference{Branch::stomatocyte, 0.3, 1.99719933917567708, -0.14219832501267219}}) {
    const ClassicalShape s = shoot(r.branch, r.reduced_volume);
    EXPECT_NEAR(s.energy, r.energy, 1e-12) << name(r.branch) << " " << r.reduced_volume;
    EXPECT_NEAR(s.pressure, r.pressure, 1e-11) << name(r.branch) << " " << r.reduced_volume;
  }
  EXPECT_NEAR(energy(Branch::oblate, 0.8), 1.4525386, 5e-8);
}

TEST(SeifertShapes, do_not_depend_on_the_path) {
  const std::vector<double> up{0.42, 0.5, 0.58, 0.66}, down(up.rbegin(), up.rend());
  for (const Branch branch : branches) {
    const auto a = shoot_branch(branch, up), b = shoot_branch(branch, down);
    for (std::size_t i = 0; i < up.size(); ++i) {
      const ClassicalShape &s = a[i], &t = b[up.size() - 1 - i], u = shoot(branch, up[i]);
      for (const ClassicalShape* other : {&t, &u}) {
        EXPECT_EQ(s.reduced_volume, other->reduced_volume);
        EXPECT_NEAR(s.energy, other->energy, 1e-12);
        EXPECT_NEAR(s.pressure, other->pressure, 1e-10);
        EXPECT_LT((s.profile - other->profile).cwiseAbs().maxCoeff(), 1e-11);
      }
    }
  }
}

TEST(SeifertShapes, have_closed_profiles_of_the_area_and_the_volume) {
  for (const Branch branch : branches) {
    const ClassicalShape s = shoot(branch, 0.6);
    const Eigen::Matrix2Xd& p = s.profile;
    double area = 0, volume = 0, H = 0;
    for (Eigen::Index i = 0; i + 1 < p.cols(); ++i) {
      const double r0 = p(0, i), r1 = p(0, i + 1), dz = p(1, i) - p(1, i + 1);
      area += pi * (r0 + r1) * (p.col(i + 1) - p.col(i)).norm();
      volume += pi / 3 * (r0 * r0 + r0 * r1 + r1 * r1) * dz;
    }
    // Chords: second order in (curvature · spacing), about 5 · 2/128.
    EXPECT_NEAR(area / (4 * pi), 1, 2e-3);
    EXPECT_NEAR(volume / (4 * pi / 3) / 0.6, 1, 2e-3);
    EXPECT_EQ(p(0, 0), 0);
    EXPECT_EQ(p(0, p.cols() - 1), 0);
    // z ≈ z(0) + H r²/4 at the pole of H_pole, and not less at the other.
    const auto curvature = [](double r, double dz) { return 4 * dz / (r * r); };
    H = curvature(p(0, 1), p(1, 1) - p(1, 0));
    const Eigen::Index n = p.cols() - 1;
    EXPECT_NEAR(H, s.H_pole, 0.01 * std::abs(s.H_pole));
    EXPECT_GT(H + 1e-6, curvature(p(0, n - 1), p(1, n) - p(1, n - 1)));
    EXPECT_FALSE(s.self_contact);
  }
}

TEST(SeifertShapes, that_a_branch_does_not_have_are_refused) {
  EXPECT_THROW(shoot(Branch::stomatocyte, 0.67), NotOnBranch);
  EXPECT_THROW(shoot(Branch::stomatocyte, 1), NotOnBranch);
  EXPECT_THROW(shoot(Branch::oblate, 0.1), NotOnBranch);
  try {
    shoot(Branch::stomatocyte, 0.7);
    FAIL();
  } catch (const NotOnBranch& e) {
    EXPECT_EQ(e.what(),
              std::string("no stomatocyte has reduced volume 0.7: the branch turns back at "
                          "0.660850327"));
  }
}

TEST(SeifertShapes, refuse_wrong_input) {
  for (const double V : {0., -0.5, 1.5, 1 - 1e-9, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(shoot(Branch::oblate, V), std::invalid_argument) << V;
  for (const Options& wrong :
       {Options{0, 1e-3}, Options{1e-3, 1e-3}, Options{1e-13, 0}, Options{1e-13, 0.5}}) {
    EXPECT_THROW(shoot(Branch::oblate, 0.8, wrong), std::invalid_argument);
    EXPECT_THROW(shoot_special_points(wrong), std::invalid_argument);
  }
}

// --- Special points ----------------------------------------------------------------------------------

struct Named {
  const char* name;
  SpecialPoint point;
};
std::vector<Named> all(const SpecialPoints& p) {
  return {{"prolate = oblate", p.prolate_oblate},
          {"oblate = stomatocyte", p.oblate_stomatocyte},
          {"fold of the stomatocytes", p.stomatocyte_fold},
          {"symmetry loss of the oblate", p.oblate_symmetry_loss},
          {"self-contact of the oblate", p.oblate_self_contact}};
}

TEST(SpecialPoints, are_those_of_Seifert_Berndl_and_Lipowsky) {
  const SpecialPoints p = shoot_special_points();
  EXPECT_NEAR(p.prolate_oblate.reduced_volume, 0.651, 5e-4);
  EXPECT_NEAR(p.oblate_stomatocyte.reduced_volume, 0.591, 1e-3);
  EXPECT_NEAR(p.stomatocyte_fold.reduced_volume, 0.66, 5e-3);
  EXPECT_NEAR(p.oblate_symmetry_loss.reduced_volume, 0.51, 5e-3);
  for (const Named& n : all(p)) {
    std::printf("  %-28s V_r = %.14f  F/(8 pi kappa) = %.13f  error %.1e\n", n.name,
                n.point.reduced_volume, n.point.energy, n.point.error);
    EXPECT_LT(n.point.error, 1e-7);
  }
}

TEST(SpecialPoints, lie_within_their_errors_at_every_tolerance_and_series_start) {
  // The same equations in 80-bit arithmetic at a tolerance of 1e-16.
  const double exact[] = {0.65107648384719799, 0.59118907089941922, 0.66085032652289426,
                          0.51043892235217915, 0.50267005840892284};
  for (const double tolerance : {1e-9, 1e-11, 1e-13, 1e-15})
    for (const double start : {1e-2, 1e-3, 1e-4}) {
      const auto points = all(shoot_special_points({tolerance, start}));
      for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(points[i].point.reduced_volume, exact[i], points[i].point.error)
            << points[i].name << ", tolerance " << tolerance << ", series start " << start;
    }
}

TEST(SpecialPoints, are_crossings_of_the_energies) {
  const SpecialPoints p = shoot_special_points();
  const double a = p.prolate_oblate.reduced_volume, b = p.oblate_stomatocyte.reduced_volume;
  EXPECT_NEAR(energy(Branch::prolate, a), energy(Branch::oblate, a), 1e-11);
  EXPECT_NEAR(energy(Branch::stomatocyte, b), energy(Branch::oblate, b), 1e-11);
  EXPECT_NEAR(energy(Branch::oblate, a), p.prolate_oblate.energy, 1e-11);
  EXPECT_NEAR(energy(Branch::oblate, b), p.oblate_stomatocyte.energy, 1e-11);
}

TEST(SpecialPoints, are_where_stomatocytes_end_and_oblates_meet_themselves) {
  const SpecialPoints p = shoot_special_points();
  const double fold = p.stomatocyte_fold.reduced_volume;
  EXPECT_NEAR(energy(Branch::stomatocyte, fold - 1e-10), p.stomatocyte_fold.energy, 1e-9);
  EXPECT_THROW(shoot(Branch::stomatocyte, fold + 1e-10), NotOnBranch);
  const double contact = p.oblate_self_contact.reduced_volume;
  EXPECT_FALSE(shoot(Branch::oblate, contact + 1e-9).self_contact);
  EXPECT_TRUE(shoot(Branch::oblate, contact - 1e-9).self_contact);
}

TEST(SpecialPoints, have_the_symmetry_loss_where_shapes_without_symmetry_shrink_to_the_oblate) {
  // Their V_r − V_r* grows with the square of the asymmetry: a pitchfork.
  const SpecialPoint loss = shoot_special_points().oblate_symmetry_loss;
  const ClassicalShape o = shoot(Branch::oblate, loss.reduced_volume);
  const Eigen::VectorXd odd = Eigen::VectorXd::Unit(full_size, Unknown::H)
                            - Eigen::VectorXd::Unit(full_size, Unknown::other_H);
  double length = 1.4;  // refined from the equator condition
  for (int i = 0; i < 8; ++i) {
    const auto end = integrate(pole_of(o), length);
    length -= (end->state[Row::psi] - pi / 2) / end->rates(Row::psi, 3);
  }
  const auto rise = [&](double difference) {
    Eigen::VectorXd guess(full_size);
    guess << o.H_pole, length, o.tension / multiplier_unit, o.pressure / multiplier_unit,
        o.reduced_volume, o.H_pole, length;
    const auto point = solve(guess + difference / 2 * odd, odd, Options{});
    return point.value().volume() - loss.reduced_volume;
  };
  EXPECT_NEAR(observed_order("V_r - V_r* by the difference of H", {0.4, 0.2, 0.1}, rise), 2, 0.02);
  EXPECT_GT(rise(0.1), 0);
}

}  // namespace
}  // namespace sbeh::axisym
