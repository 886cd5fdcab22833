// The nearest point of a curved surface.
#include "meshing/closest_point.h"

#include "meshing/measures.h"
#include "tests/meshing/cases.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace sbeh::meshing {
namespace {

using namespace test;

// Places all over the surface: inside triangles, on their edges and corners.
std::vector<SurfacePlace> places(const CurvedMesh& mesh) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<SurfacePlace> result;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const double u = uniform(generator), v = (1 - u) * uniform(generator);
    for (const Eigen::Vector2d& at :
         {Eigen::Vector2d(u, v), Eigen::Vector2d(u, 0), Eigen::Vector2d(0, u),
          Eigen::Vector2d(u, 1 - u), Eigen::Vector2d(0, 0)})
      result.push_back({t, at});
  }
  return result;
}

TEST(ClosestPoint, of_a_point_of_the_surface_is_that_point_for_all_orders) {
  for (const int order : {1, 2, 3}) {
    const CurvedMesh mesh = y53({.triangles = 320, .order = order});
    const ClosestPoint closest(mesh);
    for (const SurfacePlace& place : places(mesh)) {
      const Vector3d x = closest.point(place);
      EXPECT_LT((closest.point(closest(x)) - x).norm(), 1e-13);
    }
    for (int i = 0; i < mesh.node_count(); ++i)
      EXPECT_LT((closest.point(closest(mesh.nodes.col(i))) - mesh.nodes.col(i)).norm(), 1e-13);
  }
}

TEST(ClosestPoint, is_perpendicular_below_a_point_near_the_surface) {
  // Where triangles meet at an angle (below 0.02 here), two points have nearly this distance.
  constexpr double kink = 0.02;
  const CurvedMesh mesh = y53({.triangles = 1280});
  const ClosestPoint closest(mesh);
  const Eigen::Matrix3Xd normals = node_normals(mesh);
  for (int i = 0; i < mesh.node_count(); ++i) {
    const double height = i % 2 == 0 ? 0.01 : -0.01;  // radii of curvature are above 0.1
    const Vector3d x = mesh.nodes.col(i) + height * normals.col(i);
    const Vector3d foot = closest.point(closest(x));
    EXPECT_LT((foot - mesh.nodes.col(i)).norm(), 2 * kink * std::abs(height));
    EXPECT_LT((foot - x).norm(), (1 + kink * kink) * std::abs(height));
  }
}

TEST(ClosestPoint, has_the_values_of_a_field_that_is_a_cubic_there) {
  const CurvedMesh mesh = y53({.triangles = 80});
  const ClosestPoint closest(mesh);
  const Vector3d g(0.3, -0.7, 1.1);
  const Eigen::VectorXd field = (g.transpose() * mesh.nodes).transpose();
  for (const SurfacePlace& place : places(mesh))
    EXPECT_NEAR(closest.value(field, place), g.dot(closest.point(place)), 1e-13);
}

}  // namespace
}  // namespace sbeh::meshing
