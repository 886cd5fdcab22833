#include "surface3d/linear/conjugate_gradient.h"

#include "tests/surface3d/cases.h"

#include <Eigen/SparseCholesky>

namespace sbeh::surface3d {
namespace {

using namespace test;

SparseMatrix mass() {
  const Surface s = ordered_spheroid(0.8, 80);
  return curvature_of(*s.mesh, s.state.X)->mass;
}

TEST(Mass, is_solved_to_rounding_for_one_and_for_three_right_hand_sides) {
  const SparseMatrix M = mass();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> exact(M);
  const Nodes rhs = Nodes::Random(3, M.rows());
  const Nodes three = solve_mass(M, rhs, Nodes::Zero(3, M.rows()));
  for (int k = 0; k < 3; ++k) {
    const Field b = rhs.row(k).transpose(), x = exact.solve(b);
    EXPECT_LT((solve_mass(M, b, Field::Zero(M.rows())) - x).norm(), 1e-12 * x.norm());
    EXPECT_LT((three.row(k).transpose() - x).norm(), 1e-12 * x.norm());
  }
}

TEST(Mass, of_what_is_solved_already_leaves_the_guess) {
  const SparseMatrix M = mass();
  Nodes rhs = Nodes::Random(3, M.rows());
  rhs.row(1).setZero();
  const Nodes x = solve_mass(M, rhs, Nodes::Zero(3, M.rows()));
  EXPECT_EQ(x.row(1).norm(), 0);
  EXPECT_LT((solve_mass(M, rhs, x) - x).norm(), 1e-12 * x.norm());
}

TEST(Mass, that_is_singular_gives_no_numbers) {
  SparseMatrix M = mass();
  const Field b = Field::Random(M.rows());
  M *= 0;
  EXPECT_FALSE(solve_mass(M, b, b).allFinite());
  M.coeffRef(0, 0) = std::nan("");
  EXPECT_FALSE(solve_mass(M, b, b).allFinite());
}

}  // namespace
}  // namespace sbeh::surface3d
