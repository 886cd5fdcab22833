// The order equation (B1)–(B9) of one step, with the velocity and the mesh motion known.
#pragma once

#include "model/material.h"
#include "surface3d/curvature.h"

#include <optional>

namespace sbeh::surface3d {

/// What the order step reads besides the surface and the coefficients, which are those of `at`.
struct OrderStepData {
  const Curvature& curvature;
  const Nodes& slip;  ///< 3 x nodes: of the material relative to the mesh, V − Y/τ
  const Field& from;  ///< nodes: β at the time from which the step is counted
  const Nodes& next;  ///< 3 x nodes of the surface then
  double tau;
  std::optional<double> total{};  ///< ∫β dS there; of a conserved order, as it is without
  const Field* p = nullptr;       ///< P2 nodes: of StepFields, for a material with lipid_density
};

/// β of the next time, and where the order diffuses ∫ M_β |∇μ_β|² dS. Empty when the linear solve fails.
struct OrderStepResult {
  Field beta{};
  double diffusion = 0;
};
OrderStepResult order_step(const Triangulation& mesh, const model::Material& material,
                           const State& at, const OrderStepData& step);

/// ∫β dS
double total_order(const Triangulation& mesh, const State& state);

/// h = δU/δβ, nodes: (h, ψ) = (B2) + … + (B5). Empty when the linear solve fails.
Field order_force(const Triangulation& mesh, const model::Material& material, const State& at,
                  const Curvature& curvature);

}  // namespace sbeh::surface3d
