// Minimisation over spectral curves: geometric convergence, identities of the minima, and refusal of whatever
// is not the shape asked for.
#include "axisym/stationary/branch_entry.h"
#include "model/numerics/constrained_newton.h"
#include "tests/axisym/spectral/cases.h"

#include <cstdio>

namespace sbeh::axisym {
namespace {

using namespace test;

// --- the classical shapes

// F/(8πκ) on a basis of this cutoff.
double energy_with(int cutoff, Branch branch, double reduced_volume, const Curve& near) {
  const auto found =
      sharpen(branch, reduced_volume, on_basis(near, basis_for(branch, reduced_volume, cutoff)));
  EXPECT_TRUE(found) << name(branch) << " with cutoff " << cutoff;
  return found ? found->reduced_energy() : 0;
}

TEST(SpectralMinimiser, converges_geometrically_in_the_number_of_modes) {
  struct Row {
    Branch branch;
    double reduced_volume;
    std::vector<int> cutoffs;
    double factor;  // at least, from one cutoff to the next
  };
  const Row rows[] = {{Branch::oblate, 0.95, {4, 6, 8, 10}, 20},
                      {Branch::oblate, 0.6, {8, 12, 16, 20}, 20},
                      {Branch::prolate, 0.8, {8, 12, 16, 20}, 8},
                      {Branch::prolate, 0.6, {12, 18, 24, 30}, 20},
                      {Branch::stomatocyte, 0.6, {20, 28, 36, 44}, 4},
                      {Branch::stomatocyte, 0.5, {24, 32, 40, 48}, 4}};
  for (const Row& row : rows) {
    const ClassicalMinimum exact = minimum(row.branch, row.reduced_volume).value();
    std::printf("%-11s %.2f ", name(row.branch), row.reduced_volume);
    double before = 0;
    for (const int cutoff : row.cutoffs) {
      const double error =
          std::abs(energy_with(cutoff, row.branch, row.reduced_volume, exact.curve())
                   - exact.reduced_energy());
      std::printf("  K = %d: %.1e", cutoff, error);
      if (before > 0) {
        EXPECT_LT(error, before / row.factor + 1e-13);
      }
      before = error;
    }
    std::printf("\n");
    EXPECT_LT(before, 1e-9) << name(row.branch) << row.reduced_volume;
  }
}

TEST(SpectralMinimiser, oblate_at_0_8_has_the_known_energy) {
  EXPECT_NEAR(classical(Branch::oblate, 0.8).energy, 1.4525386, 5e-8);
}

TEST(SpectralMinimiser, pressure_and_tension_balance_under_scaling) {
  for (const Branch branch : branches)
    for (const double v : {0.45, 0.55, 0.65}) {
      const ClassicalShape s = classical(branch, v);
      EXPECT_NEAR(3 * s.pressure * 4 * pi / 3 * v, 2 * s.tension * 4 * pi, 1e-10)
          << name(branch) << " " << v;
    }
}

TEST(SpectralMinimiser, pressure_is_the_slope_of_the_energy) {
  for (const Branch branch : branches)
    for (const double v : {0.5, 0.6, 0.64}) {
      const double slope =
          difference([&](double t) { return classical(branch, v + t).energy; }, 1e-3);
      // The stomatocyte's fifth derivative is about 1e6 close to its fold.
      EXPECT_NEAR(classical(branch, v).pressure, 6 * slope, v < 0.61 ? 1e-7 : 1e-5)
          << name(branch) << " " << v;
    }
}

TEST(SpectralMinimiser, profile_is_the_shape) {
  for (const Branch branch : branches) {
    const ClassicalShape s = classical(branch, 0.6);
    double area = 0, volume = 0;
    for (Eigen::Index i = 1; i < s.profile.cols(); ++i) {
      const Eigen::Vector2d a = s.profile.col(i - 1), b = s.profile.col(i);
      area += pi * (a[0] + b[0]) * (b - a).norm();
      volume -= pi / 3 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]);
    }
    // A polygon of 256 edges: errors of order (curvature · edge)²/12.
    EXPECT_NEAR(area, 4 * pi, 1e-3 * 4 * pi);
    EXPECT_NEAR(volume, 0.6 * 4 * pi / 3, 2e-3);
    EXPECT_FALSE(s.self_contact);
    EXPECT_EQ(s.H_pole > 0, branch != Branch::prolate);
  }
}

// From the polygon of a shape nearby, on as many modes as it determines well.
std::optional<ClassicalMinimum> minimum_near(const ClassicalShape& near, Branch branch, double v) {
  const double start = near.reduced_volume;
  return minimum_along(branch, v, start, curve_through(near.profile, basis_for(branch, start, 24)));
}

TEST(SpectralMinimiser, start_does_not_matter) {
  for (const Branch branch : branches) {
    const auto warm = minimum_near(classical(branch, 0.5), branch, 0.62);
    ASSERT_TRUE(warm);
    EXPECT_NEAR(warm->reduced_energy(), classical(branch, 0.62).energy, rounding);
    const double volumes[] = {0.64, 0.55, 0.62};
    const auto sweep = minimise_branch(branch, volumes);
    ASSERT_EQ(sweep.size(), 3u);
    EXPECT_NEAR(sweep[2].energy, warm->reduced_energy(), rounding);
  }
}

