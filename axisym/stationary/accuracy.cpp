#include "axisym/stationary/accuracy.h"

#include "axisym/redistribute.h"
#include "axisym/stationary/arclength.h"
#include "axisym/stationary/symmetry.h"

#include <cmath>
#include <limits>

namespace sbeh::axisym {

namespace {

// The same state over other elements; empty where Newton's method fails.
std::optional<BranchState> on_elements(const model::Material& material, model::Model model,
                                       const BranchState& state, int elements, double grading,
                                       const NewtonOptions& options = {}) {
  StationaryState guess = redistribute(state, grading, elements);
  if (is_symmetric(state.X)) guess = symmetric_part(guess);
  return solve_at(material, model, state.at, guess, options);
}

Accuracy difference(const Diagnostics& fine, const Diagnostics& coarse) {
  constexpr double overestimate = 1. / 16;
  return {.energy = overestimate * std::abs(fine.energy.total() - coarse.energy.total()),
          .W2 = overestimate * std::abs(fine.W2 - coarse.W2),
          .H_pole = overestimate * std::abs(fine.H_pole - coarse.H_pole)};
}

bool is_within(const Accuracy& error, const Diagnostics& d) {
  return error.energy <= promised_energy * (1 + std::abs(d.energy.total()))
      && error.W2 <= promised_W2 * (1 + std::abs(d.W2));
}

}  // namespace

ResolvedState resolved(const model::Material& material, model::Model model,
                       const BranchState& state, const Numerics& numerics) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  const model::Material here = material.with_L(state.at.L);
  ResolvedState result{state, diagnose(here, state), {unknown, unknown, unknown}, false};
  if (const auto coarse = on_elements(material, model, state, element_count(state.X) / 2,
                                      numerics.grading, {.tolerance = 1e-4}))
    result.error = difference(result.diagnostics, diagnose(here, *coarse));
  while (!(result.is_resolved = is_within(result.error, result.diagnostics))
         && 2 * element_count(result.state.X) <= most_elements) {
    auto fine = on_elements(material, model, result.state, 2 * element_count(result.state.X),
                            numerics.grading);
    if (!fine) break;
    const Diagnostics before = result.diagnostics;
    fine->iterations += result.state.iterations;
    result.state = std::move(*fine);
    result.diagnostics = diagnose(here, result.state);
    result.error = difference(result.diagnostics, before);
  }
  return result;
}

}  // namespace sbeh::axisym
