// Where a surface lies and how it is stretched: its moments to second order.
#pragma once

#include "surface3d/surface.h"

namespace sbeh::surface3d {

struct SurfaceSamples {
  Eigen::Matrix3Xd points;
  Eigen::VectorXd areas;  ///< which each stands for
};
/// The points of quadrature of a P3 surface.
SurfaceSamples samples_of(const Triangulation& mesh, const Nodes& X);

struct Moments {
  Eigen::Vector3d centre;     ///< c = ∫ x dS / A
  Eigen::Vector3d principal;  ///< of ∫ (x − c)(x − c)ᵀ dS / A, ascending
  Eigen::Matrix3d axes;       ///< theirs, one column each

  /// The principal axis whose moment differs most from the two others.
  Eigen::Vector3d distinct_axis() const;
};
Moments moments_of(const SurfaceSamples& samples);

}  // namespace sbeh::surface3d
