#include "meshing/triangle_search.h"

#include "meshing/half_edge_mesh.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
#include <utility>

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

// The tree points into the triangles: both stay where they are.
struct Tree {
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

}  // namespace

NearestTriangle nearest_triangle(const TriangleMesh& mesh) {
  return [search = std::make_shared<const Tree>(mesh)](const Eigen::Vector3d& x) -> TrianglePlace {
    const auto [foot, triangle] =
        search->tree.closest_point_and_primitive(Kernel::Point_3(x[0], x[1], x[2]));
    const int t = int(triangle - search->triangles.begin());
    const Eigen::Matrix3d corner = search->mesh.points(Eigen::all, search->mesh.triangles.col(t));
    return {t, barycentric(corner, {foot[0], foot[1], foot[2]})};
  };
}

std::vector<std::array<int, 2>> self_intersections(const TriangleMesh& mesh) {
  const HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  std::vector<std::pair<OpenMesh::FaceHandle, OpenMesh::FaceHandle>> found;
  CGAL::Polygon_mesh_processing::self_intersections(half_edges, std::back_inserter(found));
  std::vector<std::array<int, 2>> pairs;
  for (const auto& [a, b] : found) {
    pairs.push_back({std::min(a.idx(), b.idx()), std::max(a.idx(), b.idx())});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool intersect(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  const auto triangle = [](const Eigen::Matrix3d& x) {
    const auto point = [&](int k) { return Kernel::Point_3(x(0, k), x(1, k), x(2, k)); };
    return Kernel::Triangle_3(point(0), point(1), point(2));
  };
  return CGAL::do_intersect(triangle(a), triangle(b));
}

std::vector<std::array<int, 2>> overlapping_boxes(const Eigen::Matrix3Xd& low,
                                                  const Eigen::Matrix3Xd& high) {
  using Box =
      CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;
  std::vector<Box> boxes;
  boxes.reserve(std::size_t(low.cols()));
  for (Eigen::Index i = 0; i < low.cols(); ++i)
    boxes.emplace_back(CGAL::Bbox_3(low(0, i), low(1, i), low(2, i),  //
                                    high(0, i), high(1, i), high(2, i)));
  std::vector<const Box*> shuffled;  // by the search: the boxes stay, so that their address tells
  for (const Box& box : boxes) shuffled.push_back(&box);
  std::vector<std::array<int, 2>> pairs;
  CGAL::box_self_intersection_d(shuffled.begin(), shuffled.end(), [&](const Box* a, const Box* b) {
    const int i = int(a - boxes.data()), j = int(b - boxes.data());
    pairs.push_back({std::min(i, j), std::max(i, j)});
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace sbeh::meshing
