// Smooth closed surfaces with smooth fields: images of the unit sphere under polynomials.
//
// A point n of the unit sphere is seen as a Taylor series in the angles (θ, φ), and a polynomial of n
// is smooth at the poles too, so that everything here is exact but for rounding.
#pragma once

#include "model/numerics/quadrature.h"
#include "model/terms.h"
#include "tests/model/taylor.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace sbeh::model::test {

using Point = std::array<Taylor, 3>;  // (x, y, z)

/// A surface with an order, and a variation of both: displacement W and change of order ψ.
struct Example {
  const char* name;
  bool axisymmetric;  ///< nothing depends on φ but the direction of vectors
  Point (*position)(const Point& n);
  Taylor (*order)(const Point& n);
  Point (*displacement)(const Point& n);
  Taylor (*order_change)(const Point& n);
};

/// Neither is symmetric from top to bottom; the second has no symmetry at all.
inline const std::array<Example, 2> examples{
    Example{
        .name = "axisymmetric",
        .axisymmetric = true,
        .position = [](const Point& n) -> Point {
          const Taylor& z = n[2];
          const Taylor cos2 = 2 * z * z - 1, cos3 = (4 * z * z - 3) * z;
          const Taylor radius = 1 + 0.1 * cos2 + 0.07 * cos3;
          return {radius * n[0], radius * n[1], radius * z};
        },
        .order = [](const Point& n) -> Taylor {
          const Taylor& z = n[2];
          return 0.45 + 0.1 * z + 0.2 * z * z - 0.3 * z * z * z;
        },
        .displacement = [](const Point& n) -> Point {
          const auto& [x, y, z] = n;
          const Taylor radial = 0.4 + 0.7 * z - 0.5 * z * z;
          return {radial * x, radial * y, 0.3 - 0.8 * z + 0.6 * z * z};
        },
        .order_change = [](const Point& n) -> Taylor {
          const Taylor& z = n[2];
          return 0.3 - 0.5 * z + 0.9 * z * z;
        },
    },
    Example{
        .name = "without_symmetry",
        .axisymmetric = false,
        .position = [](const Point& n) -> Point {
          const auto& [x, y, z] = n;
          const Taylor radius = 1 + 0.15 * x * y + 0.1 * z * z * z - 0.12 * x * z;
          return {radius * x + 0.05 * y * y, radius * y + 0.08 * x * z, radius * z - 0.06 * x * y};
        },
        .order = [](const Point& n) -> Taylor {
          const auto& [x, y, z] = n;
          return 0.4 + 0.1 * x - 0.15 * y * z + 0.12 * z * z + 0.07 * x * y;
        },
        .displacement = [](const Point& n) -> Point {
          const auto& [x, y, z] = n;
          return {0.2 - 0.5 * x * y + 0.3 * z, 0.4 * z * z + 0.6 * x, 0.5 * y - 0.4 * x * z};
        },
        .order_change = [](const Point& n) -> Taylor {
          const auto& [x, y, z] = n;
          return 0.3 + 0.4 * y - 0.6 * x * z + 0.2 * x * x;
        },
    },
};

/// The point of the unit sphere at angle θ from the north pole and longitude φ.
inline Point unit_sphere(double theta, double phi) {
  const double s = std::sin(theta), c = std::cos(theta);
  const Taylor sin_theta = Taylor::of_u({s, c, -s, -c}), cos_theta = Taylor::of_u({c, -s, -c, s});
  const double sp = std::sin(phi), cp = std::cos(phi);
  return {sin_theta * Taylor::of_v({cp, -sp, -cp, sp}),
          sin_theta * Taylor::of_v({sp, cp, -sp, -cp}), cos_theta};
}

/// Quadrature over the sphere of directions; the weights sum to 4π.
struct Direction {
  Point n;
  double sin_theta, weight;
};
/// Gauss in cos θ times the trapezoidal rule in φ; both converge exponentially.
inline std::vector<Direction> directions(bool axisymmetric, int points) {
  const IntervalRule along = gauss_rule(points);
  const int around = axisymmetric ? 1 : 2 * points;
  std::vector<Direction> all;
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < around; ++j) {
      const double theta = std::acos(1 - 2 * along.points[i]);
      const double phi = 2 * std::numbers::pi * (j + 0.3) / around;
      all.push_back({unit_sphere(theta, phi), std::sin(theta),
                     4 * std::numbers::pi * along.weights[i] / around});
    }
  return all;
}