TEST(SpectralMinimiser, never_returns_another_branch) {
  const ClassicalShape oblate = classical(Branch::oblate, 0.7),
                       cup = classical(Branch::stomatocyte, 0.6),
                       prolate = classical(Branch::prolate, 0.7);
  EXPECT_FALSE(minimum_near(prolate, Branch::oblate, 0.7));
  EXPECT_FALSE(minimum_near(oblate, Branch::prolate, 0.7));
  EXPECT_FALSE(minimum_near(oblate, Branch::stomatocyte, 0.6));
  EXPECT_FALSE(minimum_near(prolate, Branch::stomatocyte, 0.6));
  EXPECT_FALSE(minimum_near(cup, Branch::prolate, 0.6));
  EXPECT_FALSE(minimise_classical(Branch::stomatocyte, 0.7));  // beyond the fold
  const double volumes[] = {0.6, 0.65, 0.7, 0.64};
  EXPECT_EQ(minimise_branch(Branch::stomatocyte, volumes).size(), 3u);
}

TEST(SpectralMinimiser, refuses_impossible_volumes) {
  for (const double v : {-0.1, 0., 1., 1.2, std::nan("")}) {
    EXPECT_THROW(minimise_classical(Branch::oblate, v), std::invalid_argument) << v;
    EXPECT_THROW(minimise_energy(Material{}, model::Model::SBEH, v), std::invalid_argument) << v;
  }
  EXPECT_THROW(minimise_energy(Material{}.with_L(-1), model::Model::SBEH, 0.6),
               std::invalid_argument);
}

// --- special points

TEST(SpectralPoints, are_what_their_names_say) {
  const SpecialPoints p = minimise_special_points();
  for (const SpecialPoint& point : {p.prolate_oblate, p.oblate_stomatocyte, p.stomatocyte_fold,
                                    p.oblate_symmetry_loss, p.oblate_self_contact})
    EXPECT_LT(point.error, 1e-10);

  const double one = p.prolate_oblate.reduced_volume;
  EXPECT_NEAR(classical(Branch::prolate, one).energy, classical(Branch::oblate, one).energy,
              rounding);
  EXPECT_NEAR(classical(Branch::oblate, one).energy, p.prolate_oblate.energy, rounding);

  const double two = p.oblate_stomatocyte.reduced_volume;
  EXPECT_NEAR(classical(Branch::oblate, two).energy, classical(Branch::stomatocyte, two).energy,
              rounding);

  const double fold = p.stomatocyte_fold.reduced_volume;
  EXPECT_TRUE(minimise_classical(Branch::stomatocyte, fold - 1e-4));
  EXPECT_FALSE(minimise_classical(Branch::stomatocyte, fold + 1e-5));

  const double contact = p.oblate_self_contact.reduced_volume;
  EXPECT_FALSE(classical(Branch::oblate, contact + 1e-4).self_contact);
  EXPECT_TRUE(classical(Branch::oblate, contact - 1e-3).self_contact);

  // The odd variations of the oblate: stable above, not below.
  const double loss = p.oblate_symmetry_loss.reduced_volume;
  for (const double side : {1e-3, -1e-3}) {
    const Curve oblate = minimum(Branch::oblate, loss + side).value().curve();
    const Problem whole = Problem::classical(basis(Symmetry::none, 36));
    const VectorXd y = pack(on_basis(oblate, whole.basis));
    const Expansion e = expand(whole, y).value();
    const model::TangentSplit split(e.jacobian.transpose());
    const double lowest =
        split.tangential_eigenvalues(split.rotated(hessian(whole, y, estimate_multipliers(e))))[0];
    EXPECT_EQ(lowest > 0, side > 0) << lowest;
  }
}

TEST(SpectralPoints, stiffness_falls_to_the_fold_like_a_square_root) {
  const double fold = minimise_special_points().stomatocyte_fold.reduced_volume;
  // One basis for both, because the eigenvalue depends on the parameter of the curve.
  const auto on = basis_for(Branch::stomatocyte, 0.66, 72);
  const auto stiffness_at = [&](double distance) {
    const Curve start = minimum(Branch::stomatocyte, fold - distance).value().curve();
    return sharpen(Branch::stomatocyte, fold - distance, on_basis(start, on))
        .value()
        .state.stiffness;
  };
  // The next term of the series is linear in the distance: 0.7 √distance of the first.
  EXPECT_NEAR(stiffness_at(1.2e-4) / stiffness_at(3e-5), 2, 0.03);
}

// --- shape and order together

constexpr double some_L[] = {0.01, 0.03, 0.05, 0.07};

TEST(OrderedMinimiser, energy_changes_with_L_by_the_elastic_energy) {
  for (const double v : {0.6, 0.8})
    for (const double L : {0.03, 0.05}) {
      const auto U = [&](double t) { return ordered(Material{}.with_L(L + t), v).energy; };
      const auto parts = ordered(Material{}.with_L(L), v).parts;
      EXPECT_NEAR((parts.distortion + parts.bending + parts.gaussian) / L, difference(U, 2e-4),
                  1e-6)
          << v << " " << L;
    }
}

