// An evolution in time of the axisymmetric solver; see model/time/flow.h.
#pragma once

#include "axisym/diagnostics.h"
#include "axisym/options.h"
#include "axisym/time_step.h"
#include "model/time/flow_record.h"
#include "model/time/step_control.h"

namespace sbeh::axisym {

using model::describe, model::FlowRecord, model::FlowSchedule, model::FlowStop, model::same_time;
using FlowObserver = model::FlowObserver<State>;
using FlowResult = model::FlowResult<State>;

/// Diagnostics::resolution above which a rim counts as unresolved.
inline constexpr double largest_resolution = 0.35;

/// Runs the flow from `start`, keeping area and volume at `target` to rounding, or with lipid_density the number of lipids that is
/// there and the volume. It ends where the mesh
/// does not resolve the curve, or the surface passes through itself.
FlowResult run_flow(const model::Material& material, model::Model model, const State& start,
                    const Target& target, const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe = {});

}  // namespace sbeh::axisym
