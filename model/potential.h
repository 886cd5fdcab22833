// The thermotropic potential u(β): energy per area that the lipids' order costs by itself.
#pragma once

#include <vector>

namespace sbeh::model {

/// u(β) = Σ_k c_k β^k, any polynomial. Dimensionless energy per area; β is the scalar order.
class Potential {
 public:
  /// The form of Landau and de Gennes, u(β) = (β²/8)(12a + 4bβ + 9cβ²).
  /// The default arguments are the paper's: minimum u(2/3) = −1, critical point at 0.
  static Potential landau_de_gennes(double a = 0, double b = -27, double c = 13.5);

  /// coefficients[k] multiplies β^k. Throws std::invalid_argument if one is not finite.
  explicit Potential(std::vector<double> coefficients);
  Potential() : Potential(landau_de_gennes()) {}

  const std::vector<double>& coefficients() const { return coefficients_; }

  /// u(β)
  template <class T>
  T value(const T& beta) const {
    T sum(0);
    for (std::size_t k = coefficients_.size(); k-- > 0;) sum = sum * beta + coefficients_[k];
    return sum;
  }

  /// u'(β)
  template <class T>
  T slope(const T& beta) const {
    return secant(beta) * beta + slope_at_zero();
  }

  /// u''(β)
  double curvature(double beta) const {
    double sum = 0;
    for (std::size_t k = coefficients_.size(); k-- > 2;)
      sum = sum * beta + double(k * (k - 1)) * coefficients_[k];
    return sum;
  }

  /// (u'(β) − u'(0))/β, the factor of βⁿ in the semi-implicit order step.
  /// For the quartic (3/2)(2a + bβ + 3cβ²).
  template <class T>
  T secant(const T& beta) const {
    T sum(0);
    for (std::size_t k = coefficients_.size(); k-- > 2;)
      sum = sum * beta + double(k) * coefficients_[k];
    return sum;
  }

  /// u'(0): what the order step keeps explicit; 0 for the Landau–de Gennes form.
  double slope_at_zero() const { return coefficients_.size() > 1 ? coefficients_[1] : 0; }

  bool operator==(const Potential&) const = default;

 private:
  std::vector<double> coefficients_;
};

}  // namespace sbeh::model
