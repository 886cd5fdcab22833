// Materials that tell the order terms (B2) … (B5) apart.
#pragma once

#include "tests/model/general_material.h"

#include <string>
#include <vector>

namespace sbeh::model::test {

/// A material with one part of the energy that depends on the order; the last one has all.
struct OrderCase {
  std::string label;
  Material material;
};

inline Material elastic(double L1, double L2, double L3) {
  Material m = general_material();
  m.L1 = L1;
  m.L2 = L2;
  m.L3 = L3;
  return m;
}
inline Material elastic_alone(double L1, double L2, double L3) {
  Material m = elastic(L1, L2, L3);
  m.potential = Potential(std::vector<double>{});
  return m;
}

// l₁ = (6L₁ + L₂ + L₃)/4, κ ~ 2L₁ + L₂ + L₃, κ_G ~ −(2L₁ + L₃): all vanish but one.
inline const std::vector<OrderCase>& order_cases() {
  static const std::vector<OrderCase> table{
      {"B2", elastic_alone(0.05, 0, -0.1)},  {"B3", elastic_alone(0.05, -0.2, -0.1)},
      {"B4", elastic_alone(0, -0.05, 0.05)}, {"B5", elastic(0, 0, 0)},
      {"all", general_material()},           {"all, given", given_material()},
  };
  return table;
}

}  // namespace sbeh::model::test
