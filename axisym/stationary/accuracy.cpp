#include "axisym/stationary/accuracy.h"

#include "axisym/redistribute.h"
#include "axisym/stationary/arclength.h"
#include "axisym/stationary/symmetry.h"

#include <cmath>
#include <limits>

namespace sbeh::axisym {

std::optional<BranchState> on_elements(const model::Material& material, model::Model model,
                                       const BranchState& state, int elements, double grading,
                                       NewtonOptions options) {
  StationaryState guess = redistribute(state, grading, elements);
  options.symmetric = is_symmetric(state.X);
  if (options.symmetric) guess = symmetric_part(guess);
  return solve_at(material, model, state.at, guess, options);
}

namespace {

// The fold near a state of its path, by secants of the slope; μ and the energy are off by its square, the rest by it.
std::optional<PathState> fold_near(const Line& line, PathState here) {
  constexpr double flat = 1e-6;
  double ds = 1e-5;
  for (int step = 0; step < 12 && std::abs(here.slope()) > Line::limits.fold; ++step) {
    const auto next = arc_step(line, here, ds);
    if (!next) {
      ds /= 2;
      continue;
    }
    ds *= next->slope() / (here.slope() - next->slope());
    here = *next;
  }
  return std::abs(here.slope()) > flat ? std::nullopt : std::optional(here);
}

// The same fold over other elements.
std::optional<BranchState> fold_on_elements(const FollowResult& fold, const BranchState& state,
                                            int elements, double grading) {
  const auto near = on_nodes(fold.line, {redistribute(state, grading, elements), fold.mu});
  const auto there = near ? fold_near(fold.line, *near) : std::nullopt;
  if (!there) return {};
  return BranchState{*there, fold.line.at(there->mu), state.determinant_sign};
}

constexpr double unknown = std::numeric_limits<double>::infinity();

Accuracy difference(const Diagnostics& fine, const Diagnostics& coarse) {
  return {.energy = overestimate * std::abs(fine.energy.total() - coarse.energy.total()),
          .W2 = overestimate * std::abs(fine.W2 - coarse.W2),
          .H_pole = overestimate * std::abs(fine.H_pole - coarse.H_pole)};
}

bool is_within(const Accuracy& error, const Diagnostics& d) {
  return error.energy <= promised_energy * (1 + std::abs(d.energy.total()))
      && error.W2 <= promised_W2 * (1 + std::abs(d.W2));
}

// `over` gives a state over so many elements, if it can.
template <class Over>
ResolvedState refined(const model::Material& material, const BranchState& state, double place,
                      Over&& over) {
  const auto measures = [&](const BranchState& s) { return diagnose(material.with_L1(s.at.L), s); };
  const auto compare = [&](ResolvedState& fine, const BranchState& coarse, const Diagnostics& d) {
    fine.error = difference(fine.diagnostics, d);
    fine.place_error = overestimate
                     * std::max(std::abs(fine.state.at.L - coarse.at.L),
                                std::abs(fine.state.at.reduced_volume - coarse.at.reduced_volume));
    fine.is_resolved = is_within(fine.error, fine.diagnostics) && fine.place_error <= place;
  };
  ResolvedState result{state, measures(state), {unknown, unknown, unknown}, unknown, false};
  const int elements = element_count(state.X);
  if (const auto coarse = over(state, elements / 2)) compare(result, *coarse, measures(*coarse));
  for (int more = 2 * elements; !result.is_resolved && more <= most_elements; more *= 2) {
    const auto fine = over(result.state, more);
    if (!fine) break;
    const ResolvedState before = std::move(result);
    result = {*fine, measures(*fine), {}, 0, false};
    compare(result, before.state, before.diagnostics);
  }
  return result;
}

}  // namespace

ResolvedState resolved(const model::Material& material, model::Model model,
                       const BranchState& state, const Numerics& numerics) {
  return refined(material, state, unknown, [&](const BranchState& from, int elements) {
    // Of fewer no more is asked than their error.
    const bool fewer = elements < element_count(from.X);
    return on_elements(
        material, model, from, elements, numerics.grading,
        fewer ? NewtonOptions{.tolerance = 1e-4, .corrects = false} : NewtonOptions{});
  });
}

ResolvedState resolved_fold(const FollowResult& fold, const Numerics& numerics, double place) {
  return refined(fold.line.material, fold.state, place, [&](const BranchState& from, int elements) {
    return fold_on_elements(fold, from, elements, numerics.grading);
  });
}

}  // namespace sbeh::axisym
