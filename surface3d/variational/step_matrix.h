// The matrix of Newton's method in a step, known roughly: the Hessian of a state nearby, and factors of an earlier step.
#pragma once

#include "surface3d/linear/gmres.h"
#include "surface3d/options.h"
#include "surface3d/variational/step_functional.h"

namespace sbeh::surface3d {

/// That of τD/2 as it is, and the Hessian of U as it was where the matrix was factored last.
class StepMatrix {
 public:
  StepMatrix(const StepLayout& layout, const Numerics& numerics);

  /// Takes the Hessian at a state that moves along these normals, and factors it with `resistance`. False where that is singular.
  [[nodiscard]] bool factor(const model::Material& material, const StationaryState& state,
                            const Nodes& normals, const StepResistance& resistance);
  /// Whether the matrix was that of a minimum when it was factored.
  bool minimum() const { return minimum_; }
  /// What factoring costs, in applications of the factors.
  double cost_of_factoring() const { return gmres_.cost_of_factoring(); }

  /// Of a step: from now on with its resistance, which must live as long.
  void begin(const StepResistance& resistance);
  /// Solves with A, V and the other conditions of a step, as `energy` has them. Returns how often the
  /// factors were applied; 0 where they are too far from the matrix.
  int solve(const LagrangianGradient& energy, const Eigen::VectorXd& rhs, Eigen::VectorXd& x) const;

 private:
  Eigen::MatrixXd borders(const StepResistance& resistance, const LagrangianGradient& energy) const;
  void set_sum(const StepResistance& resistance);

  const StepLayout& layout_;
  LagrangianDerivatives energy_{};
  SparseMatrix sum_, bordered_;
  const StepResistance* resistance_ = nullptr;
  Gmres gmres_;
  bool minimum_ = false;
};

}  // namespace sbeh::surface3d
