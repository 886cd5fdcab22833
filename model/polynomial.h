// What depends on the order as a polynomial.
#pragma once

#include <cstddef>
#include <vector>

namespace sbeh::model {

/// p(β) = Σ_k c_k β^k; 0 without coefficients.
class Polynomial {
 public:
  Polynomial() = default;
  /// coefficients[k] multiplies β^k. Throws std::invalid_argument if one is not finite.
  explicit Polynomial(std::vector<double> coefficients);

  const std::vector<double>& coefficients() const { return coefficients_; }
  bool empty() const { return coefficients_.empty(); }
  /// Whether it is 0 for all β.
  bool vanishes() const;

  Polynomial times(double factor) const;
  Polynomial plus(double constant) const;

  /// p(β)
  template <class T>
  T value(const T& beta) const {
    T sum(0);
    for (std::size_t k = coefficients_.size(); k-- > 0;) sum = sum * beta + coefficients_[k];
    return sum;
  }

  /// p'(β)
  template <class T>
  T slope(const T& beta) const {
    return secant(beta) * beta + slope_at_zero();
  }

  /// p''(β)
  double curvature(double beta) const {
    double sum = 0;
    for (std::size_t k = coefficients_.size(); k-- > 2;)
      sum = sum * beta + double(k * (k - 1)) * coefficients_[k];
    return sum;
  }

  /// (p'(β) − p'(0))/β, the factor of βⁿ in the semi-implicit order step.
  template <class T>
  T secant(const T& beta) const {
    T sum(0);
    for (std::size_t k = coefficients_.size(); k-- > 2;)
      sum = sum * beta + double(k) * coefficients_[k];
    return sum;
  }

  /// p'(0): what the order step keeps explicit.
  double slope_at_zero() const { return coefficients_.size() > 1 ? coefficients_[1] : 0; }

  bool operator==(const Polynomial&) const = default;

 private:
  std::vector<double> coefficients_;
};

}  // namespace sbeh::model
