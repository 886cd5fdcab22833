// Least squares at given measures: an augmented Lagrangian, minimised by Ceres.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace sbeh::model {

/// ½ Σ f² of residuals f(y), and measures which shall become `target`.
struct ConstrainedSquares {
  struct Values {
    Eigen::VectorXd residuals, measures;
  };
  struct Jacobians {
    Eigen::MatrixXd residuals, measures;  // a row for each
  };
  Eigen::Index residuals, unknowns;
  Eigen::VectorXd target;
  /// False where y is not admitted: no step leads there. Jacobians only where wanted.
  std::function<bool(const Eigen::VectorXd& y, Values& values, Jacobians* wanted)> evaluate;

  double penalty;             ///< μ > 0 on the squared misses of the measures
  double function_tolerance;  ///< relative, of one minimisation
  int most_iterations;        ///< of all together
  bool normal_equations;      ///< faster than QR, less accurate
  double tolerance = 1e-5;    ///< on the misses
};

/// Minimises ½ Σ f² + ½μ Σ (measure − target + λ/μ)² and shifts λ, from these multipliers, until the misses
/// are small. Adds to `iterations`. False where Ceres fails.
bool minimise_squares(const ConstrainedSquares& squares, const Eigen::VectorXd& multipliers,
                      Eigen::VectorXd& y, int& iterations);

}  // namespace sbeh::model
