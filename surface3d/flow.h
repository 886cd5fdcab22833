// An evolution in time of the 3D solver; see model/flow.h.
#pragma once

#include "surface3d/diagnostics.h"
#include "surface3d/options.h"
#include "surface3d/time_step.h"

namespace sbeh::surface3d {

using model::describe;
using model::FlowRecord;
using model::FlowSchedule;
using model::FlowStop;
using model::same_time;
/// Sees every accepted step, and the fields of its last half (empty at the start); `exact` tells that
/// the time is one of the output times. Returning false interrupts the run.
using FlowObserver =
    std::function<bool(const FlowRecord&, const State&, const StepFields&, bool exact)>;
using FlowResult = model::FlowResult<State>;

/// Runs the flow on a triangulation from `start`, at the time and with the next time step of `from`,
/// keeping area and volume at `target` to rounding.
FlowResult run_flow(const std::shared_ptr<const Triangulation>& mesh,
                    const model::Material& material, model::Model model, const State& start,
                    const Target& target, const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe = {}, const FlowRecord& from = {});

}  // namespace sbeh::surface3d
