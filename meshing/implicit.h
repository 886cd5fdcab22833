// Surfaces given as the zero level of a function.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/resolution.h"

#include <functional>

namespace sbeh::meshing {

/// f = 0, f < 0 inside. A smooth function whose gradient does not vanish on the surface.
struct ImplicitShape {
  std::function<double(const Eigen::Vector3d&)> f;
  /// Its gradient; empty: by central differences, which costs six evaluations.
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> gradient = {};
  /// A point inside and the radius of a sphere about it that contains the surface.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
};

/// By CGAL's surface mesher, remeshed to even size, all nodes on the zero level to rounding. The
/// number of triangles is within a few percent of the one asked for. Throws std::invalid_argument
/// when f >= 0 at the centre, the radius is not positive, or what is found is no closed surface of
/// the topology of a sphere (with what it is instead).
CurvedMesh implicit_surface(const ImplicitShape& shape, const Resolution& resolution);

}  // namespace sbeh::meshing
