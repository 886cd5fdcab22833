#include "axisym/modes/growth_rates.h"

#include "axisym/modes/dissipation.h"
#include "axisym/modes/eigenmodes.h"
#include "axisym/modes/rigid_motions.h"
#include "axisym/stationary/symmetry.h"

namespace sbeh::axisym {

namespace {

Eigen::VectorXd flow_unknowns_of(const RigidMotion& motion) {
  const Eigen::Index nodes = motion.u.size();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(flow_unknowns * nodes);
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const bool is_pole = i == 0 || i + 1 == nodes;  // v_φ is tied to v_t there
    x[flow_index(i, flow_d)] = motion.u[i];
    x[flow_index(i, flow_beta)] = motion.b[i];
    x[flow_index(i, flow_v_t)] = motion.v_t[i];
    x[flow_index(i, flow_v_phi)] = is_pole ? 0 : motion.v_phi[i];
  }
  return x;
}

// What friction does against a rigid motion, which deforms nothing. Empty where there is none.
Eigen::VectorXd drag_on(const Eigen::VectorXd& motion, model::Material material,
                        const StationaryState& state, int m) {
  if (material.frictionless()) return {};
  material.viscosity = 0;
  Eigen::VectorXd drag = dissipation(material, model::Model::SSH, state, m).times(motion);
  drag(Eigen::seq(Eigen::Index(flow_p), Eigen::last, Eigen::Index(flow_unknowns))).setZero();
  return drag;
}

// The rigid motions, each with a displacement that it, and none of those before it, changes much.
std::vector<FreeMotion> free_motions(const SecondVariation& second, const model::Material& material,
                                     int m, const model::BandMatrix& square) {
  const std::vector<RigidMotion> motions = rigid_motions(second.state, m, square);
  std::vector<Eigen::VectorXd> rest;  // what is left of them where those before are taken off
  for (const RigidMotion& motion : motions) rest.push_back(unknowns_of(motion));
  std::vector<FreeMotion> free;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Eigen::VectorXd weighted = square.times(rest[k]);
    Eigen::Index node = 0;
    weighted(Eigen::seqN(Eigen::Index(node_d), motions[k].u.size(), Eigen::Index(node_unknowns)))
        .cwiseAbs()
        .maxCoeff(&node);
    const Eigen::VectorXd x = flow_unknowns_of(motions[k]);
    free.push_back({x, drag_on(x, material, second.state, m), flow_index(node, flow_d)});
    const int held = index(node, node_d);
    for (std::size_t j = k + 1; j < motions.size(); ++j)
      rest[j] -= rest[j][held] / rest[k][held] * rest[k];
  }
  return free;
}

// Of growing modes λ = −σ.
ModeProblem problem_of(const SecondVariation& second, const model::Material& material,
                       model::Model model, int m) {
  const StationaryState& state = second.state;
  const int nodes = int(state.beta.size());
  const bool round = is_sphere(area(state.X), volume(state.X));
  ModeProblem problem{
      .m = m,
      .node_size = flow_unknowns,
      .A = among_flow_unknowns(second.shifted(m, 0)),
      .M = dissipation(material, model, state, m),
      .constraints = {},
      .idle = {},
      .square = second.mass_of(m),
      .rigid = {},
      .free = {},
      .scale = second.stiffness
             / (material.viscosity + material.friction_tangential + material.friction_normal)};
  hold_flow(nodes, m, 1, problem.A);
  problem.free = free_motions(second, material, m, problem.square);
  // Nothing resists what turns a sphere without tangential friction.
  if (m == 1 && round && material.friction_tangential == 0)
    problem.free.push_back({Eigen::VectorXd::Zero(problem.A.size()), {}, flow_index(0, flow_v_t)});
  if (m == 0) {
    const Eigen::MatrixXd& rows = second.constraints;
    problem.idle = among_flow_unknowns(Eigen::VectorXd(rows.col(0)));  // a constant p
    // On a sphere volume is area, which p keeps.
    if (!round) problem.constraints = among_flow_unknowns(Eigen::VectorXd(rows.col(1)));
  }
  return problem;
}

}  // namespace

std::optional<std::vector<GrowthMode>> growth_rates(const SecondVariation& second,
                                                    const model::Material& material,
                                                    model::Model model, int m, int count) {
  const model::Material flow = effective(material, model);
  std::vector<GrowthMode> growth;
  if (area_constraint(model) == model::AreaConstraint::global) {
    // Velocities along the normals alone: σ = −λ/γ_⊥ of the second variation.
    auto spectrum = lowest_modes(second, m, count);
    if (!spectrum) return {};
    for (Eigenmode& mode : spectrum->modes)
      growth.push_back({m, mode.parity, -mode.eigenvalue / flow.friction_normal, std::move(mode.u),
                        std::move(mode.b)});
    return growth;
  }
  auto found = lowest(problem_of(second, flow, model, m), is_symmetric(second.state.X), count);
  if (!found) return {};
  for (AzimuthalMode& mode : found->modes)
    growth.push_back({m, mode.parity, -mode.lambda, std::move(mode.u), std::move(mode.b)});
  return growth;
}

}  // namespace sbeh::axisym
