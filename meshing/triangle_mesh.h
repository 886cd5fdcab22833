// A mesh of plain triangles: what is read from a file, generated and smoothed before it is curved.
#pragma once

#include <Eigen/Core>

namespace sbeh::meshing {

/// Points and the triangles between them, corners counter-clockwise seen from outside. Nothing is
/// promised beyond that the indices are in range: see `quality.h` for what makes it a surface.
struct TriangleMesh {
  Eigen::Matrix3Xd points;     ///< 3 x points
  Eigen::Matrix3Xi triangles;  ///< 3 x triangles, indices of points

  int point_count() const { return int(points.cols()); }
  int triangle_count() const { return int(triangles.cols()); }
};

}  // namespace sbeh::meshing
