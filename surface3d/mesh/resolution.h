// Whether a mesh resolves the surface that it carries.
#pragma once

#include "surface3d/curvature.h"

namespace sbeh::surface3d {

/// How finely a mesh resolves its surface: pure numbers, the angle in degrees. h is the spacing of the
/// nodes along the longest side of a triangle, a third of the distance between its corners; H is that
/// of the scheme, at the nodes.
struct Indicators {
  double mean_curvature;  ///< largest |H| h
  double resolution;      ///< largest |B| h: the angle by which normals turn from node to node
  double curvature_gap;  ///< ‖H − H_n‖/‖H‖ in L2, H_n = −div_C n of the projected normals
  double mesh_quality;  ///< see mesh_quality
  double min_angle;     ///< of the plain triangles between the corners
};
/// `curvature` is that of X; three passes over the triangles, 2.5 µs for each of them.
Indicators indicators_of(const Triangulation& mesh, const Nodes& X, const Curvature& curvature);

// Limits beyond which the energy is not to be trusted; see README.md for what they are taken from.
// Both of the first two are needed: a mesh that steps over a ridge finds little curvature there, but
// its two curvatures disagree.
inline constexpr double largest_resolution = 1;
inline constexpr double largest_curvature_gap = 0.1;
inline constexpr double smallest_quality = 0.1;  // of mesh_quality
inline constexpr double smallest_angle = 15;     // of min_angle

/// Within all limits.
bool resolved(const Indicators& indicators);

}  // namespace sbeh::surface3d
