// The nodes of a 3D state in the terms of the axisymmetric methods.
#pragma once

#include "studies/witnesses/state.h"
#include "surface3d/surface.h"

namespace sbeh::studies {

/// Turns the surface with its axis upright and its centre in the origin, the pole of the larger H up: fills the points, r and z of the
/// nodes, the order and H at that pole. H: nodes.
void place_nodes(const surface3d::Triangulation& mesh, const surface3d::State& state,
                 const surface3d::Field& H, WitnessState& found);

}  // namespace sbeh::studies
