#include "surface3d/lagged_solver.h"

#include "surface3d/coupled_system.h"

#include <algorithm>
#include <utility>

namespace sbeh::surface3d {

namespace {

// Solutions with fresh factors are exact to rounding.
double allowed(Factorisation factorisation, double solver_tolerance) {
  return factorisation == Factorisation::every_step ? Gmres::exact : solver_tolerance;
}

// Of the tangential motion of the mesh, which is no part of the shape.
double allowed_in_motion(const Numerics& numerics) {
  constexpr double laxer = 100, most = 1e-2;
  const double asked = numerics.solver_tolerance;
  return allowed(numerics.factorisation, std::max(asked, std::min(laxer * asked, most)));
}

bool is_empty(const LinearSystem& system) { return system.matrix.rows() == 0; }

}  // namespace

LaggedSolver::LaggedSolver(const Numerics& numerics, const Ranks& ranks)
    : factorisation_(numerics.factorisation),
      solver_tolerance_(allowed(numerics.factorisation, numerics.solver_tolerance)),
      flow_(Symmetry::general, solver_tolerance_, ranks),
      motion_(Symmetry::symmetric, allowed_in_motion(numerics), ranks) {}

// When the next solve is likely to cost more than the mean of all since the last factorisation,
// which it was part of.
bool LaggedSolver::worth_factoring() const {
  if (memory_.solves == 0 || factorisation_ == Factorisation::every_step) return true;
  const double all = flow_.cost_of_factoring() + memory_.iterations;
  return memory_.last_iterations > all / memory_.solves;
}

bool LaggedSolver::factor(const CoupledSystem& system, const State& at, double tau) {
  memory_.factored_at = at;
  memory_.factored_tau = tau;
  memory_.solves = memory_.iterations = memory_.last_iterations = 0;
  return flow_.factor(system.flow().matrix)
      && (is_empty(system.motion()) || motion_.factor(system.motion().matrix));
}

// The last two solutions, extrapolated; of a step that is corrected, the first one.
Solution LaggedSolver::guess(const CoupledSystem& system, double tau, Pass pass) const {
  const Solution &last = memory_.last, &before = memory_.before;
  Solution x = last;
  x.tau = tau;
  if (x.flow.size() == 0 || factorisation_ == Factorisation::every_step)
    x = {.flow = Eigen::VectorXd::Zero(system.flow().rhs.size()),
         .motion = Eigen::VectorXd::Zero(system.motion().rhs.size()),
         .tau = tau};
  else if (pass == Pass::first && before.flow.size() > 0) {
    const double r = tau / last.tau;
    x.flow += r * (last.flow - before.flow);
    x.motion += r * (last.motion - before.motion);
  }
  system.scale_displacements(tau, x.flow, x.motion);
  return x;
}

// The number of times the factors of the flow were applied; 0 when that failed.
int LaggedSolver::solve_with_factors(const CoupledSystem& system, Solution& x) const {
  const int iterations = flow_.solve(system.flow().matrix, system.flow().rhs, x.flow);
  if (iterations == 0 || is_empty(system.motion())) return iterations;
  const Eigen::VectorXd rhs = system.motion_rhs(x.flow);
  return motion_.solve(system.motion().matrix, rhs, x.motion) == 0 ? 0 : iterations;
}

std::optional<Solution> LaggedSolver::solve(const CoupledSystem& system, const State& at,
                                            double tau, Pass pass) {
  const bool fresh = worth_factoring();
  if (fresh && !factor(system, at, tau)) return memory_ = {}, std::nullopt;
  Solution x = guess(system, tau, pass);
  int iterations = solve_with_factors(system, x);
  if (iterations == 0 && !fresh && factor(system, at, tau)) {
    x = guess(system, tau, pass);
    iterations = solve_with_factors(system, x);
  }
  if (iterations == 0) return memory_ = {}, std::nullopt;
  remember(system, x, pass, iterations);
  return x;
}

void LaggedSolver::remember(const CoupledSystem& system, Solution x, Pass pass, int iterations) {
  system.scale_displacements(1 / x.tau, x.flow, x.motion);
  if (pass == Pass::first) memory_.before = std::move(memory_.last);
  memory_.last = std::move(x);
  ++memory_.solves;
  memory_.iterations += iterations;
  memory_.last_iterations = iterations;
}

bool LaggedSolver::recall(const CoupledSystem& system, const StepperMemory& memory) {
  if (memory.solves > 0 && !factor(system, memory.factored_at, memory.factored_tau)) return false;
  memory_ = memory;
  for (Solution* x : {&memory_.last, &memory_.before})
    if (x->flow.size() != system.flow().rhs.size()
        || x->motion.size() != system.motion().rhs.size())
      *x = {};  // of another version
  return true;
}

}  // namespace sbeh::surface3d
