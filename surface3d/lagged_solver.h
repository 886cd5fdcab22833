// The linear systems of a run, which change little from one step to the next: old factors, renewed when
// that is cheaper, and a few iterations from a guess that earlier solutions give.
#pragma once

#include "surface3d/linear/gmres.h"
#include "surface3d/options.h"
#include "surface3d/surface.h"

#include <optional>

namespace sbeh::surface3d {

class CoupledSystem;

/// Solutions of the linear systems of a step, in their numbering.
struct Solution {
  Eigen::VectorXd flow, motion;  ///< empty before the first step
  double tau = 0;
};

/// What a solver remembers of the past: where its factors come from, and what its iterations begin with.
/// With it a resumed run repeats the bits of one that was not interrupted.
struct StepperMemory {
  State factored_at;  ///< empty when there are no factors
  double factored_tau = 0;
  int solves = 0;      ///< since then
  int iterations = 0;  ///< in all of them
  int last_iterations = 0;
  Solution last, before;  ///< displacements by τ
};

/// A step is solved for the first time, or once more with corrected coefficients.
enum class Pass { first, corrected };

/// Solves the two systems of a CoupledSystem, one after the other; the second may be empty.
class LaggedSolver {
 public:
  LaggedSolver(const Numerics& numerics, const Ranks& ranks);

  /// Of the system as it was assembled at a state, with τ. Empty when a matrix is singular; the past is
  /// forgotten then.
  std::optional<Solution> solve(const CoupledSystem& system, const State& at, double tau,
                                Pass pass);

  /// Of the solutions: that of rounding where every step is factored.
  double solver_tolerance() const { return solver_tolerance_; }
  const StepperMemory& memory() const { return memory_; }
  /// Factors anew what another solver had factored: the system is assembled as it was there, if the memory
  /// has factors. False where that is singular.
  [[nodiscard]] bool recall(const CoupledSystem& system, const StepperMemory& memory);

 private:
  bool worth_factoring() const;
  bool factor(const CoupledSystem& system, const State& at, double tau);
  Solution guess(const CoupledSystem& system, double tau, Pass pass) const;
  int solve_with_factors(const CoupledSystem& system, Solution& x) const;
  void remember(const CoupledSystem& system, Solution x, Pass pass, int iterations);

  Factorisation factorisation_;
  double solver_tolerance_;
  Gmres flow_, motion_;
  StepperMemory memory_;
};

}  // namespace sbeh::surface3d
