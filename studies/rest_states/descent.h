// From a state at rest along a mode, down the flow to where it nearly rests.
#pragma once

#include "studies/rest_states/rest_state.h"
#include "surface3d/flow.h"

#include <functional>
#include <memory>
#include <string>

namespace sbeh::studies {

/// What goes down: SBEH or SSH, to the area and volume of the target.
struct Membrane {
  model::Material material;
  model::Model model;
  surface3d::Target target;
};

/// A state at which Newton's method has arrived, with the normals along which its nodes move.
struct FoundShape {
  const surface3d::Triangulation& mesh;
  const surface3d::StationaryState& state;
  const surface3d::Nodes& normals;
};

/// Displaced along a mode, its largest displacement or change of order being `by` (< 0: the other way), at the target's area and
/// volume.
surface3d::State displaced(const Membrane& membrane, const FoundShape& from,
                           const surface3d::Eigenmode& mode, double by);

/// Where a flow was left.
struct Descent {
  std::shared_ptr<const surface3d::Triangulation> mesh;
  surface3d::State state{};
  bool rests = false;    ///< Newton's method leads from there to a minimum, or nothing moves
  std::string reason{};  ///< why it was left where it does not rest
  double time = 0, energy = 0;
  int steps = 0;
};
using DescentObserver = std::function<void(const surface3d::FlowRecord&)>;

/// The flow from a surface until Newton's method leads to a minimum nearby (surface3d/stationary/rest_ahead.h), nothing moves, it
/// sharpens beyond what its triangles resolve, or can go no further, or an interrupt; on new triangles where it needs them, up to five times
/// as many. In the long steps of Integrator::variational, where the material has them.
Descent descend(const Membrane& membrane, std::shared_ptr<const surface3d::Triangulation> mesh,
                const surface3d::State& start, const DescentObserver& observe = {});

}  // namespace sbeh::studies
