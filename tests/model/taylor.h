// Taylor series in two variables to third order: exact derivatives of polynomials of known series.
#pragma once

#include <ceres/jet.h>

#include <array>

namespace sbeh::model::test {

/// Σ c_ij u^i v^j over i + j <= 3.
class Taylor {
 public:
  Taylor(double constant = 0) { c_[0][0] = constant; }  // NOLINT: constants mix freely with series
  /// A function of u alone, and one of v alone, from its derivatives 0 … 3.
  static Taylor of_u(const std::array<double, 4>& derivatives) {
    Taylor x;
    for (int i = 0; i < 4; ++i) x.c_[i][0] = derivatives[i] / factorial(i);
    return x;
  }
  static Taylor of_v(const std::array<double, 4>& derivatives) {
    Taylor x;
    for (int j = 0; j < 4; ++j) x.c_[0][j] = derivatives[j] / factorial(j);
    return x;
  }

  /// ∂_u^i ∂_v^j with its own first derivatives; i + j <= 2.
  ceres::Jet<double, 2> derivative(int i, int j) const {
    const auto at_zero = [this](int k, int l) { return factorial(k) * factorial(l) * c_[k][l]; };
    return {at_zero(i, j), Eigen::Vector2d(at_zero(i + 1, j), at_zero(i, j + 1))};
  }

  Taylor& operator+=(const Taylor& y) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; i + j < 4; ++j) c_[i][j] += y.c_[i][j];
    return *this;
  }
  friend Taylor operator+(Taylor x, const Taylor& y) { return x += y; }
  friend Taylor operator-(const Taylor& x, const Taylor& y) { return x + -1 * y; }
  friend Taylor operator*(const Taylor& x, const Taylor& y) {
    Taylor p;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; i + j < 4; ++j)
        for (int k = 0; i + j + k < 4; ++k)
          for (int l = 0; i + j + k + l < 4; ++l) p.c_[i + k][j + l] += x.c_[i][j] * y.c_[k][l];
    return p;
  }

 private:
  static constexpr double factorial(int n) {
    constexpr double table[4] = {1, 1, 2, 6};
    return table[n];
  }

  double c_[4][4] = {};
};

}  // namespace sbeh::model::test
