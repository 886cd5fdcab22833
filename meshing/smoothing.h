// Even triangles on a smooth surface: points move along it and edges flip, the counts stay.
#pragma once

#include "meshing/triangle_mesh.h"

#include <functional>

namespace sbeh::meshing {

/// The point of a surface that belongs to a point near it.
using Projection = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Moves every point onto the surface.
void project(TriangleMesh& mesh, const Projection& onto_surface);

/// Sweeps over a closed mesh: every point goes along the surface to the weighted mean of the
/// centroids of its triangles and back onto the surface; then edges that violate Delaunay's
/// criterion flip. Weights √area/size²: equal areas would cost angles, equal weights sizes.
///
/// size = 1/(1 + grading R|H|/2), R = √(A/4π), is the wanted edge length up to a factor: the same
/// everywhere for grading = 0; for grading = 1 twice as long where the surface is flat as where
/// |H| = 2/R.
void smooth(TriangleMesh& mesh, const Projection& onto_surface, double grading, int sweeps);

/// Smooths; then so many times divides each triangle into four, projects and smooths again.
TriangleMesh refined(TriangleMesh mesh, int times, const Projection& onto_surface, double grading);

/// Smallest angle of the triangles, degrees.
double min_angle(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
