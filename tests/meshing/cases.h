// Shapes and their exact integrals which the tests of meshing share.
//
// The exact integrals are taken over the unit sphere, of which every shape here is a polynomial
// image or a star-shaped one, by Gauss–Legendre in cos θ and the trapezoidal rule in φ, with all
// derivatives by automatic differentiation: nothing of meshing/ is used.
#pragma once

#include "meshing/curvature.h"
#include "meshing/measures.h"
#include "meshing/shapes.h"
#include "model/numerics/quadrature.h"
#include "model/numerics/second_order.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace sbeh::meshing::test {

using Eigen::Vector3d;
using std::numbers::pi;

using Number = model::SecondOrder<2>;  // a function of (θ, φ)
using Point = std::array<Number, 3>;
using SphereImage = std::function<Point(const Point& n)>;

struct Integrals {
  double area = 0, volume = 0, H = 0, H_squared = 0, K = 0;
};

inline Point unit_vector(double theta, double phi) {
  using Gradient = Number::Gradient;
  using Hessian = Number::Hessian;
  const auto angle = [](double value, double slope, int k) {
    Gradient g = Gradient::Zero();
    Hessian h = Hessian::Zero();
    g[k] = slope;
    h(k, k) = -value;
    return Number(value, g, h);
  };
  const Number sin_theta = angle(std::sin(theta), std::cos(theta), 0);
  const Number cos_theta = angle(std::cos(theta), -std::sin(theta), 0);
  const Number sin_phi = angle(std::sin(phi), std::cos(phi), 1);
  const Number cos_phi = angle(std::cos(phi), -std::sin(phi), 1);
  return {sin_theta * cos_phi, sin_theta * sin_phi, cos_theta};
}

/// With n points in θ and 2n in φ.
inline Integrals exact_integrals(const SphereImage& image, int n = 120) {
  const model::IntervalRule rule = model::gauss_rule(n);
  Integrals sum;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const double theta = std::acos(1 - 2 * rule.points[i]), phi = pi * (j + 0.5) / n;
      const Point X = image(unit_vector(theta, phi));
      const auto vector = [&](auto&& part) { return Vector3d(part(X[0]), part(X[1]), part(X[2])); };
      const Vector3d x = vector([](const Number& a) { return a.a; });
      Eigen::Matrix<double, 3, 2> dX;
      for (int k = 0; k < 2; ++k) dX.col(k) = vector([&](const Number& a) { return a.g[k]; });
      const Vector3d N = dX.col(0).cross(dX.col(1)), unit = N.normalized();
      const Eigen::Matrix2d g = dX.transpose() * dX;
      Eigen::Matrix2d h;
      for (int k = 0; k < 2; ++k)
        for (int l = 0; l < 2; ++l)
          h(k, l) = unit.dot(vector([&](const Number& a) { return a.h(k, l); }));
      const double weight = 2 * rule.weights[i] / std::sin(theta) * pi / n;  // dθ dφ
      const double dS = weight * N.norm(), H = (g.inverse() * h).trace();
      sum.area += dS;
      sum.volume += weight * x.dot(N) / 3;
      sum.H += H * dS;
      sum.H_squared += H * H * dS;
      sum.K += h.determinant() / g.determinant() * dS;
    }
  return sum;
}

inline Integrals integrals_of(const CurvedMesh& mesh) {
  Integrals sum{.area = area(mesh), .volume = volume(mesh)};
  for_each_point(mesh, 12, [&](const SurfacePoint& p) {
    sum.H += p.H() * p.dS;
    sum.H_squared += p.H() * p.H() * p.dS;
    sum.K += p.K() * p.dS;
  });
  return sum;
}

/// 1 + 0.5 Y_53, from the closed form of the real orthonormal harmonic.
inline Point y53_image(const Point& n) {
  const auto& [x, y, z] = n;
  const double c = 0.5 * std::sqrt(770 / pi) / 32;
  const Number r = 1 + c * (x * x * x - 3 * x * y * y) * (9 * z * z - 1);
  return {r * x, r * y, r * z};
}
inline CurvedMesh y53(const Resolution& resolution) {
  const Harmonic mode{5, 3, 0.5};
  return harmonic_sphere({&mode, 1}, resolution);
}

/// A biconcave disc: r = 1.2 sin θ, z = (0.2 + 0.5 sin² θ) cos θ.
inline Point disc_image(const Point& n) {
  const auto& [x, y, z] = n;
  return {1.2 * x, 1.2 * y, (0.7 - 0.5 * z * z) * z};
}

}  // namespace sbeh::meshing::test
