// Whether a flow that has become slow is near a state at rest, which Newton's method then gives at once.
#pragma once

#include "surface3d/stationary/stationary.h"

namespace sbeh::surface3d {

/// Whether Newton's method leads from the state to one of rest where the flow tends: a minimum of no higher energy, from which no
/// node is farther than a tenth of the radius of the sphere of that area, and its order no farther than 0.1. Near a saddle a
/// flow is slow too, and goes on.
/// Of spheres, which cannot move, nothing is asked.
bool rest_is_ahead(const Triangulation& mesh, const model::Material& material, model::Model model,
                   const State& state, const Target& target);

}  // namespace sbeh::surface3d
