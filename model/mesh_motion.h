// How fast a mesh goes to its equilibrium.
#pragma once

namespace sbeh::model {

/// The time in which nodes reach the places where (H1) holds along the surface too. Not much below the time
/// steps: where the mesh settles within one step, two-step methods, which extrapolate it, do not.
inline constexpr double mesh_relaxation_time = 0.02;

/// θ of (H1): the share of the way in a step of τ. With the whole way in every step, however short, the error
/// of a step would not vanish with τ.
inline double mesh_share(double tau) { return tau / (tau + mesh_relaxation_time); }

}  // namespace sbeh::model
