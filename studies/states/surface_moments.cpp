#include "studies/states/surface_moments.h"

namespace sbeh::studies {

SurfaceMoments surface_moments(const surface3d::Triangulation& mesh, const surface3d::Nodes& X) {
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  double area = 0;
  surface3d::for_each_point(
      mesh, X, surface3d::diagnostic_points(),
      [&](int, const surface3d::ShapeValues&, const surface3d::SurfacePoint& p) {
        first += p.dS * p.x;
        second += p.dS * p.x * p.x.transpose();
        area += p.dS;
      });
  const Eigen::Vector3d centre = first / area;
  return {.centre = centre, .second = second / area - centre * centre.transpose()};
}

}  // namespace sbeh::studies