TEST(OrderedMinimiser, energy_changes_with_volume_by_the_pressure) {
  for (const Branch start : {Branch::oblate, Branch::prolate}) {
    const auto U = [&](double t) { return ordered(Material{}, 0.7 + t, start).energy; };
    EXPECT_NEAR(ordered(Material{}, 0.7, start).pressure * 4 * pi / 3, difference(U, 1e-3), 1e-7);
  }
}

TEST(OrderedMinimiser, pressure_and_tension_balance_under_scaling) {
  Material general;
  general.L1 = 0.04, general.L2 = 0.02, general.L3 = -0.01;
  general.residual_stiffness = 0.02;
  for (const Material& material : {Material{}, general}) {
    const EnergyMinimum m = ordered(material, 0.65);
    // All parts but u are the same at every size.
    EXPECT_NEAR(3 * m.pressure * 4 * pi / 3 * 0.65 - 2 * m.tension * 4 * pi,
                2 * m.parts.thermotropic, 1e-10);
    EXPECT_NEAR(m.parts.total(), m.energy, rounding);
  }
}

TEST(OrderedMinimiser, order_lowers_the_energy_and_is_smallest_where_the_shape_bends) {
  for (const double v : {0.6, 0.7, 0.8}) {
    const ClassicalShape fixed = classical(Branch::oblate, v);
    double gap_before = 0;
    for (const double L : some_L) {
      const EnergyMinimum m = ordered(Material{}.with_L(L), v);
      // β = 2/3: κ = 2L, ∫κ_G K = −8πL, u = −1.
      const double gap = 16 * pi * L * fixed.energy - 8 * pi * L - 4 * pi - m.energy;
      EXPECT_GT(gap, gap_before) << v << " " << L;
      gap_before = gap;
      const Eigen::Index equator = m.profile.beta.size() / 2;
      EXPECT_NEAR(m.profile.beta[equator], m.order_min, 1e-9) << v << " " << L;
      EXPECT_LT(m.profile.beta.maxCoeff(), model::full_order);
      EXPECT_GT(m.stiffness, 0);
    }
  }
}

TEST(OrderedMinimiser, small_L_leaves_the_classical_shape) {
  const ClassicalShape fixed = classical(Branch::oblate, 0.7);
  const auto miss = [&](double L) {
    const EnergyMinimum m = ordered(Material{}.with_L(L), 0.7);
    return (m.energy + 4 * pi) / (16 * pi * L) + 0.5 - fixed.energy;
  };
  EXPECT_NEAR(miss(1e-3) / miss(5e-4), 2, 0.02);  // linear in L
}

// The stiffness of an ordered stomatocyte falls like √(L* − L): its squares on a line, from two L.
TEST(OrderedMinimiser, of_stomatocytes_ends_in_the_fold_that_the_finite_elements_find) {
  const double v = 0.6, first = 3.12e-4, second = 3.13e-4;
  const auto squared = [&](double L) {
    return std::pow(ordered(Material{}.with_L(L), v, Branch::stomatocyte).stiffness, 2);
  };
  const double a = squared(first), b = squared(second);
  const double fold = (first * b - second * a) / (b - a);
  const Material material = Material{}.with_L(1e-5);
  Numerics numerics;
  numerics.elements = 96;
  const auto entry = enter_branch(Branch::stomatocyte, material, numerics);
  ASSERT_TRUE(entry);
  const FollowResult ssh = follow(material, model::Model::SSH, entry->state, {v, 1e-5}, numerics);
  const NewtonResult r = solve_stationary(material, model::Model::SBEH, target_of(v),
                                          guess_from(material, model::Model::SBEH, ssh.state));
  ASSERT_EQ(r.status, NewtonStatus::converged);
  const FollowResult end =
      follow(material, model::Model::SBEH, {r.state, {v, 1e-5}}, {v, 1e-3}, numerics);
  ASSERT_EQ(end.arrival, Arrival::fold);
  std::printf("  L* = %.8f by the stiffness, %.8f by 96 elements\n", fold, end.state.at.L);
  EXPECT_NEAR(end.state.at.L / fold, 1, 2e-4);  // the elements' error falls with their number: 3e-5
  EXPECT_TRUE(minimise_energy(Material{}.with_L(0.9999 * fold), model::Model::SBEH, v,
                              Branch::stomatocyte));
  EXPECT_FALSE(
      minimise_energy(Material{}.with_L(1.001 * fold), model::Model::SBEH, v, Branch::stomatocyte));
}

TEST(OrderedMinimiser, is_empty_beyond_the_fold) {
  EXPECT_TRUE(minimise_energy(Material{}.with_L(0.0706), model::Model::SBEH, 0.6));
  EXPECT_FALSE(minimise_energy(Material{}.with_L(0.072), model::Model::SBEH, 0.6));
}

}  // namespace
}  // namespace sbeh::axisym
