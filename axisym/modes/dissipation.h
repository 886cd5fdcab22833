// What small motions of a stationary state dissipate, by fields that go with cos mφ and sin mφ.
#pragma once

#include "axisym/modes/rigid_motions.h"

namespace sbeh::axisym {

/// Of a node: those of NewtonSystem first, then the velocity along the meridian over that of the displacement's
/// rate, the velocity along e_φ, and the pressure, which has a value at the joints and in the middle of elements.
enum FlowUnknown {
  flow_d,
  flow_Lambda,
  flow_H,
  flow_beta,
  flow_v_t,
  flow_v_phi,
  flow_p,
  flow_unknowns
};
static_assert(int(flow_d) == int(node_d) && int(flow_beta) == int(node_beta)
              && int(flow_v_t) == int(node_unknowns));
using FlowChain = model::ChainMatrix<flow_unknowns>;

/// Place of a node's unknown in the global vector.
inline int flow_index(Eigen::Index node, FlowUnknown c) { return flow_unknowns * int(node) + c; }

/// A matrix or a vector of the unknowns of SecondVariation among those of the flow.
FlowChain among_flow_unknowns(const NodeChain& matrix);
Eigen::VectorXd among_flow_unknowns(const Eigen::VectorXd& x);

/// The quadratic form of  V = (Σ ḋ_i φ_i n_i + v_t t + …) cos mφ + v_φ e_φ sin mφ,  of ḃ and p
///
///   ∫ [ γ_∥ (V_t² + V_φ²) + γ_⊥ V_n² + (η/2)|σ(V)|² + m_β (ḃ + v_t ∂_sβ)² + 2 p Div_C V ] r ds
///
/// and (γ_∥ + γ_⊥)(Div_C V)², see model/equations.md: powers_0 + m powers_1 + m² powers_2. Of a material with lipid_density Div_C V less
/// (a'/a)β̇ stands for Div_C V where it is 0, p is n/n(2/3) times its unknown, and m_β is Material::order_drag(β).
struct FlowDissipation {
  std::array<FlowChain, 3> powers;

  /// What is not free is 0 in it; for m = 0 that is v_φ too, which nothing moves.
  FlowChain form(const SecondVariation& second, int m, Parity parity) const;
};
FlowDissipation dissipation(const model::Material& material, const SecondVariation& second);

/// What friction does against rigid motions, which deform nothing.
struct RigidDrag {
  Eigen::MatrixXd loads;    ///< of each, in columns
  Eigen::MatrixXd squares;  ///< what they dissipate, alone and together
};
RigidDrag drag_on(const std::vector<RigidMotion>& motions, const model::Material& material,
                  const SecondVariation& second, int m, Parity parity);

/// What is not free of the flow, besides what SecondVariation holds: 0 in the matrix, and `diagonal`.
void hold_flow(const Sector& sector, int m, Parity parity, double diagonal, FlowChain& matrix);

}  // namespace sbeh::axisym
