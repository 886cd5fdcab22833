// The parts of the energy and the labelled stresses that belong to each.
#pragma once

#include "model/energy_density.h"
#include "model/terms.h"

#include <vector>

namespace sbeh::model::test {

using Density = EnergyDensity<double>;
/// One number per part of the energy, in the order of the table.
using Parts = Eigen::Vector4d;

struct Term {
  const char* label;
  Gradient<double> (*stress)(const Material&, const ElasticPoint<double, double>&);
};

// A part of the energy and what it puts into the momentum equation: with e its density,
//   −d/dε ∫ e dS = (T, ∇_C W) − (e, Div_C W),
// of which the terms carry T, and e is taken up by the pressure.
struct Part {
  const char* label;
  double Density::*density;
  bool isotropic;  ///< false for the Gaussian energy, whose e cancels against H B − B² = K P
  std::vector<Term> terms;
};

inline const std::vector<Part>& parts() {
  static const std::vector<Part> table{
      {"E1", &Density::distortion, true, {{"V5", distortion_stress<double, double>}}},
      {"E2",
       &Density::bending,
       true,
       {{"V6", bending_stress<double, double>},
        {"V7", curvature_gradient_stress<double, double>},
        {"V8", stiffness_gradient_stress<double, double>}}},
      {"E3",
       &Density::gaussian,
       false,
       {{"V9", gaussian_trace_stress<double, double>},
        {"V10", gaussian_shape_stress<double, double>}}},
      {"E4", &Density::thermotropic, true, {}},
  };
  return table;
}

inline double contract(const Gradient<double>& a, const Gradient<double>& b) {
  return a.cwiseProduct(b).sum();
}

}  // namespace sbeh::model::test
