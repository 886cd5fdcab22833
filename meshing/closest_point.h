// The point of a curved surface nearest to a given one.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/smoothing.h"
#include "meshing/triangle_search.h"

#include <memory>
#include <vector>

namespace sbeh::meshing {

/// A place on a curved triangle, by the coordinates of the reference triangle.
struct SurfacePlace {
  int triangle = 0;
  Eigen::Vector2d at;
};

/// A curved surface prepared for searching. Not for points farther from it than its radius of
/// curvature, where the nearest point is not unique.
class ClosestPoint {
 public:
  explicit ClosestPoint(const CurvedMesh& mesh);

  /// Newton's method on the polynomials of the triangles, from the nearest of the small plain ones
  /// between the nodes; to rounding, for points of the surface on edges and corners too. Where
  /// triangles meet in a small concave angle two places are nearly as near, and it is one of them.
  SurfacePlace operator()(const Eigen::Vector3d& x) const;

  Eigen::Vector3d point(const SurfacePlace& place) const;
  /// Of a field with values at the nodes.
  double value(const Eigen::VectorXd& field, const SurfacePlace& place) const;

 private:
  struct Found {
    SurfacePlace place;
    double distance;
  };
  Found on_triangle(int triangle, const Eigen::Vector2d& start, const Eigen::Vector3d& x) const;
  Eigen::Vector2d nearest_node(int triangle, const Eigen::Vector3d& x) const;

  using Monomials = Eigen::Matrix<double, 10, 1>;
  CurvedMesh mesh_;
  Eigen::Matrix<double, 10, 10> to_monomials_;            // nodal values to coefficients
  std::vector<Eigen::Matrix<double, 3, 10>> polynomial_;  // of each triangle
  std::vector<std::vector<int>> around_;                  // triangles that share a corner with each
  NearestTriangle nearest_;                               // of the small plain triangles
};

/// The same as a projection; keeps the surface alive.
Projection onto(std::shared_ptr<const ClosestPoint> surface);

}  // namespace sbeh::meshing
