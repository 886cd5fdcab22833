// Eigenvalues of the second variation: closed forms on the sphere, rigid motions, pitchforks.
#include "axisym/modes/stability_3d.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/ssh_branch.h"
#include "axisym/stationary/stability.h"
#include "model/order_step.h"
#include "tests/axisym/cases.h"
#include "tests/axisym/modes/states.h"

#include <Eigen/Eigenvalues>

namespace sbeh::axisym {
namespace {

using namespace test;
using model::Material;
using model::Model;

// The lowest eigenvalues of m against those of l = m, m + 1, … with the parity of l − m.
template <class Exact>
void expect_eigenvalues(const SecondVariation& second, int m, Exact&& exact, double accuracy) {
  const auto found = lowest_modes(second, m, 2);
  ASSERT_TRUE(found);
  const int first = std::max(m, 2);
  for (std::size_t k = 0; k < 3; ++k) {
    const int l = first + int(k);
    const Eigenmode& mode = found->modes[k];
    EXPECT_EQ(mode.parity, (l - m) % 2 == 0 ? Parity::even : Parity::odd) << m << ' ' << l;
    EXPECT_NEAR(mode.eigenvalue / exact(l), 1, accuracy) << "m = " << m << ", l = " << l;
  }
  EXPECT_LT(found->rigid_residual, accuracy * exact(first)) << m;
}

// Of an odd number of elements the equator cuts one.
TEST(Eigenmodes, of_the_SSH_sphere_are_those_of_the_harmonics) {
  const Material material;
  const double kappa = material.kappa(model::full_order);
  for (const auto& [elements, accuracy] : {std::pair{48, 2e-7}, {49, 2e-7}, {96, 1e-8}})
    for (const double tension : {0., 0.1, -0.3})
      for (int m = 0; m <= 5; ++m)
        expect_eigenvalues(
            second_variation(
                material, Model::SSH,
                sphere_at_rest(material, Model::SSH, model::full_order, tension, elements)),
            m, [&](int l) { return (l - 1) * (l + 2) * (kappa * l * (l + 1) + tension); },
            accuracy);
}

TEST(Eigenmodes, of_the_SBEH_sphere_are_those_of_shape_and_order_together) {
  for (const double L : {0.01, 0.05}) {
    const Material material = Material{}.with_L(L);
    const double order = model::sphere_rest_order(material).value();
    const double kappa = material.kappa(order), tension = 0.05;
    const double curvature = (182.25 * order - 81) * order;  // u″ of the paper's potential
    const auto exact = [&](int l) {
      const double bend = (l - 1) * (l + 2);
      Eigen::Matrix2d form;
      form << bend * (kappa * l * (l + 1) + tension), 9 * L * order * bend, 9 * L * order * bend,
          1.5 * L * l * (l + 1) + 9 * L + curvature;
      return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(form).eigenvalues()[0];
    };
    for (int m = 0; m <= 4; ++m)
      expect_eigenvalues(
          second_variation(material, Model::SBEH,
                           sphere_at_rest(material, Model::SBEH, order, tension, 96)),
          m, exact, 1e-8);
  }
}

// Whatever the state: bumpy, of varying order, with all terms on.
TEST(SecondVariation, of_m_0_is_that_of_the_axisymmetric_Lagrangian) {
  Material material;
  material.L2 = 0.01;
  material.L3 = 0.02;
  material.residual_stiffness = 0.03;
  material.spontaneous_curvature = -0.7;
  material.flexoelectric = model::Polynomial({0.3, -0.8, 0.5});
  State shape{spheroid(0.8, false, 12, 0.5), Field::Constant(37, 0.6)};
  for (Eigen::Index i = 0; i < 37; ++i) {
    const double s = double(i) / 36;
    shape.X.col(i) *= 1 + 0.1 * std::sin(3 * s) * s;
    shape.beta[i] += 0.05 * std::cos(5 * s);
  }
  const StationaryState state = guess_from(material, Model::SBEH, shape);
  const auto second = second_variation(material, Model::SBEH, state);
  LagrangianDerivatives axisymmetric({12, false});
  assemble(material, state, node_normals(state.X), axisymmetric);
  const int size = axisymmetric.hessian.size(), width = axisymmetric.hessian.half_width();
  double largest = 0, difference = 0;
  for (int j = 0; j < size; ++j) {
    const Eigen::VectorXd column = 2 * pi * second.powers[0].times(Eigen::VectorXd::Unit(size, j));
    for (int i = std::max(0, j - width); i <= std::min(size - 1, j + width); ++i) {
      const double there = axisymmetric.hessian(i, j);
      largest = std::max(largest, std::abs(there));
      difference = std::max(difference, std::abs(column[i] - there));
    }
  }
  EXPECT_LT(difference, 1e-13 * largest);
}

// The shapes of the paper's scan.
TEST(Eigenmodes, of_rigid_motions_are_zero) {
  const auto expect_zero = [](const Material& material, Model model,
                              const std::optional<BranchState>& state) {
    ASSERT_TRUE(state);
    const auto second = second_variation(material, model, *state);
    for (const int m : {0, 1}) {
      const auto found = lowest_modes(second, m, 1);
      ASSERT_TRUE(found);
      EXPECT_GT(found->rigid_residual, 0);
      EXPECT_LT(found->rigid_residual, 1e-8 * std::abs(found->modes.front().eigenvalue)) << m;
    }
  };
  for (const double v : {0.6, 0.7, 0.8}) {
    expect_zero({}, Model::SSH, ssh_oblate(v, 96));
    for (const double L : {0.01, 0.03, 0.05, 0.07}) {
      SCOPED_TRACE(std::to_string(v) + ' ' + std::to_string(L));
      expect_zero(Material{}.with_L(L), Model::SBEH, ordered_oblate(v, L, 96));
    }
  }
}

// Without up-down symmetry no parity tells translations from rotations.
TEST(Eigenmodes, of_stomatocytes_know_rigid_motions_too) {
  SshBranch branch(Branch::stomatocyte, Material{}, Numerics{});
  for (const double v : {0.45, 0.55, 0.6}) {
    const auto found = branch.at(v);
    ASSERT_TRUE(found && found->arrival == Arrival::reached);
    const auto modes = stability_3d({}, Model::SSH, found->state, 4);
    ASSERT_TRUE(modes);
    EXPECT_LT(modes->rigid_residual, 1e-3 * modes->eigenvalue[1]) << v;
    EXPECT_EQ(modes->negative_directions, 0) << v;
  }
}

// Stomatocytes leave the oblates at V_r = 0.51043892: the odd mode of m = 0.
TEST(Eigenmodes, vanish_where_the_oblate_loses_its_symmetry) {
  const std::array at{0.5104, 0.5105};
  std::array<double, 2> eigenvalue{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto state = ssh_oblate(at[k], 96);
    ASSERT_TRUE(state);
    const auto found = lowest_modes(second_variation({}, Model::SSH, *state), 0, 1);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->modes.front().parity, Parity::odd);
    eigenvalue[k] = found->modes.front().eigenvalue;
    EXPECT_EQ(negative_directions({}, Model::SSH, *state), eigenvalue[k] < 0 ? 1 : 0);
  }
  const double zero = at[0] - eigenvalue[0] * (at[1] - at[0]) / (eigenvalue[1] - eigenvalue[0]);
  EXPECT_NEAR(zero, 0.51043892, 2e-8);
}

// It gives way to the prolate by m = 2 at V_r = 0.7497; by no other m ≥ 1.
TEST(Eigenmodes, of_the_SSH_oblate_change_sign_for_m_2_alone) {
  for (const double v : {0.52, 0.6, 0.7, 0.749, 0.7504, 0.85, 0.95}) {
    const auto state = ssh_oblate(v, 48);
    ASSERT_TRUE(state);
    const auto second = second_variation({}, Model::SSH, *state);
    for (int m = 1; m <= 5; ++m) {
      const auto found = lowest_modes(second, m, 1);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->modes.front().eigenvalue < 0, m == 2 && v > 0.7497) << v << ' ' << m;
    }
  }
}

