// Cuts through curved surfaces: where they lie, that they are closed, and how many there are.
#include "meshing/cross_section.h"

#include "meshing/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::meshing {
namespace {

using Eigen::Vector3d;

double length_of(const CrossSection& curve) {
  double length = 0;
  for (Eigen::Index i = 1; i < curve.points.cols(); ++i)
    length += (curve.points.col(i) - curve.points.col(i - 1)).norm();
  return length;
}

// A linear field is reproduced by the elements: f at a point is a·x.
TEST(CrossSection, of_an_ellipsoid_is_one_closed_curve_in_the_plane_with_the_field_of_its_points) {
  const CurvedMesh mesh = ellipsoid(Vector3d(1.2, 1, 0.5), {.triangles = 320});
  const Vector3d a(0.3, -0.2, 0.7), normal = Vector3d(0.3, 1, 0.2).normalized(),
                                    point(0.1, 0.05, 0);
  const Eigen::VectorXd field = (a.transpose() * mesh.nodes).transpose();
  const auto curves = cross_section(mesh, field, point, normal);
  ASSERT_EQ(curves.size(), 1u);
  const CrossSection& curve = curves[0];
  ASSERT_GT(curve.points.cols(), 100);
  EXPECT_EQ((curve.points.col(0) - curve.points.rightCols<1>()).norm(), 0);
  double widest = 0;
  for (Eigen::Index i = 0; i < curve.points.cols(); ++i) {
    const Vector3d x = curve.points.col(i);
    EXPECT_NEAR(normal.dot(x - point), 0, 1e-14);
    EXPECT_NEAR(curve.values[i], a.dot(x), 1e-14);
    // P3 on triangles of side 0.25 where the curvature is up to 5
    EXPECT_NEAR(x.cwiseQuotient(Vector3d(1.2, 1, 0.5)).norm(), 1, 2e-3);
    if (i > 0) widest = std::max(widest, (x - curve.points.col(i - 1)).norm());
  }
  EXPECT_LT(widest, 0.1);  // an eighth of a side, across
}

TEST(CrossSection, through_the_middle_of_a_sphere_has_the_length_of_a_great_circle) {
  const CurvedMesh mesh = sphere({.triangles = 320});
  const auto curves = cross_section(mesh, Eigen::VectorXd::Zero(mesh.node_count()),
                                    Vector3d::Zero(), Vector3d(0.3, 0.9, 0.1));
  ASSERT_EQ(curves.size(), 1u);
  // A polygon of n sides falls short by π²/(6 n²) at least, of more than 100 by some 2e-4.
  const double length = length_of(curves[0]) / (2 * std::numbers::pi);
  EXPECT_LT(length, 1);
  EXPECT_GT(length, 1 - 5e-4);
}

// z = c − (3/4) c⁵ along the meridian, c = cos θ, is 0.25 at the pole and 0.57 on a ring about it.
TEST(CrossSection, of_a_dimple_above_its_bottom_is_two_rings) {
  const CurvedMesh mesh = star_shaped(
      [](const Vector3d& d) { return 1 - 0.75 * std::pow(d[2], 4); }, {.triangles = 1280});
  const Eigen::VectorXd field = mesh.nodes.row(2);
  const auto rings = [&](double z) {
    return cross_section(mesh, field, Vector3d(0, 0, z), Vector3d::UnitZ()).size();
  };
  EXPECT_EQ(rings(0.1), 1u);
  EXPECT_EQ(rings(0.45), 2u);
  EXPECT_EQ(rings(0.7), 0u);
}

}  // namespace
}  // namespace sbeh::meshing
