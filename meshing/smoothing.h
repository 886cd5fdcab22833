// Even triangles on a smooth surface: points move along it and edges flip, the counts stay.
#pragma once

#include "meshing/triangle_mesh.h"

#include <functional>

namespace sbeh::meshing {

/// The point of a surface that belongs to a point near it.
using Projection = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// Wanted edge length at a point of the surface; only its ratios count. Empty: the same everywhere.
using SizeField = std::function<double(const Eigen::Vector3d&)>;

/// Sweeps over a closed mesh: every point goes along the surface to the weighted mean of the
/// centroids of its triangles, weight = area/size⁴, and back onto the surface; then edges that
/// violate Delaunay's criterion flip. The result lies on the surface and does not depend on the
/// order of the points, except where edges tie.
void smooth(TriangleMesh& mesh, const Projection& onto_surface, const SizeField& size, int sweeps);

/// Makes 20 n² triangles from a coarse start with 20 m² ones, n = 2^k m: smooths, divides each
/// triangle into four, projects and smooths again, k times.
TriangleMesh refined(TriangleMesh mesh, int times, const Projection& onto_surface,
                     const SizeField& size, int sweeps);

}  // namespace sbeh::meshing
