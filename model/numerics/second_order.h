// Automatic differentiation to second order: a number that carries its gradient and Hessian.
//
// ceres::Jet, used elsewhere for first derivatives, does not mix with plain numbers when nested.
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace sbeh::model {

/// Value, gradient and Hessian by N independent variables. Columns of more than four numbers are filled up by zeros to
/// whole vector registers.
template <int N>
struct SecondOrder {
  static constexpr int padded = N > 4 ? (N + 7) / 8 * 8 : N;
  using Gradient = Eigen::Matrix<double, padded, 1>;
  using Hessian = Eigen::Matrix<double, padded, N>;

  double a = 0;
  Gradient g = Gradient::Zero();
  Hessian h = Hessian::Zero();

  SecondOrder() = default;
  SecondOrder(double value) : a(value) {}  // NOLINT: constants mix freely with variables
  /// The k-th independent variable.
  SecondOrder(double value, int k) : a(value) { g[k] = 1; }
  SecondOrder(double value, Gradient gradient, Hessian hessian)
      : a(value), g(std::move(gradient)), h(std::move(hessian)) {}

  auto gradient() const { return g.template head<N>(); }
  auto hessian() const { return h.template topRows<N>(); }

  friend SecondOrder operator+(const SecondOrder& x, const SecondOrder& y) {
    return {x.a + y.a, x.g + y.g, x.h + y.h};
  }
  friend SecondOrder operator-(const SecondOrder& x, const SecondOrder& y) {
    return {x.a - y.a, x.g - y.g, x.h - y.h};
  }
  friend SecondOrder operator*(const SecondOrder& x, const SecondOrder& y) {
    SecondOrder p{x.a * y.a, x.a * y.g + y.a * x.g, x.a * y.h + y.a * x.h};
    p.h.noalias() += x.g * y.gradient().transpose();
    p.h.noalias() += y.g * x.gradient().transpose();
    return p;
  }
  friend SecondOrder operator/(const SecondOrder& x, const SecondOrder& y) {
    return x * y.apply(1 / y.a, -1 / (y.a * y.a), 2 / (y.a * y.a * y.a));
  }
  friend SecondOrder sqrt(const SecondOrder& x) {
    const double root = std::sqrt(x.a);
    return x.apply(root, 0.5 / root, -0.25 / (root * x.a));
  }
  friend SecondOrder atan(const SecondOrder& x) {
    const double slope = 1 / (1 + x.a * x.a);
    return x.apply(std::atan(x.a), slope, -2 * x.a * slope * slope);
  }

  // With a plain number on one side.
  friend SecondOrder operator+(const SecondOrder& x, double c) { return {x.a + c, x.g, x.h}; }
  friend SecondOrder operator+(double c, const SecondOrder& x) { return x + c; }
  friend SecondOrder operator-(const SecondOrder& x, double c) { return x + -c; }
  friend SecondOrder operator-(double c, const SecondOrder& x) { return -1. * x + c; }
  friend SecondOrder operator*(const SecondOrder& x, double c) {
    return {x.a * c, x.g * c, x.h * c};
  }
  friend SecondOrder operator*(double c, const SecondOrder& x) { return x * c; }
  friend SecondOrder operator/(const SecondOrder& x, double c) { return x * (1 / c); }
  SecondOrder operator-() const { return *this * -1.; }

 private:
  // f(x) from f, f' and f'' at x.
  SecondOrder apply(double f, double f1, double f2) const {
    SecondOrder y{f, f1 * g, f1 * h};
    y.h.noalias() += (f2 * g) * gradient().transpose();
    return y;
  }
};

}  // namespace sbeh::model
