// The gradients of area and volume against finite differences.
#include "tests/meshing/cases.h"

#include <gtest/gtest.h>

#include <random>

namespace sbeh::meshing {
namespace {

using namespace test;

void expect_gradient(double (*value)(const CurvedMesh&),
                     Eigen::Matrix3Xd (*gradient)(const CurvedMesh&)) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const int order : {1, 2, 3}) {
    const CurvedMesh mesh = y53({.triangles = 80, .order = order});
    const Eigen::Matrix3Xd way =
        Eigen::Matrix3Xd::NullaryExpr(3, mesh.node_count(), [&] { return uniform(random); });
    const auto at = [&](double t) {
      CurvedMesh moved = mesh;
      moved.nodes += t * way;
      return value(moved);
    };
    // Differences of the fourth order: their error is about t⁴ and rounding 1e-15/t.
    const double t = 1e-3;
    const double slope = (8 * (at(t) - at(-t)) - (at(2 * t) - at(-2 * t))) / (12 * t);
    const double exact = gradient(mesh).cwiseProduct(way).sum();
    EXPECT_NEAR(slope, exact, 1e-8 * gradient(mesh).norm() * way.norm()) << "order " << order;
  }
}

TEST(AreaGradient, is_the_derivative_of_the_area) {
  expect_gradient([](const CurvedMesh& m) { return area(m); }, area_gradient);
}

TEST(VolumeGradient, is_the_derivative_of_the_volume) {
  expect_gradient([](const CurvedMesh& m) { return volume(m); }, volume_gradient);
}

TEST(Volume, does_not_depend_on_the_origin) {
  for (const int order : {1, 2, 3}) {
    CurvedMesh mesh = y53({.triangles = 320, .order = order});
    const double before = volume(mesh);
    mesh.nodes.colwise() += Vector3d(10, -20, 30);
    EXPECT_NEAR(volume(mesh), before, 1e-10);  // 10⁴ triangles' worth of terms of size 1
  }
}

}  // namespace
}  // namespace sbeh::meshing
