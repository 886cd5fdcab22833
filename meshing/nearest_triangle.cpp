#include "meshing/nearest_triangle.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>

#include <vector>

namespace sbeh::meshing {

namespace {

using Kernel = CGAL::Epick;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

Eigen::Vector3d barycentric(const Eigen::Matrix3d& corner, const Eigen::Vector3d& x) {
  const Eigen::Vector3d u = corner.col(1) - corner.col(0), v = corner.col(2) - corner.col(0);
  const Eigen::Vector3d n = u.cross(v), d = x - corner.col(0);
  const double b = d.cross(v).dot(n) / n.squaredNorm(), c = u.cross(d).dot(n) / n.squaredNorm();
  Eigen::Vector3d result = Eigen::Vector3d(1 - b - c, b, c).cwiseMax(0);
  return result / result.sum();
}

}  // namespace

// The tree points into the triangles: both stay where they are.
struct NearestTriangle::Tree {
  explicit Tree(TriangleMesh of) : mesh(std::move(of)) {
    const auto point = [&](int i) {
      return Kernel::Point_3(mesh.points(0, i), mesh.points(1, i), mesh.points(2, i));
    };
    for (const auto c : mesh.triangles.colwise())
      triangles.emplace_back(point(c[0]), point(c[1]), point(c[2]));
    tree.rebuild(triangles.begin(), triangles.end());
    tree.accelerate_distance_queries();
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  TriangleMesh mesh;
  Triangles triangles;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree;
};

NearestTriangle::NearestTriangle(const TriangleMesh& mesh)
    : tree_(std::make_shared<const Tree>(mesh)) {}

NearestTriangle::Place NearestTriangle::operator()(const Eigen::Vector3d& x) const {
  const auto [foot, triangle] =
      tree_->tree.closest_point_and_primitive(Kernel::Point_3(x[0], x[1], x[2]));
  const int t = int(triangle - tree_->triangles.begin());
  const Eigen::Matrix3d corner = tree_->mesh.points(Eigen::all, tree_->mesh.triangles.col(t));
  return {t, barycentric(corner, {foot[0], foot[1], foot[2]})};
}

}  // namespace sbeh::meshing
