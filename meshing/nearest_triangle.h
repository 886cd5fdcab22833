// Which of many plain triangles is nearest to a point, and where.
#pragma once

#include "meshing/triangle_mesh.h"

#include <memory>

namespace sbeh::meshing {

/// Triangles prepared for searching (CGAL). Copies share the tree.
class NearestTriangle {
 public:
  explicit NearestTriangle(const TriangleMesh& mesh);

  struct Place {
    int triangle;
    Eigen::Vector3d barycentric;  ///< >= 0, sum 1
  };
  Place operator()(const Eigen::Vector3d& x) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace sbeh::meshing
