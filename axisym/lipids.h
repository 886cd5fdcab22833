// A membrane whose lipids have another area when they are ordered: n dS is what its pieces keep.
#pragma once

#include "axisym/curvature.h"
#include "model/material.h"
#include "model/numerics/area_volume.h"

namespace sbeh::axisym {

/// ∫ n/n(2/3) dS, the area that the lipids have at full order; ∫ dS where all orders have the same.
double lipid_area(const model::Material& material, const State& state);

/// correct_area_volume for that area.
bool correct_lipids_volume(const model::Material& material, const model::Target& target,
                           State& state);

/// β̇ = (β − β_old)/τ + slip·∇β of the material at a point, `slip` the velocity of the material relative to the mesh.
struct OrderRate {
  const Field& change;  ///< (β − β_old)/τ
  const Nodes& slip;    ///< 2 x nodes
  const Field& beta;    ///< new
  double at(int e, const ShapeValues& s, const CurvePoint& p) const;
};

/// (n'/n(2/3) β̇, q) for the P2 functions q of the pressure, with the old state's n: what (P1) has of the order.
Field lipid_load(const model::Material& material, const State& old, const OrderRate& rate);

}  // namespace sbeh::axisym
