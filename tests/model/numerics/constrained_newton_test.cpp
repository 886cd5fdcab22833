// Stationary points at fixed measures, against closed solutions.
#include "model/numerics/constrained_newton.h"

#include "model/numerics/constrained_squares.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace sbeh::model {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd solve(const MatrixXd& H, const VectorXd& force) { return H.partialPivLu().solve(force); }

TEST(ConstrainedNewton, solves_a_quadratic_with_linear_measures_in_one_step) {
  // ½ yᵀAy − bᵀy at Jᵀy = m: [A J; Jᵀ 0] (y, λ) = (b, m), indefinite A.
  const MatrixXd A = Eigen::Vector4d(3, -2, 1, 5).asDiagonal();
  const VectorXd b = Eigen::Vector4d(1, 2, 0, -1), m = Eigen::Vector2d(1, -0.5);
  MatrixXd J(4, 2);
  J << 1, 0, 1, 2, 1, -1, 1, 0.5;
  MatrixXd kkt = MatrixXd::Zero(6, 6);
  kkt << A, J, J.transpose(), MatrixXd::Zero(2, 2);
  VectorXd right(6);
  right << b, m;
  const VectorXd exact = kkt.partialPivLu().solve(right).head(4);

  const TangentSplit split(J);
  VectorXd y = Eigen::Vector4d(2, 1, 0, 7);
  y += split.newton_step(split.rotated(A), A * y - b, J.transpose() * y - m, solve);
  EXPECT_LT((y - exact).norm(), 1e-13);
  EXPECT_LT(split.tangential(A * y - b).norm(), 1e-13);
}

TEST(ConstrainedNewton, sees_the_curvature_among_the_directions_that_are_free) {
  const MatrixXd H = Vector3d(-1, 2, 3).asDiagonal();
  const auto eigenvalues = [&](const Vector3d& fixed) -> VectorXd {
    const TangentSplit split(fixed);
    return split.tangential_eigenvalues(split.rotated(H));
  };
  EXPECT_LT((eigenvalues(Vector3d::UnitX()) - Eigen::Vector2d(2, 3)).norm(), 1e-14);
  EXPECT_LT((eigenvalues(-5 * Vector3d::UnitZ()) - Eigen::Vector2d(-1, 2)).norm(), 1e-14);
}

TEST(ConstrainedSquares, project_a_point_on_the_sphere) {
  const Vector3d far(3, -1, 2);
  for (const bool normal_equations : {false, true}) {
    const ConstrainedSquares squares{
        .residuals = 3,
        .unknowns = 3,
        .target = VectorXd::Constant(1, 1.),
        .evaluate =
            [&](const VectorXd& y, auto& values, auto* wanted) {
              if (!(y[0] > 0)) return false;
              values = {y - far, VectorXd::Constant(1, y.squaredNorm())};
              if (wanted) *wanted = {MatrixXd::Identity(3, 3), 2 * y.transpose()};
              return true;
            },
        .penalty = 100,
        .function_tolerance = 1e-14,
        .most_iterations = 500,
        .normal_equations = normal_equations,
        .tolerance = 1e-9};
    VectorXd y = Vector3d(0.1, 0.2, 0.3);
    int iterations = 0;
    ASSERT_TRUE(minimise_squares(squares, VectorXd::Zero(1), y, iterations));
    EXPECT_LT((y - far.normalized()).norm(), 1e-7);  // the root of the tolerance of the function
    EXPECT_GT(iterations, 0);

    y = -y;  // not admitted
    EXPECT_FALSE(minimise_squares(squares, VectorXd::Zero(1), y, iterations));
  }
}

}  // namespace
}  // namespace sbeh::model