/// Geometry of X at a point, in the frame (e1, e2, ν) of model/terms.h with e1 along ∂_θ X.
struct SurfacePoint {
  Eigen::Matrix3d frame;    // columns e1, e2, ν
  double area;              ///< |∂_θ X × ∂_φ X|
  Eigen::Matrix2d inverse;  // row: e1, e2; column: ∂_θ, ∂_φ; takes f_θ, f_φ to ∇f
  double H;                 ///< −2 on the unit sphere
  Tangent<double> grad_H;   // e1, e2
  ShapeOperator<double> B;  // e1, e2
  ElasticPoint<double, double> with_order(const Taylor& beta) const {
    return {beta.derivative(0, 0).a, gradient(beta), B, H, grad_H};
  }
  double K() const { return B.determinant(); }
  /// ∇f
  Tangent<double> gradient(const Taylor& f) const { return inverse * f.derivative(0, 0).v; }
  /// ∇_C W
  Gradient<double> gradient(const Point& W) const {
    Gradient<double> cartesian;  // row: x, y, z
    for (int k = 0; k < 3; ++k) cartesian.row(k) = gradient(W[k]).transpose();
    return frame.transpose() * cartesian;
  }
  /// W in the frame.
  Vector<double> components(const Point& W) const {
    return frame.transpose()
         * Vector<double>(W[0].derivative(0, 0).a, W[1].derivative(0, 0).a,
                          W[2].derivative(0, 0).a);
  }
};

inline SurfacePoint surface_point(const Point& X) {
  using Jet = ceres::Jet<double, 2>;  // value and derivatives by θ, φ
  using Vector3 = Eigen::Matrix<Jet, 3, 1>;
  const auto derivative = [&X](int i, int j) {
    return Vector3(X[0].derivative(i, j), X[1].derivative(i, j), X[2].derivative(i, j));
  };
  const auto value = [](const Vector3& v) { return Vector<double>(v[0].a, v[1].a, v[2].a); };
  const Vector3 X_1 = derivative(1, 0), X_2 = derivative(0, 1);
  const Vector3 normal = X_1.cross(X_2);
  const Jet area = normal.norm();
  const Vector3 nu = normal / area;
  const Jet g_11 = X_1.dot(X_1), g_12 = X_1.dot(X_2), g_22 = X_2.dot(X_2);
  const Jet b_11 = derivative(2, 0).dot(nu), b_12 = derivative(1, 1).dot(nu),
            b_22 = derivative(0, 2).dot(nu);
  const Jet H = (b_11 * g_22 - 2. * b_12 * g_12 + b_22 * g_11) / (area * area);

  SurfacePoint p;
  p.area = area.a;
  p.frame.col(2) = value(nu);
  p.frame.col(0) = value(X_1).normalized();
  p.frame.col(1) = p.frame.col(2).cross(p.frame.col(0));
  Eigen::Matrix2d along;  // row: ∂_θ X, ∂_φ X; column: e1, e2
  along.row(0) = value(X_1).transpose() * p.frame.leftCols<2>();
  along.row(1) = value(X_2).transpose() * p.frame.leftCols<2>();
  p.inverse = along.inverse();
  Eigen::Matrix2d b;
  b << b_11.a, b_12.a, b_12.a, b_22.a;
  p.B = p.inverse * b * p.inverse.transpose();
  p.H = H.a;
  p.grad_H = p.inverse * H.v;
  return p;
}

/// ∫ f dS over the surface of an example, f(point of the surface, n).
template <class Integrand>
double integral(const Example& example, const std::vector<Direction>& directions,
                const Integrand& f) {
  double sum = 0;
  for (const Direction& d : directions) {
    const SurfacePoint p = surface_point(example.position(d.n));
    sum += f(p, d.n) * p.area / d.sin_theta * d.weight;
  }
  return sum;
}

}  // namespace sbeh::model::test
