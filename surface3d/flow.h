// An evolution in time of the 3D solver; see model/time/flow.h.
#pragma once

#include "meshing/point_group.h"
#include "model/time/flow_record.h"
#include "model/time/multi_step.h"
#include "model/time/step_control.h"
#include "surface3d/diagnostics.h"
#include "surface3d/mesh/remesh.h"
#include "surface3d/mesh/resolution.h"
#include "surface3d/options.h"
#include "surface3d/time_step.h"

namespace sbeh::surface3d {

using model::describe;
using model::FlowRecord;
using model::FlowSchedule;
using model::FlowStop;
using model::same_time;
/// The past of a run besides its state: with it a run goes on with the same bits.
struct FlowMemory {
  StepperMemory stepper;
  model::StepHistory<State> history = {};
  bool remeshing_over = false;  ///< no new mesh is tried any more
};
/// Point groups about the origin; C1: none.
struct FlowSymmetry {
  meshing::PointGroup mesh = {};  ///< of the first triangles
  meshing::PointGroup kept =
      {};  ///< in it: what each step is projected onto, and new triangles have
  bool operator==(const FlowSymmetry&) const = default;
};
/// A moment of a run: all that it needs to go on with the same bits, and what its files are made of.
struct FlowMoment {
  std::shared_ptr<const Triangulation> mesh;
  State state;
  Target target;
  FlowRecord record = {};  ///< for a run that goes on its time and next_step count
  FlowMemory memory = {};
  StepFields fields = {};      ///< as in StepView; a run goes on without
  FlowSymmetry symmetry = {};  ///< of the run
};
/// What an observer sees besides the state.
struct StepView {
  const StepFields& fields;  ///< of the last solve; empty at the start and on a new mesh
  FlowMemory memory;
  const std::shared_ptr<const Triangulation>& mesh;  ///< of the state
  const Indicators& indicators;                      ///< of the state, on the mesh before a new one
  const std::optional<RemeshResult>& remeshed;       ///< when that was tried after this step
};
/// Sees every accepted step; `exact` tells that the time is one of the output times. Returning false
/// interrupts the run.
using FlowObserver =
    std::function<bool(const FlowRecord&, const State&, const StepView&, bool exact)>;
using FlowResult = model::FlowResult<State>;

/// What Integrator::variational is not for.
inline constexpr const char* no_variational_steps =
    "belongs to models whose area is kept at each point";

/// Runs the flow, keeping area and volume at the start's target, and its symmetry, to rounding. A run whose mesh does not
/// resolve the surface (see resolution.h) goes on, on a new mesh with half as many triangles
/// more where Numerics::remesh allows it. It ends where the mesh degenerates or the surface touches
/// itself (see self_contact.h). Spheres, which do not move, have no variational steps, but those of MultiStep. Throws
/// std::invalid_argument where the model has none, where the mesh has not the symmetry, and where lipids whose area depends on their order
/// begin on a sphere. With lipid_density their number is kept, that of the start, and not the area.
/// Several ranks run it together, with equal arguments and observers of one mind, and all have the result; see
/// shared_flow.h. Variational steps are for one rank: else std::invalid_argument.
FlowResult run_flow(const model::Material& material, model::Model model, const FlowMoment& start,
                    const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe = {}, const Ranks& ranks = {});

}  // namespace sbeh::surface3d
