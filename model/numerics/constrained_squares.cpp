#include "model/numerics/constrained_squares.h"

#include <ceres/ceres.h>

#include <cmath>

namespace sbeh::model {

using Eigen::VectorXd;

namespace {

class Cost : public ceres::CostFunction {
 public:
  Cost(const ConstrainedSquares& squares, const VectorXd& multipliers)
      : shift(multipliers / squares.penalty), squares_(squares), root_(std::sqrt(squares.penalty)) {
    set_num_residuals(int(squares.residuals + squares.target.size()));
    mutable_parameter_block_sizes()->push_back(int(squares.unknowns));
  }

  VectorXd shift;  // λ/μ

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const VectorXd y = Eigen::Map<const VectorXd>(parameters[0], squares_.unknowns);
    const bool wanted = jacobians && jacobians[0];
    Eigen::Map<VectorXd> f(residuals, num_residuals());
    ConstrainedSquares::Values at;
    ConstrainedSquares::Jacobians by_y;
    if (!squares_.evaluate(y, at, wanted ? &by_y : nullptr)) {
      f.setConstant(1e6);
      return !wanted;
    }
    f << at.residuals, root_ * (at.measures - squares_.target + shift);
    if (wanted)
      Eigen::Map<RowMajor>(jacobians[0], f.size(), squares_.unknowns) << by_y.residuals,
          root_ * by_y.measures;
    return true;
  }

 private:
  const ConstrainedSquares& squares_;
  double root_;
};

}  // namespace

bool minimise_squares(const ConstrainedSquares& squares, const VectorXd& multipliers, VectorXd& y,
                      int& iterations) {
  constexpr int most_shifts = 10;
  Cost cost(squares, multipliers);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, y.data());
  ceres::Solver::Options solver;
  solver.linear_solver_type =
      squares.normal_equations ? ceres::DENSE_NORMAL_CHOLESKY : ceres::DENSE_QR;
  solver.logging_type = ceres::SILENT;
  solver.function_tolerance = squares.function_tolerance;
  const int last = iterations + squares.most_iterations;
  for (int i = 0; i < most_shifts && iterations < last; ++i) {
    solver.max_num_iterations = last - iterations;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    if (summary.termination_type == ceres::FAILURE) return false;
    iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
    ConstrainedSquares::Values at;
    if (!squares.evaluate(y, at, nullptr)) return false;
    const VectorXd miss = at.measures - squares.target;
    if (miss.cwiseAbs().maxCoeff() < squares.tolerance) break;
    cost.shift += miss;
  }
  return true;
}

}  // namespace sbeh::model
