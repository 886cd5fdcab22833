// Where a surface lies and how it is stretched: its moments to second order.
#pragma once

#include "surface3d/surface.h"

namespace sbeh::studies {

struct SurfaceMoments {
  Eigen::Vector3d centre;  ///< c = ∫ x dS / A
  Eigen::Matrix3d second;  ///< ∫ (x − c)(x − c)ᵀ dS / A
};
SurfaceMoments surface_moments(const surface3d::Triangulation& mesh, const surface3d::Nodes& X);

}  // namespace sbeh::studies
