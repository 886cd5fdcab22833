// Spectral curves and minima which the tests of them share.
#pragma once

#include "axisym/spectral/classical.h"
#include "axisym/spectral/minimiser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::axisym::test {

using namespace spectral;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using model::Material;
using std::numbers::pi;

inline constexpr Branch branches[] = {Branch::oblate, Branch::prolate, Branch::stomatocyte};

// F/κ of the unit sphere is 8π: everything is compared in units of that, where rounding is 1e-15.
inline constexpr double rounding = 1e-12;

inline ClassicalShape classical(Branch branch, double reduced_volume) {
  const auto shape = minimise_classical(branch, reduced_volume);
  EXPECT_TRUE(shape) << name(branch) << " at " << reduced_volume;
  return shape.value();
}
inline EnergyMinimum ordered(const Material& material, double reduced_volume,
                             Branch start = Branch::oblate) {
  const auto minimum = minimise_energy(material, model::Model::SBEH, reduced_volume, start);
  EXPECT_TRUE(minimum) << "L1 = " << material.L1 << " at " << reduced_volume;
  return minimum.value();
}

// Central difference of order 4.
template <class F>
auto difference(const F& f, double h) {
  using Value = decltype(f(h));
  const Value near = (f(h) - f(-h)) / (2 * h), far = (f(2 * h) - f(-2 * h)) / (4 * h);
  return Value((4 * near - far) / 3);
}

}  // namespace sbeh::axisym::test
