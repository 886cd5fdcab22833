#include "meshing/fitted_surface.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>

namespace sbeh::meshing {

namespace {

using Kernel = CGAL::Epick;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

// The tree points into the triangles: both stay where they are.
struct Nearest {
  explicit Nearest(const TriangleMesh& mesh) {
    const auto point = [&](int i) {
      return Kernel::Point_3(mesh.points(0, i), mesh.points(1, i), mesh.points(2, i));
    };
    for (const auto c : mesh.triangles.colwise())
      triangles.emplace_back(point(c[0]), point(c[1]), point(c[2]));
    tree.rebuild(triangles.begin(), triangles.end());
    tree.accelerate_distance_queries();
  }
  Nearest(const Nearest&) = delete;
  Nearest& operator=(const Nearest&) = delete;

  Triangles triangles;
  Tree tree;
};

Eigen::Vector3d barycentric(const Eigen::Matrix3d& corner, const Eigen::Vector3d& x) {
  const Eigen::Vector3d u = corner.col(1) - corner.col(0), v = corner.col(2) - corner.col(0);
  const Eigen::Vector3d n = u.cross(v), d = x - corner.col(0);
  const double b = d.cross(v).dot(n) / n.squaredNorm(), c = u.cross(d).dot(n) / n.squaredNorm();
  Eigen::Vector3d result = Eigen::Vector3d(1 - b - c, b, c).cwiseMax(0);
  return result / result.sum();
}

}  // namespace

Projection onto(std::shared_ptr<const FittedSurface> surface) {
  const auto nearest = std::make_shared<const Nearest>(surface->mesh());
  return [surface, nearest](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    const auto [foot, triangle] =
        nearest->tree.closest_point_and_primitive(Kernel::Point_3(x[0], x[1], x[2]));
    const int t = int(triangle - nearest->triangles.begin());
    const Eigen::Matrix3d corner =
        surface->mesh().points(Eigen::all, surface->mesh().triangles.col(t));
    return surface->at(t, barycentric(corner, {foot[0], foot[1], foot[2]}));
  };
}

}  // namespace sbeh::meshing
