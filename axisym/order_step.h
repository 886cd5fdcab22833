// The order equation (B1)–(B9) of one step, with the velocity and the mesh motion known.
#pragma once

#include "axisym/curve.h"
#include "model/material.h"
#include "model/numerics/band_matrix.h"

#include <optional>

namespace sbeh::axisym {

/// What the order step reads besides the old state.
struct OrderStepData {
  const Field& H;     ///< mean curvature of the old curve
  const Nodes& slip;  ///< velocity of the material relative to the mesh, V − Y/τ
  const Nodes& next;  ///< the new curve
  const Field& p;     ///< of StepFields
  double tau;
  std::optional<double> total;  ///< ∫β dS there; of a conserved order, as it is without
};

/// Keeps its memory.
class OrderStep {
 public:
  OrderStep(const model::Material& material, int elements);

  /// β of the next time. Empty when the matrix is singular.
  Field solve(const State& old, const OrderStepData& step);
  /// ∫ M_β |∇μ_β|² dS of the last one, where the order diffuses.
  double diffusion() const { return diffusion_; }

 private:
  Field relaxed(const State& old, const OrderStepData& step);
  Field diffused(const State& old, const OrderStepData& step);

  model::Material material_;
  bool diffuses_;
  model::BandMatrix matrix_;
  double diffusion_ = 0;
};

}  // namespace sbeh::axisym
