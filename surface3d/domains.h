// The domains of an order on a P3 surface.
#pragma once

#include "model/domains.h"
#include "surface3d/surface.h"

namespace sbeh::surface3d {

/// On the nine plain triangles between the nodes of each.
model::Domains domains_of(const Triangulation& mesh, const State& state);

}  // namespace sbeh::surface3d
