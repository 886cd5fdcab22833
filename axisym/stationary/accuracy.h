// How far a stationary state is resolved, by itself on half the elements; and more elements where it is not.
#pragma once

#include "axisym/diagnostics.h"
#include "axisym/stationary/continuation.h"

#include <limits>

namespace sbeh::axisym {

/// Estimated errors of a state's measures: a sixteenth of what half as many elements give differently. The
/// errors fall by 64, so that they are overestimated where the elements are fine. Infinite where the state is
/// not there on half as many. Without what rounding adds, some 1e-9 with 384 elements.
struct Accuracy {
  double energy, W2, H_pole;
};

/// An error is estimated as this share of what half as many elements give differently.
inline constexpr double overestimate = 1. / 16;

/// The errors that are promised: of the energy relatively to 1 + |U|, of W₂ relatively to 1 + |W₂|.
inline constexpr double promised_energy = 1e-8, promised_W2 = 1e-6;

struct ResolvedState {
  BranchState state;
  Diagnostics diagnostics;
  Accuracy error;
  double
      place_error;  ///< likewise, of a fold's L or V_r, where its line goes; 0 of states at a given place
  bool is_resolved;  ///< within what is promised
};

/// The same state over other elements, symmetric top to bottom if it is; empty where Newton's method fails.
std::optional<BranchState> on_elements(const model::Material& material, model::Model model,
                                       const BranchState& state, int elements, double grading,
                                       NewtonOptions options = {});

/// Doubles the elements (to most_elements at the most) until the errors are as promised. `state` is
/// stationary at its place; the material but for L.
ResolvedState resolved(const model::Material& material, model::Model model,
                       const BranchState& state, const Numerics& numerics);

/// The same of a fold to which `follow` has led.
/// Its place within `place`, too.
ResolvedState resolved_fold(const FollowResult& fold, const Numerics& numerics,
                            double place = std::numeric_limits<double>::infinity());

}  // namespace sbeh::axisym
