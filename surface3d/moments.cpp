#include "surface3d/moments.h"

#include <Eigen/Eigenvalues>

#include <vector>

namespace sbeh::surface3d {

SurfaceSamples samples_of(const Triangulation& mesh, const Nodes& X) {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> areas;
  for_each_point(mesh, X, diagnostic_points(), [&](int, const ShapeValues&, const SurfacePoint& p) {
    points.push_back(p.x);
    areas.push_back(p.dS);
  });
  const auto count = Eigen::Index(points.size());
  return {Eigen::Map<const Eigen::Matrix3Xd>(points.front().data(), 3, count),
          Eigen::Map<const Eigen::VectorXd>(areas.data(), count)};
}

Eigen::Vector3d Moments::distinct_axis() const {
  return axes.col(principal[2] - principal[1] > principal[1] - principal[0] ? 2 : 0);
}

Moments moments_of(const SurfaceSamples& samples) {
  const auto& [points, areas] = samples;
  const Eigen::Vector3d centre = points * areas / areas.sum();
  const Eigen::Matrix3Xd off = points.colwise() - centre;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(off * areas.asDiagonal()
                                                             * off.transpose() / areas.sum());
  return {centre, eigen.eigenvalues(), eigen.eigenvectors()};
}

}  // namespace sbeh::surface3d
