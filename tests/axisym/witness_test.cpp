// Finite elements, shooting and minimisation must agree on the classical shapes, and the first and the
// last on the ordered ones.

#include "axisym/shape_class.h"
#include "axisym/shooting/seifert_shooting.h"
#include "axisym/spectral/minimiser.h"
#include "axisym/stationary/branch_entry.h"
#include "axisym/stationary/classical_branches.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/stability.h"
#include "tests/axisym/cases.h"
#include "tests/model/densely.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace sbeh::axisym::test {
namespace {

const std::vector<double> symmetric_volumes{0.95, 0.9, 0.85, 0.8, 0.75, 0.7, 0.65, 0.6};
const std::vector<double> stomatocyte_volumes{0.6, 0.55};

Numerics fine() { return with_elements(96); }

struct Witnesses {
  std::vector<ClassicalShape> elements, shooting, minimiser;
};
Witnesses witnesses(Branch branch, const std::vector<double>& volumes) {
  return {ElementBranches(fine()).shapes(branch, volumes), shoot_branch(branch, volumes),
          minimise_branch(branch, volumes)};
}

void expect_agreement(Branch branch, const std::vector<double>& volumes) {
  const Witnesses w = witnesses(branch, volumes);
  ASSERT_EQ(w.minimiser.size(), volumes.size());
  for (std::size_t k = 0; k < volumes.size(); ++k) {
    SCOPED_TRACE(testing::Message() << name(branch) << " " << volumes[k]);
    EXPECT_NEAR(w.elements[k].energy, w.shooting[k].energy, 1e-8);
    EXPECT_NEAR(w.minimiser[k].energy, w.shooting[k].energy, 1e-10);
    // Pole curvatures are extrapolated from elements at distance h: h⁴ with h about 0.05.
    EXPECT_NEAR(w.elements[k].H_pole, w.shooting[k].H_pole, 2e-5);
    EXPECT_NEAR(w.minimiser[k].H_pole, w.shooting[k].H_pole, 1e-8);
    EXPECT_NEAR(w.minimiser[k].pressure, w.shooting[k].pressure, 1e-8);
    EXPECT_NEAR(w.elements[k].tension, 3 * w.elements[k].pressure * volumes[k] / 6,
                1e-5);  // 3PV = 2ΣA
  }
}

TEST(ThreeWitnesses, agree_on_the_oblates) { expect_agreement(Branch::oblate, symmetric_volumes); }
TEST(ThreeWitnesses, agree_on_the_prolates) {
  expect_agreement(Branch::prolate, symmetric_volumes);
}
TEST(ThreeWitnesses, agree_on_the_stomatocytes) {
  expect_agreement(Branch::stomatocyte, stomatocyte_volumes);
}

TEST(ThreeWitnesses, agree_on_the_special_points_within_their_errors_and_to_five_digits) {
  const SpecialPoints a = ElementBranches(fine()).special_points_with_errors(),
                      b = shoot_special_points(), c = minimise_special_points();
  for (const auto member : {&SpecialPoints::prolate_oblate, &SpecialPoints::oblate_stomatocyte,
                            &SpecialPoints::stomatocyte_fold, &SpecialPoints::oblate_symmetry_loss,
                            &SpecialPoints::oblate_self_contact}) {
    const SpecialPoint p = a.*member, q = b.*member, r = c.*member;
    std::printf("  %.10f +- %.0e   %.12f +- %.0e   %.12f +- %.0e\n", p.reduced_volume, p.error,
                q.reduced_volume, q.error, r.reduced_volume, r.error);
    EXPECT_LE(std::abs(p.reduced_volume - q.reduced_volume), p.error + q.error);
    EXPECT_LE(std::abs(r.reduced_volume - q.reduced_volume), r.error + q.error);
    EXPECT_LT(p.error, 5e-6);
    EXPECT_LT(q.error, 1e-9);
    EXPECT_NEAR(p.energy, q.energy, 5e-6);
    EXPECT_NEAR(r.energy, q.energy, 1e-9);
  }
}

// The finite elements' state of the ordered oblate is that of the branch, not a minimisation.
TEST(TwoWitnesses, agree_on_the_ordered_oblates_of_the_paper) {
  for (const double v : {0.6, 0.7, 0.8})
    for (const double L : {0.01, 0.03, 0.05, 0.07}) {
      const auto minimum = minimise_energy(paper_material(L), Model::SBEH, v);
      ASSERT_TRUE(minimum) << v << " " << L;
      const BranchState b = oblate(model::Model::SBEH, {v, L}, Numerics{}.elements);
      const double U = energy_of(paper_material(L), b).total();
      EXPECT_NEAR(U / minimum->energy, 1, 2e-9) << v << " " << L;
    }
}

// Negative eigenvalues of the whole matrix less those that the multipliers bring.
int negative_directions_densely(const Material& material, Model model, const StationaryState& s) {
  const int n = int(s.beta.size()), size = node_unknowns * n;
  LagrangianDerivatives L({n / 3, false});
  assemble(felt_material(material, model), s, node_normals(s.X), L);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size + 2, size + 2);
  K.topLeftCorner(size, size) = densely(L.hessian);
  K.topRightCorner(size, 2) = L.constraints;
  K.bottomLeftCorner(2, size) = L.constraints.transpose();
  for_each_pinned(model, L.sector, [&](int i) {
    K.row(i).setZero();
    K.col(i).setZero();
    K(i, i) = 1;
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K, Eigen::EigenvaluesOnly);
  return int((eigen.eigenvalues().array() < 0).count()) - n - 2;
}

TEST(NegativeDirections, are_those_of_the_dense_matrix_on_either_side_of_the_pitchfork) {
  const Numerics numerics = with_elements(32);
  const Material material = paper_material(0.05);
  BranchState b = enter_branch(Branch::oblate, material, numerics)->state;
  for (const auto& [v, expected] : {std::pair{0.9, 0}, {0.6, 0}, {0.52, 0}, {0.5, 1}, {0.4, 1}}) {
    b = follow(material, Model::SSH, b, {v, material.L1}, numerics).state;
    ASSERT_EQ(b.at.reduced_volume, v);
    EXPECT_EQ(negative_directions(material, Model::SSH, b), expected) << v;
    EXPECT_EQ(negative_directions_densely(material, Model::SSH, b), expected) << v;
  }
  const BranchState ordered = oblate(Model::SBEH, {0.7, 0.03}, 32);
  EXPECT_EQ(negative_directions(paper_material(0.03), Model::SBEH, ordered), 0);
  EXPECT_EQ(negative_directions_densely(paper_material(0.03), Model::SBEH, ordered), 0);
}

TEST(ShapeClass, is_told_of_the_classical_shapes) {
  const Numerics numerics = with_elements(32);
  const std::array<double, 1> at{0.58};
  for (const auto& [branch, shape] : {std::pair{Branch::oblate, ShapeClass::oblate},
                                      {Branch::prolate, ShapeClass::prolate},
                                      {Branch::stomatocyte, ShapeClass::stomatocyte}}) {
    const Nodes X = ElementBranches(numerics).shapes(branch, at).front().profile;
    EXPECT_EQ(classify(X), shape) << name(branch);
    EXPECT_FALSE(crosses_itself(X)) << name(branch);
  }
}

TEST(SelfContact, of_the_oblates_begins_where_their_poles_touch) {
  const Numerics numerics = with_elements(48);
  const std::array<double, 2> volumes{0.504, 0.501};
  const auto shapes = ElementBranches(numerics).shapes(Branch::oblate, volumes);
  EXPECT_FALSE(shapes[0].self_contact);
  EXPECT_TRUE(shapes[1].self_contact);
}

TEST(Stomatocytes, beyond_their_fold_are_refused_with_the_reduced_volume) {
  const std::array<double, 1> beyond{0.67};
  try {
    ElementBranches(with_elements(32)).shapes(Branch::stomatocyte, beyond);
    FAIL() << "accepted";
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("0.67"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sbeh::axisym::test
