// Under which turns and mirrors a surface with its order is what it was.
#pragma once

#include "surface3d/surface.h"

#include <string>

namespace sbeh::surface3d {

/// How far points may be off the surface, and the order off its own, in radii of the sphere of equal area and in root mean
/// square: where a rim is sharp, single points are off by what the triangles do not resolve.
inline constexpr double symmetry_tolerance = 3e-3;

/// Schoenflies' symbol, such as "D2h", "D3h", "C2v", "Cs", with axes of 2 to 6 turns; "C1" of none. Of a surface of
/// revolution "Dooh" where it has an equator that is a mirror, "Coov" otherwise.
std::string symmetry_class(const Triangulation& mesh, const State& state);

}  // namespace sbeh::surface3d
