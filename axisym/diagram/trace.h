// A branch of stationary states followed by its own length, over its folds, as far as it goes: its states, and what is
// special on the way.
#pragma once

#include "axisym/modes/threshold.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace sbeh::axisym {

/// Why a trace ends.
enum class TraceEnd {
  bound,   ///< μ < 0 or μ > 1, or the moment of the area difference is larger than asked for
  limit,   ///< a neck closes
  parent,  ///< a branch of shapes without symmetry has passed through one that is symmetric
  length,  ///< most_steps, or stopped
  lost     ///< Newton's method finds no next state
};
constexpr auto names(TraceEnd) { return std::array{"bound", "limit", "parent", "length", "lost"}; }

/// What is special at a state.
enum class Special {
  fold,  ///< μ turns back
  symmetry_loss,  ///< the odd mode of m = 0 has the eigenvalue 0: a branch leaves that is not symmetric top to bottom
  mode  ///< likewise one of m ≥ 1
};

struct SpecialState {
  Special kind;
  int m;
  PathState state;
  /// Estimated, of V_r: a sixteenth of what half as many elements give differently; infinite where it is not known.
  double error;
  int leg;  ///< on which it is, or which ends with it
};

struct TracePoint {
  PathState state;
  int leg;                  ///< how many folds are before it
  int negative_directions;  ///< within axisymmetry, see stability.h
  /// Of all shapes, those of each m ≥ 1 counted twice; empty where an eigenvalue was not found, or is nearer to zero
  /// than what rigid motions leave.
  /// Not known either where fewer modes are looked at than up to m = 4.
  std::optional<int> negative_directions_3d;
  bool self_contact;
};

struct Trace {
  std::vector<TracePoint> points;
  std::vector<SpecialState> specials;  ///< in the order of the way
  TraceEnd begin =
      TraceEnd::bound;  ///< of one that goes both ways: why it goes no further the first way
  TraceEnd end = TraceEnd::bound;
};

struct TraceOptions {
  int largest_m = 4;           ///< modes that are looked at
  double longest_step = 0.1;   ///< of model/numerics/continuation.h
  double narrowest = 2e-3;     ///< a neck whose radius is less counts as closed, if it closes
  double largest_moment = 40;  ///< of the area difference, in κ
  int most_steps = 400;
  std::function<bool()> stops{};  ///< asked before each step; empty: never
  double promised =
      1e-9;  ///< errors of V_r of special states: elements are doubled until they are less
};

/// From a state of a line, the way its tangent points; where that has no μ, as on a branch's first state after a symmetry
/// loss, the state itself is no point of the trace. Nodes are placed anew after each step.
Trace trace(const Line& line, const PathState& from, const Numerics& numerics,
            const TraceOptions& options = {});

/// Both ways from a state, as one trace that begins where μ grows no less.
Trace trace_both_ways(const Line& line, const PathState& from, const Numerics& numerics,
                      const TraceOptions& options = {});

/// The state where a branch leaves that is not symmetric, its tangent along it; `line` is not symmetric. Empty where the
/// mode is not found.
std::optional<PathState> leaving(const Line& line, const SpecialState& loss,
                                 const Numerics& numerics);

}  // namespace sbeh::axisym
