#include "surface3d/harmonic/surface.h"

#include "model/numerics/spheroid.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::surface3d {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

// Exponent of the ellipsoid's axes: for 0.65 <= V_r <= 0.8 the coefficients fall fastest between 0.7 and 0.85,
// and at V_r = 0.65 the ellipsoid of equal moments does not lead to the prolate.
constexpr double roundness = 0.75;

}  // namespace

SurfaceSamples samples_of(const HarmonicSurface& surface, const SphereRule& rule) {
  const HarmonicBasis basis = harmonic_basis(surface.degree, rule.omega);
  const VectorXd u = basis.Y[0] * surface.coefficients, u_s = basis.Y[1] * surface.coefficients,
                 u_t = basis.Y[2] * surface.coefficients;
  const Matrix3d T = surface.direction();
  SurfaceSamples samples{Matrix3Xd(3, u.size()), rule.weights};
  for (Index p = 0; p < u.size(); ++p) {
    const Vector3d omega = rule.omega.col(p);
    const Matrix3d scale = surface.ellipsoid + u[p] * T, frame = frame_at(omega);
    samples.points.col(p) = surface.centre + scale * omega;
    const Vector3d x_s = scale * frame.col(0) + u_s[p] * (T * omega),
                   x_t = scale * frame.col(1) + u_t[p] * (T * omega);
    samples.areas[p] *= x_s.cross(x_t).norm();
  }
  return samples;
}

Matrix3d HarmonicSurface::direction() const {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(ellipsoid);
  return std::sqrt(ellipsoid.determinant()) * eigen.operatorInverseSqrt();
}

Vector3d HarmonicSurface::at(const Vector3d& omega) const {
  return centre + (ellipsoid + harmonics_at(degree, omega).dot(coefficients) * direction()) * omega;
}

HarmonicSurface HarmonicSurface::with_degree(int other) const {
  HarmonicSurface surface{other, centre, ellipsoid, VectorXd::Zero(harmonic_count(other))};
  const Index common = harmonic_count(std::min(degree, other));
  surface.coefficients.head(common) = coefficients.head(common);
  return surface;
}

// With d_i and t_i on the axes of D: Σ (x_i/(d_i + u t_i))² = 1, whose left side falls and is convex where
// all d_i + u t_i > 0, so that Newton's method climbs to the root from below.
EllipsoidCoordinates coordinates_of(const HarmonicSurface& surface, const Vector3d& x) {
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(surface.ellipsoid);
  const Eigen::Array3d d = eigen.eigenvalues(), t = (d.prod() / d).sqrt();
  const Eigen::Array3d y = eigen.eigenvectors().transpose() * (x - surface.centre);
  double u = ((y.abs() - d) / t).maxCoeff();
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Eigen::Array3d scale = d + u * t, w = y / scale;
    const double step = (w.square().sum() - 1) / (2 * (w.square() * t / scale).sum());
    u += step;
    if (std::abs(step) < 1e-15) break;
  }
  return {(eigen.eigenvectors() * (y / (d + u * t)).matrix()).normalized(), u};
}

HarmonicSurface harmonic_ellipsoid(const Vector3d& semi_axes, int degree) {
  return {degree, Vector3d::Zero(), semi_axes.asDiagonal(), VectorXd::Zero(harmonic_count(degree))};
}

HarmonicSurface harmonic_spheroid(double reduced_volume, bool prolate, int degree) {
  if (!(reduced_volume > 0.1 && reduced_volume < 1))
    throw std::invalid_argument(
        fmt::format("reduced volume {}: must lie between 0.1 and 1", reduced_volume));
  const double c = model::spheroid_axis_ratio(reduced_volume, prolate);
  const double a = std::sqrt(4 * pi / model::spheroid_area(c));
  return harmonic_ellipsoid({a, a, a * c}, degree);
}

HarmonicSurface fit_harmonics(const Matrix3Xd& points, const VectorXd& weights, int degree) {
  const int count = harmonic_count(degree);
  if (points.cols() < count)
    throw std::invalid_argument(
        fmt::format("spherical harmonics up to degree {}: {} points do not determine {} "
                    "coefficients; lower the degree or refine the mesh",
                    degree, points.cols(), count));
  const Moments moments = moments_of({points, weights});
  if (!(moments.principal[0] > 1e-12 * moments.principal[2]))
    throw std::invalid_argument("spherical harmonics: the points lie in a plane");
  const Vector3d axes = moments.principal.cwiseSqrt();
  const Vector3d rounder = (axes / std::cbrt(axes.prod())).array().pow(roundness);
  HarmonicSurface surface{degree,
                          moments.centre,
                          std::sqrt(3.) * std::cbrt(axes.prod()) * moments.axes
                              * rounder.asDiagonal() * moments.axes.transpose(),
                          {}};
  MatrixXd A(points.cols(), count);
  VectorXd b(points.cols());
  for (Index p = 0; p < points.cols(); ++p) {
    const double root = std::sqrt(weights[p]);
    const auto [omega, u] = coordinates_of(surface, points.col(p));
    A.row(p) = root * harmonics_at(degree, omega).transpose();
    b[p] = root * u;
  }
  // The harmonics are nearly orthonormal on the points, the normal equations well conditioned.
  surface.coefficients = (A.transpose() * A).ldlt().solve(A.transpose() * b);
  return surface;
}

HarmonicSurface fit_harmonics(const Triangulation& mesh, const Nodes& X, int degree) {
  const auto [points, areas] = samples_of(mesh, X);
  return fit_harmonics(points, areas, degree);
}

HarmonicSurface refitted(const HarmonicSurface& surface) {
  const SurfaceSamples samples = samples_of(surface, sphere_rule(2 * (surface.degree + 1)));
  return fit_harmonics(samples.points, samples.areas, surface.degree);
}

Axis axis_of(const HarmonicSurface& surface) {
  const SurfaceSamples samples = samples_of(surface, sphere_rule(surface.degree + 1));
  const Moments moments = moments_of(samples);
  Axis axis{.direction = moments.distinct_axis(), .centre = moments.centre, .deviation = 0};
  for (int k = 1; k <= 8; ++k) {
    const Matrix3d turn =
        Eigen::AngleAxisd(2 * pi * std::numbers::phi * k, axis.direction).toRotationMatrix();
    for (const auto x : samples.points.colwise()) {
      const auto [omega, u] = coordinates_of(surface, axis.centre + turn * (x - axis.centre));
      const double own = harmonics_at(surface.degree, omega).dot(surface.coefficients);
      axis.deviation = std::max(axis.deviation, std::abs(u - own));
    }
  }
  return axis;
}

}  // namespace sbeh::surface3d
