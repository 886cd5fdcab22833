// Whether a flow that has become slow is near a state at rest, which Newton's method then gives at once.
#pragma once

#include "model/time/flow_record.h"
#include "surface3d/stationary/stationary.h"

namespace sbeh::surface3d {

/// Whether Newton's method leads from the state to one of rest where the flow tends: a minimum of no higher energy, from which no
/// node is farther than a tenth of the radius of the sphere of that area, and its order no farther than 0.1. Near a saddle a
/// flow is slow too, and goes on.
/// Of spheres, which cannot move, nothing is asked.
bool rest_is_ahead(const Triangulation& mesh, const model::Material& material, model::Model model,
                   const State& state, const Target& target);

/// Asks that along a flow, each time it becomes slower than one of three speeds.
class RestWatch {
 public:
  /// From a moment of it, to the area and volume of the target.
  RestWatch(const model::Material& material, model::Model model, const Target& target,
            const model::FlowRecord& start = {});
  bool near(const model::FlowRecord& record, const Triangulation& mesh, const State& state);

 private:
  model::Material material_;
  model::Model model_;
  Target target_;
  double unit_, before_;  // of speed, as [numerics] rest_speed has it; of the last record
};

}  // namespace sbeh::surface3d
