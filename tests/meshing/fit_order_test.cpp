// Curved nodes through the points of a plain mesh come near the smooth surface at their order.
#include "meshing/curving.h"
#include "meshing/fitted_surface.h"
#include "meshing/remeshing.h"
#include "tests/meshing/cases.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sbeh::meshing {
namespace {

using namespace test;
using sbeh::test::OrderTable;

const Vector3d axes(1, 1.3, 0.7);

double distance(const CurvedMesh& mesh) {
  // To first order the distance to the ellipsoid.
  double worst = 0;
  for (const auto x : mesh.nodes.colwise()) {
    const double level = x.cwiseQuotient(axes).squaredNorm() - 1;
    worst = std::max(worst, std::abs(level) / (2 * x.cwiseQuotient(axes.cwiseAbs2()).norm()));
  }
  return worst;
}

CurvedMesh fitted(const TriangleMesh& plain) {
  const FittedSurface surface(plain);
  return curved(plain, 3, Placement([&](int t, const Vector3d& b) { return surface.at(t, b); }));
}

TEST(FittedSurface, goes_through_the_points) {
  const TriangleMesh plain = corners(ellipsoid(axes, {.triangles = 320, .order = 1}));
  const FittedSurface surface(plain);
  for (int t = 0; t < plain.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_LT((surface.at(t, Vector3d::Unit(k)) - plain.points.col(plain.triangles(k, t))).norm(),
                1e-15);
}

TEST(FittedSurface, is_within_the_fifth_power_of_the_edge_length) {
  OrderTable to_surface("distance of the fitted nodes", "h"), volumes("volume", "h");
  for (const int count : {1280, 5120, 20480}) {
    const CurvedMesh exact = ellipsoid(axes, {.triangles = count});
    const CurvedMesh mesh = fitted(corners(exact));
    to_surface.add(std::sqrt(20. / count), distance(mesh));
    volumes.add(std::sqrt(20. / count), volume(mesh) / (4 * pi / 3 * axes.prod()) - 1);
  }
  EXPECT_GT(to_surface.print(), 4.5);
  EXPECT_GT(volumes.print(), 3.5);
}

TEST(FittedSurface, gives_other_triangles_than_its_own_the_same_surface) {
  const auto surface =
      std::make_shared<FittedSurface>(corners(ellipsoid(axes, {.triangles = 5120, .order = 1})));
  const Projection to_surface = onto(surface);
  const CurvedMesh mesh = curved(remeshed(surface->mesh(), 1280, to_surface, 0), 3, to_surface);
  EXPECT_NEAR(mesh.triangle_count(), 1280, 0.15 * 1280);
  EXPECT_LT(distance(mesh), 2 * distance(fitted(surface->mesh())));
}

TEST(FittedSurface, refuses_sharp_edges_and_open_surfaces) {
  TriangleMesh tetrahedron{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xi(3, 4)};
  tetrahedron.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  tetrahedron.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  EXPECT_THROW(FittedSurface{tetrahedron}, std::invalid_argument);
  TriangleMesh open = corners(sphere({.triangles = 320, .order = 1}));
  open.triangles.conservativeResize(3, open.triangle_count() - 1);
  EXPECT_THROW(FittedSurface{open}, std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::meshing
