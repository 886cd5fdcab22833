// Newton's method kept away from states that are known (deflation: Farrell, Birkisson and Funke, SIAM J. Sci. Comput. 37, 2015).
//
// The equations times m = Π (1/|s − s_i|² + 1), s what marks a state and s_i that of a known one, have the same solutions but
// these. Their Newton step is the old one, Δ, times 1/(1 − m'Δ/m), with m' by finite differences.
#pragma once

#include "surface3d/stationary/newton_system.h"

namespace sbeh::surface3d {

/// What tells states apart, on whatever triangles, wherever they lie and however they are turned or mirrored: smooth numbers of
/// order 1 of the surface, its mean curvature and its order, lengths in units of the radius of a sphere of its area.
using StateMarks = Eigen::VectorXd;
StateMarks marks_of(const Triangulation& mesh, const StationaryState& state);

/// How far the marks of one state are apart on two meshes that resolve it, at most.
inline constexpr double same_marks = 3e-3;

using KnownStates = std::vector<StateMarks>;
bool is_known(const KnownStates& known, const StateMarks& marks);

/// By what a Newton step from `state`, along these normals, is to be multiplied; 1 where nothing is known.
double deflation(const KnownStates& known, const Triangulation& mesh, const StationaryState& state,
                 const Nodes& normals, const Increment& step);

}  // namespace sbeh::surface3d
