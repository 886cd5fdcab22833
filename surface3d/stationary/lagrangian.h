// The Lagrangian of a stationary state at a point, and its assembled derivatives.
//
//   𝓛 = U(X, β, H) + [(H ν, Λ) + (1, Div_C Λ)] + Σ (A − A₀) − P (V − V₀) + c (W₂ − W₂⁰) − A c²/(2π k_ad)
//
// with the energy of model/energy_density.h on the P3 surface and the mean curvature a P3 field H bound to it by the
// scheme's curvature equation (H1). The surface moves along its node normals, X + Σ d_i φ_i n_i, and Λ = Σ Λ_i φ_i n_i.
// The Gaussian energy: surface3d/gaussian_density.h.
#pragma once

#include "model/energy.h"
#include "model/energy_density.h"
#include "surface3d/gaussian_density.h"
#include "surface3d/surface.h"

#include <array>
#include <cmath>

namespace sbeh::surface3d {

/// With what Newton's method solves for besides.
struct StationaryState : State {
  Field H{};            // nodes, mean curvature
  Field Lambda{};       // nodes, multiplier of the curvature equation, about −κ(H − H₀)
  double tension = 0;   ///< Σ = −∂U/∂A
  double pressure = 0;  ///< P = ∂U/∂V
  double moment = 0;    ///< c = −∂U/∂W₂⁰, of an area difference
  double chemical_potential = 0;  ///< μ_β = ∂U/∂∫β dS of an order that is conserved
};
bool operator==(const StationaryState& a, const StationaryState& b);

/// What the energy reads at a point; g_ij = a_i·a_j, a_i and β_i derivatives by the triangle's coordinates.
enum EnergyData { at_g11, at_g12, at_g22, at_beta, at_beta_1, at_beta_2, at_H, energy_data };
template <class T>
using EnergyFields = std::array<T, energy_data>;
template <class T>
using Metric = std::array<T, 3>;  // g11, g12, g22

/// The area per dξ₁dξ₂.
template <class T>
T area_density(const Metric<T>& g) {
  using std::sqrt;
  return sqrt(g[0] * g[2] - g[1] * g[1]);
}
/// What the area of the lipids at full order, ∫n/n(2/3) dS, reads at a point, and that area per dξ₁dξ₂.
enum LipidData { lipids_g11, lipids_g12, lipids_g22, lipids_beta, lipid_data };
template <class T>
T lipid_density(const model::Material& material, const std::array<T, lipid_data>& q) {
  return area_density(Metric<T>{q[lipids_g11], q[lipids_g12], q[lipids_g22]})
       * material.packing(q[lipids_beta]);
}

/// U + Σ∫n/n(2/3) dS per dξ₁dξ₂, but for the Gaussian energy.
template <class T>
T tension_density(const model::Material& material, double tension, const EnergyFields<T>& q) {
  const Metric<T> g{q[at_g11], q[at_g12], q[at_g22]};
  const T dS = area_density(g);
  const T &beta_1 = q[at_beta_1], &beta_2 = q[at_beta_2];
  const T slope_squared =
      (g[2] * beta_1 * beta_1 - 2. * g[1] * beta_1 * beta_2 + g[0] * beta_2 * beta_2) / (dS * dS);
  const auto e = model::energy_density(material, q[at_beta], slope_squared, q[at_H], T(0.));
  return dS
       * (e.distortion + e.bending + e.thermotropic
          + model::tension_at(material, tension, q[at_beta]));
}

/// What (1, Div_C Λ) reads at a point.
enum DivergenceData {
  on_g11,
  on_g12,
  on_g22,
  a1_Lambda_1,
  a1_Lambda_2,
  a2_Lambda_1,
  a2_Lambda_2,
  divergence_data
};
/// (1, Div_C Λ) per dξ₁dξ₂. The rest of (H1), (H ν, Λ), is H (a1 × a2)·Λ.
template <class T>
T divergence_density(const std::array<T, divergence_data>& q) {
  const T &g11 = q[on_g11], &g12 = q[on_g12], &g22 = q[on_g22];
  return (g22 * q[a1_Lambda_1] - g12 * (q[a1_Lambda_2] + q[a2_Lambda_1]) + g11 * q[a2_Lambda_2])
       / area_density(Metric<T>{g11, g12, g22});
}

/// Unknowns per node, in the order of the global vector: node-wise d, Λ, H and, where it is free, β.
enum NodeUnknown { node_d, node_Lambda, node_H, node_beta, node_unknowns };

/// Which unknowns a model has, and how they couple.
struct StationaryLayout {
  StationaryLayout(const Triangulation& mesh, model::Model model);
  const Triangulation& mesh;
  bool free_order;
  int per_node;           ///< unknowns
  SparsePattern pattern;  ///< of the Hessian
  int size() const { return per_node * mesh.nodes; }
  int index(int node, NodeUnknown c) const { return per_node * node + c; }
  /// One unknown of all nodes, for `vector(layout.all(c))`.
  auto all(NodeUnknown c) const {
    return Eigen::seqN(Eigen::Index(c), Eigen::Index(mesh.nodes), Eigen::Index(per_node));
  }
};

/// What multiplies the constraints, in the order of their columns: tension and pressure, and where the material has them moment
/// and chemical potential. `of`: a StationaryState, or a change of one.
inline int multiplier_count(const model::Material& m) {
  return 2 + (m.area_difference.is_there() ? 1 : 0) + (m.conserves_order() ? 1 : 0);
}
template <class State>
Eigen::VectorXd multipliers(const model::Material& m, const State& of) {
  Eigen::VectorXd all(multiplier_count(m));
  all.head<2>() << of.tension, of.pressure;
  if (m.area_difference.is_there()) all[2] = of.moment;
  if (m.conserves_order()) all[all.size() - 1] = of.chemical_potential;
  return all;
}
template <class State>
void set_multipliers(const model::Material& m, const Eigen::Ref<const Eigen::VectorXd>& all,
                     State& of) {
  of.tension = all[0];
  of.pressure = all[1];
  of.moment = m.area_difference.is_there() ? all[2] : 0;
  of.chemical_potential = m.conserves_order() ? all[all.size() - 1] : 0;
}

/// Gradient of the Lagrangian, and gradients of A, V.
struct LagrangianGradient {
  Eigen::VectorXd gradient;
  /// By all unknowns: ∂A, −∂V, with an area difference ∂W₂ − c/(π k_ad) ∂A, and of a conserved order −∂∫(β − β̄)dS.
  Eigen::MatrixXd constraints;
  /// With an area difference what the multipliers have among themselves: 0, 0, −A/(π k_ad), 0; else empty.
  Eigen::VectorXd corner;
  double area =
      0;  ///< ∫n/n(2/3) dS of a material with lipid_density, then ∂A above is that of it, too
  double volume = 0, W2 = 0;
  double order = 0;  ///< ∫β dS
  double value = 0;  ///< of 𝓛 without its constants ΣA₀, PV₀ and cW₂⁰

  int multipliers() const { return int(constraints.cols()); }
  /// What the derivatives of 𝓛 by its multipliers miss, c = `moment` being that of the state.
  Eigen::VectorXd miss(const model::Material& material, const Target& target, double moment) const;
};
struct LagrangianDerivatives : LagrangianGradient {
  SparseMatrix hessian;
};

/// Assembles at a state whose surface moves along `normals` (3 x nodes). Of a model with a uniform order the
/// Gaussian energy, a constant, is left out. The gradient alone takes a fraction of the time.
void assemble(const model::Material& material, const StationaryLayout& layout,
              const StationaryState& state, const Nodes& normals, LagrangianGradient& out);
void assemble(const model::Material& material, const StationaryLayout& layout,
              const StationaryState& state, const Nodes& normals, LagrangianDerivatives& out);

/// U of the fields that the Lagrangian has.
model::Energy energy(const model::Material& material, const Triangulation& mesh,
                     const StationaryState& state);

}  // namespace sbeh::surface3d
