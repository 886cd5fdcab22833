// Which unknowns the systems of the coupled step have, in which order, and which of them meet.
#pragma once

#include "surface3d/surface.h"

#include <array>

namespace sbeh::surface3d {

/// See coupled_system.h.
enum class Scheme { split, monolithic };
constexpr auto values_of(Scheme) { return std::array{Scheme::split, Scheme::monolithic}; }
/// "split" or "monolithic".
const char* name(Scheme scheme);

// Of these patterns the local unknowns of a vector stand by components, the global ones by nodes.
/// V (3), p (P2), H, when monolithic Y (3), and the multipliers: λ and what else there is.
SparsePattern flow_pattern(const Triangulation& mesh, Scheme scheme, int multipliers);
/// Under a global area constraint: the speeds v along the node normals, H, when monolithic Y, λ and the
/// number p.
SparsePattern normal_flow_pattern(const Triangulation& mesh, Scheme scheme);
/// The tangential displacements, two at each node.
SparsePattern motion_pattern(const Triangulation& mesh);

}  // namespace sbeh::surface3d