// Among shapes with an axis it is a minimum.
TEST(Eigenmodes, of_the_ordered_oblate_of_0_6_and_0_07_are_negative_for_m_1_and_2) {
  const auto state = ordered_oblate(0.6, 0.07, 48);
  ASSERT_TRUE(state);
  const Material material = Material{}.with_L(0.07);
  EXPECT_EQ(negative_directions(material, Model::SBEH, *state), 0);
  const auto modes = stability_3d(material, Model::SBEH, *state, 4);
  ASSERT_TRUE(modes);
  EXPECT_EQ(modes->unstable, (std::vector{1, 2}));
  EXPECT_EQ(modes->negative_directions, 4);
  for (int m = 0; m <= most_modes; ++m)
    EXPECT_EQ(std::isnan(modes->eigenvalue[std::size_t(m)]), m > 4);
  EXPECT_LT(modes->rigid_residual, 1e-6);
}

// They are looked for first above a multiple of the stiffness; this prolate has one of −7 and the next of its parity
// nearer to zero.
TEST(Eigenmodes, are_the_lowest_however_far_below_zero) {
  SshBranch branch(Branch::prolate, Material{}, Numerics{});
  const auto ssh = branch.at(0.594);
  const auto first = ssh ? solve_at({}, Model::SBEH, {0.594, 1e-4}, ssh->state) : std::nullopt;
  ASSERT_TRUE(first);
  const FollowResult there = follow({}, Model::SBEH, *first, {0.594, 0.12}, Numerics{});
  ASSERT_EQ(there.arrival, Arrival::reached);
  auto second = second_variation(Material{}.with_L(0.12), Model::SBEH, there.state);
  const double whole = second.stiffness;
  for (const double share : {10., 1., 0.1, 0.001}) {
    second.stiffness = share * whole;
    const auto found = lowest_modes(second, 2, 1);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->modes.front().eigenvalue, -7.02617, 1e-5) << share;
  }
}

}  // namespace
}  // namespace sbeh::axisym
