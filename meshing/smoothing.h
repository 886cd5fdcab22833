// Even triangles on a smooth surface: points move along it and edges flip, the counts stay.
#pragma once

#include "meshing/point_group.h"
#include "meshing/triangle_mesh.h"

#include <functional>

namespace sbeh::meshing {

/// The point of a surface that belongs to a point near it.
using Projection = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Moves every point onto the surface.
void project(TriangleMesh& mesh, const Projection& onto_surface);

/// What smoothing aims at.
struct Smoothing {
  /// Wanted edge lengths 1/(1 + grading R|H|/2) up to a factor, R = √(A/4π): the same everywhere
  /// for 0; for 1 twice as long where the surface is flat as where |H| = 2/R.
  double grading = 0;
  /// Wanted edge lengths, up to a factor, at points of the surface; instead of the above when given.
  std::function<double(const Eigen::Vector3d&)> size = {};
  /// Power of the triangles' areas in their weights: 1 makes areas even at the cost of angles,
  /// 0 angles at the cost of areas.
  double evenness = 0.5;
  /// That the mesh has and keeps.
  PointGroup symmetry = {};
};

/// Sweeps over a closed mesh: every point goes along the surface to the weighted mean of the
/// centroids of its triangles, weight = (area/size⁴)^evenness, and back onto the surface; then
/// edges that violate Delaunay's criterion flip. Throws std::invalid_argument where the triangles have not the symmetry.
void smooth(TriangleMesh& mesh, const Projection& onto_surface, const Smoothing& aim, int sweeps);

/// Smallest angle of the triangles, degrees.
double min_angle(const TriangleMesh& mesh);

}  // namespace sbeh::meshing
