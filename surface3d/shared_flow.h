// A 3D flow that several processes compute together: the first one has the files and the clock, the others
// wait for what it runs.
#pragma once

#include "surface3d/flow.h"
#include "surface3d/linear/ranks.h"

namespace sbeh::surface3d {

/// As run_flow, by all ranks; called by the first one. Its `observe` decides for all of them. Throws
/// std::invalid_argument also where there are more ranks than triangles.
FlowResult run_shared_flow(const model::Material& material, model::Model model,
                           const FlowMoment& start, const Numerics& numerics,
                           const FlowSchedule& schedule, const FlowObserver& observe,
                           const Ranks& ranks);

/// What the other ranks do, until the first one calls dismiss(): their part of its flows, and of what it factors
/// (SharedFactors). Ends the program where they come to other numbers than the first one, and at an error that is theirs
/// alone.
void serve_first(const Ranks& ranks);
/// By the first one.
void dismiss(const Ranks& ranks);

}  // namespace sbeh::surface3d
