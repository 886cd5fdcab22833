// Spherical harmonics refuse what they cannot take.
#include "meshing/shapes.h"
#include "surface3d/harmonic/minimiser.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace sbeh::surface3d {
namespace {

TEST(Harmonics, refuse_volumes_and_degrees_out_of_range) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const HarmonicSurface start = harmonic_spheroid(0.8, false, 8);
  for (const double v : {0., 1., -0.5, 2., nan}) {
    EXPECT_THROW(minimise_harmonics(start, v, 8), std::invalid_argument) << v;
    EXPECT_THROW(harmonic_spheroid(v, true, 8), std::invalid_argument) << v;
  }
  for (const int degree : {-1, 3, 33})
    EXPECT_THROW(minimise_harmonics(start, 0.8, degree), std::invalid_argument) << degree;
}

TEST(Harmonics, refuse_too_few_points_and_points_in_a_plane) {
  const meshing::CurvedMesh mesh = meshing::sphere({.triangles = 20});
  EXPECT_THROW(fit_harmonics(mesh.nodes, Eigen::VectorXd::Ones(mesh.node_count()), 10),
               std::invalid_argument);
  Eigen::Matrix3Xd flat = mesh.nodes;
  flat.row(2).setZero();
  EXPECT_THROW(fit_harmonics(flat, Eigen::VectorXd::Ones(flat.cols()), 4), std::invalid_argument);
}

TEST(Harmonics, say_where_a_surface_left_their_reach) {
  HarmonicSurface start = harmonic_ellipsoid({1, 1, 1}, 8);
  start.coefficients[8 * 8 + 8] = 3;  // inside out
  EXPECT_EQ(minimise_harmonics(start, 0.8, 8).stop, HarmonicStop::degenerate);
}

}  // namespace
}  // namespace sbeh::surface3d
