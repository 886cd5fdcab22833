// The Lagrangian of a stationary state at a point, and its assembled derivatives.
#pragma once

#include "axisym/stationary/sector.h"
#include "axisym/stationary/stationary.h"
#include "model/energy_density.h"
#include "model/numerics/band_matrix.h"

#include <array>
#include <cmath>
#include <numbers>

namespace sbeh::axisym {

/// What the Lagrangian reads at a point; ' = derivative by the element's coordinate. It is linear in
/// the last four, the multiplier Λ.
enum LagrangianData {
  at_r,
  at_dr,
  at_dz,
  at_H,
  at_beta,
  at_dbeta,
  at_Lambda_r,
  at_Lambda_z,
  at_dLambda_r,
  at_dLambda_z,
  lagrangian_data
};
inline constexpr int nonlinear_data = at_Lambda_r;
template <class T>
using PointFields = std::array<T, nonlinear_data>;

/// The densities of area and volume per element coordinate, 2π included; of the area that the lipids have at full order.
template <class T>
T area_density(const model::Material& material, const PointFields<T>& q) {
  using std::sqrt;
  const T dS = 2 * std::numbers::pi * q[at_r] * sqrt(q[at_dr] * q[at_dr] + q[at_dz] * q[at_dz]);
  return material.has_lipid_density() ? T(dS * material.packing(q[at_beta])) : dS;
}
template <class T>
T volume_density(const PointFields<T>& q) {
  return -std::numbers::pi * q[at_r] * q[at_r] * q[at_dz];
}

/// 𝓛 = energy + Λ_r c_0 + Λ_z c_1 + Λ_r' c_2 + Λ_z' c_3 per element coordinate.
template <class T>
struct LagrangianDensity {
  T energy;                    ///< U + Σ∫n/n(2/3) dS − PV
  std::array<T, 4> curvature;  ///< c: the curvature equation (H1) tested with Λ
};
template <class T>
LagrangianDensity<T> lagrangian_density(const model::Material& material, double tension,
                                        double pressure, const PointFields<T>& q) {
  using std::sqrt;
  constexpr double two_pi = 2 * std::numbers::pi;
  const T& r = q[at_r];
  const T stretch_squared = q[at_dr] * q[at_dr] + q[at_dz] * q[at_dz];
  const T stretch = sqrt(stretch_squared);
  const T dS = two_pi * r * stretch;
  const T B_phi = q[at_dz] / (r * stretch);
  const auto energy =
      model::energy_density(material, q[at_beta], T(q[at_dbeta] * q[at_dbeta] / stretch_squared),
                            q[at_H], T(B_phi * (q[at_H] - B_phi)));
  const T Hr = two_pi * r * q[at_H], weight = two_pi * r / stretch;
  return {
      .energy = dS * (energy.total() + model::tension_at(material, tension, q[at_beta]))
              - pressure * volume_density(q),
      .curvature = {two_pi * stretch - Hr * q[at_dz],  // (H ν_r + 1/r, Λ_r)
                    Hr * q[at_dr],                     // (H ν_z, Λ_z)
                    weight * q[at_dr],                 // (t_r, ∂_s Λ_r)
                    weight * q[at_dz]},                // (t_z, ∂_s Λ_z)
  };
}

/// Unknowns per node, in the order of the global vector: node-wise d, Λ, H, β.
enum NodeUnknown { node_d, node_Lambda, node_H, node_beta, node_unknowns };

/// Gradient and Hessian of the Lagrangian, and gradients of A, V, by the unknowns of a sector's nodes: of a half, by
/// symmetric changes of the whole.
struct LagrangianDerivatives {
  Sector sector;
  model::BandMatrix hessian;    // 4 nodes x 4 nodes
  Eigen::VectorXd gradient;     // 4 nodes
  Eigen::MatrixXd constraints;  // 4 nodes x 2: ∂A, −∂V
  Eigen::VectorXd of_W2;     // 4 nodes: ∂(W₂ − c A/(π k_ad)); 0 without an area difference
  Eigen::VectorXd of_order;  // 4 nodes: −∂∫(β − β̄)dS; 0 where the order is not conserved
  double area = 0;           ///< ∫n/n(2/3) dS of a material with lipid_density
  double volume = 0, W2 = 0;
  double order = 0;  ///< ∫β dS
  explicit LagrangianDerivatives(const Sector& sector);
};

/// Assembles at a state whose curve moves along `normals` (2 x nodes of the whole).
void assemble(const model::Material& material, const StationaryState& state, const Nodes& normals,
              LagrangianDerivatives& out);

/// Without the Hessian, at a third of the cost.
struct LagrangianGradient {
  Eigen::VectorXd gradient;     // 4 nodes
  Eigen::MatrixXd constraints;  // 4 nodes x 2: ∂A, −∂V
  Eigen::VectorXd of_W2;        // 4 nodes
  Eigen::VectorXd of_order;     // 4 nodes
  double area = 0, volume = 0, W2 = 0, order = 0;
};
LagrangianGradient gradient_at(const model::Material& material, const StationaryState& state,
                               const Nodes& normals, const Sector& sector);

/// Of the model, along the node normals, over the whole state.
LagrangianDerivatives lagrangian_at(const model::Material& material, model::Model model,
                                    const StationaryState& state);

/// The gradient with one material less that with another; 4 nodes.
Eigen::VectorXd gradient_difference(const model::Material& a, const model::Material& b,
                                    const StationaryState& state, const Nodes& normals);

}  // namespace sbeh::axisym
