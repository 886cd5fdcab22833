// Spherical harmonics and the energy over them: derivatives against central differences, values against the
// sphere.
#include "meshing/spherical_harmonics.h"
#include "surface3d/harmonic/energy.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <numbers>

namespace sbeh::surface3d {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr int degree = 6;
constexpr double step = 1e-4;

// A surface without symmetry.
HarmonicSurface lump() {
  HarmonicSurface surface = harmonic_ellipsoid({1.3, 0.9, 0.7}, degree);
  for (Eigen::Index i = 0; i < surface.coefficients.size(); ++i)
    surface.coefficients[i] = 0.05 * std::sin(double(3 * i + 1)) / double(1 + i);
  return surface;
}

TEST(HarmonicBasis, has_the_harmonics_and_their_derivatives_everywhere) {
  Eigen::Matrix3Xd directions(3, 4);
  directions << 0, 0, 0.6, -0.48,  //
      0, 0, 0, 0.64,               //
      1, -1, 0.8, 0.6;
  const HarmonicBasis basis = harmonic_basis(degree, directions);
  for (Eigen::Index p = 0; p < directions.cols(); ++p) {
    const Eigen::Matrix3d frame = frame_at(directions.col(p));
    EXPECT_NEAR(frame.determinant(), 1, 1e-15);
    // Along the great circle at this angle from e1.
    const auto on_circle = [&](double angle, double arc) -> Vector3d {
      return std::cos(arc) * frame.col(2)
           + std::sin(arc) * (std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1));
    };
    for (int l = 0; l <= degree; ++l)
      for (int m = -l; m <= l; ++m) {
        const Eigen::Index i = Eigen::Index(l) * l + l + m;
        const auto Y = [&](double angle, double arc) {
          return meshing::spherical_harmonic(l, m, on_circle(angle, arc));
        };
        EXPECT_NEAR(basis.Y[0](p, i), Y(0, 0), 1e-13);
        EXPECT_NEAR(harmonics_at(degree, directions.col(p))[i], Y(0, 0), 1e-13);
        for (const double angle : {0., pi / 4, pi / 2}) {
          const double c = std::cos(angle), s = std::sin(angle);
          const double first = c * basis.Y[1](p, i) + s * basis.Y[2](p, i);
          const double second =
              c * c * basis.Y[3](p, i) + 2 * c * s * basis.Y[4](p, i) + s * s * basis.Y[5](p, i);
          EXPECT_NEAR(first, (Y(angle, step) - Y(angle, -step)) / (2 * step), 1e-6);
          EXPECT_NEAR(second, (Y(angle, step) - 2 * Y(angle, 0) + Y(angle, -step)) / (step * step),
                      1e-4);
        }
      }
  }
}

TEST(HarmonicEnergy, is_that_of_the_sphere) {
  const HarmonicSurface sphere = harmonic_ellipsoid({2, 2, 2}, degree);
  const auto at = HarmonicEnergy(sphere).expand(sphere.coefficients);
  EXPECT_NEAR(at->measures[0], 8 * pi, 1e-12);
  EXPECT_NEAR(at->measures[1], 16 * pi, 1e-12);
  EXPECT_NEAR(at->measures[2], 32 * pi / 3, 1e-12);
  EXPECT_NEAR(mean_curvature(sphere, Vector3d::UnitZ())[0], -1, 1e-14);
}

TEST(HarmonicEnergy, has_the_derivatives_that_differences_show) {
  const HarmonicSurface surface = lump();
  const HarmonicEnergy energy(surface);
  const VectorXd a = surface.coefficients;
  const auto at = energy.expand(a);
  ASSERT_TRUE(at);
  constexpr double tension = 2, pressure = -3;
  const MatrixXd K = energy.hessian(a, tension, pressure);
  MatrixXd J;
  const VectorXd f = energy.root_curvature(a, &J);
  EXPECT_NEAR(f.squaredNorm() / 2, at->measures[0], 1e-12);
  EXPECT_LT((J.transpose() * f - at->gradients.col(0)).norm(), 1e-11);
  const auto lagrangian = [&](const VectorXd& x) -> VectorXd {
    const auto there = energy.expand(x);
    return there->gradients.col(0) + tension * there->gradients.col(1)
         - pressure * there->gradients.col(2);
  };
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    VectorXd up = a, down = a;
    up[i] += step, down[i] -= step;
    const Vector3d slope =
        (energy.expand(up)->measures - energy.expand(down)->measures) / (2 * step);
    EXPECT_LT((slope - at->gradients.row(i).transpose()).norm(), 1e-5 * (1 + slope.norm())) << i;
    const VectorXd column = (lagrangian(up) - lagrangian(down)) / (2 * step);
    EXPECT_LT((column - K.col(i)).norm(), 1e-5 * (1 + K.col(i).norm())) << i;
  }
}

TEST(RigidMotions, change_neither_area_nor_volume_nor_energy) {
  const HarmonicSurface surface = lump().with_degree(16);
  const HarmonicEnergy energy(surface);
  const Eigen::Matrix<double, 6, 3> rates = energy.rigid_motions(surface.coefficients).transpose()
                                          * energy.expand(surface.coefficients)->gradients;
  EXPECT_LT(rates.cwiseAbs().maxCoeff(), 1e-4);  // what degree 16 leaves of the motions
}

}  // namespace
}  // namespace sbeh::surface3d
