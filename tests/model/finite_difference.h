// Derivatives by extrapolated central differences.
#pragma once

#include <array>

namespace sbeh::model::test {

/// f'(0) of a smooth f with values in a vector space, by Neville extrapolation of the central
/// differences with steps h, h/2, h/4, h/8: truncation error O(h⁸), and rounding of
/// 2⁻⁵²|f|/(h/8) times the sum of the weights, about 2.
template <class Function>
auto derivative_at_zero(const Function& f, double h) {
  constexpr int levels = 4;
  using Value = decltype(f(h));
  std::array<Value, levels> column;
  for (int i = 0; i < levels; ++i, h /= 2) column[i] = (f(h) - f(-h)) / (2 * h);
  double factor = 1;
  for (int order = 1; order < levels; ++order) {
    factor *= 4;
    for (int i = 0; i + order < levels; ++i)
      column[i] = (factor * column[i + 1] - column[i]) / (factor - 1);
  }
  return column[0];
}

}  // namespace sbeh::model::test
