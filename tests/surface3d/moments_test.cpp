// Moments of surfaces against closed values.
#include "surface3d/moments.h"

#include "tests/surface3d/cases.h"

#include <Eigen/Geometry>

namespace sbeh::surface3d::test {
namespace {

TEST(Moments, of_a_sphere_are_a_third_about_its_centre) {
  Surface s = uniform_sphere(model::full_order, 320);
  s.state.X.colwise() += Eigen::Vector3d(3, -2, 1);
  const Moments m = moments_of(samples_of(*s.mesh, s.state.X));
  // The P3 surface of 320 triangles is a sphere to 2e-6.
  EXPECT_LT((m.centre - Eigen::Vector3d(3, -2, 1)).norm(), 2e-6);
  EXPECT_LT((m.principal.array() - 1. / 3).abs().maxCoeff(), 2e-6);
}

TEST(Moments, tell_the_axis_of_an_oblate_and_of_a_prolate) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -2) / 3;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
  for (const bool prolate : {false, true}) {
    const Surface s = surface_of(meshing::ellipsoid(0.8, prolate, {.triangles = 320}));
    const Nodes X = turn.toRotationMatrix() * s.state.X;
    const Moments m = moments_of(samples_of(*s.mesh, X));
    EXPECT_NEAR(std::abs(m.distinct_axis().dot(axis)), 1, 1e-6);
  }
}

}  // namespace
}  // namespace sbeh::surface3d::test
