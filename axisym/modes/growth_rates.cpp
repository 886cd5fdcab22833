#include "axisym/modes/growth_rates.h"

#include "axisym/modes/eigenmodes.h"
#include "axisym/modes/mode_problem.h"

#include <algorithm>
#include <functional>

namespace sbeh::axisym {

namespace {

// The rigid motions, each with a displacement that it, and none of those before it, changes much.
FreeMotions free_motions(const LinearFlow& flow, int m, Parity parity, const NodeChain& square) {
  const std::vector<RigidMotion> motions = rigid_motions(flow.second, m, parity, square);
  FreeMotions free{.held = {}, .fields = unknowns_of(motions), .weights = {}, .squares = {}};
  if (motions.empty()) return free;
  if (!flow.material.frictionless()) {
    RigidDrag drag = drag_on(motions, flow.material, flow.second, m, parity);
    free.weights = std::move(drag.loads);
    free.squares = std::move(drag.squares);
  }
  Eigen::MatrixXd rest = free.fields;  // what is left of them where those before are taken off
  for (Eigen::Index k = 0; k < rest.cols(); ++k) {
    const Eigen::VectorXd weighted = square.times(rest.col(k));
    Eigen::Index node = 0;
    weighted(
        Eigen::seqN(Eigen::Index(node_d), motions.front().u.size(), Eigen::Index(node_unknowns)))
        .cwiseAbs()
        .maxCoeff(&node);
    free.held.push_back(flow_index(node, flow_d));
    const int held = index(node, node_d);
    for (Eigen::Index j = k + 1; j < rest.cols(); ++j)
      rest.col(j) -= rest(held, j) / rest(held, k) * rest.col(k);
  }
  return free;
}

// Of growing modes λ = −σ.
ModeProblem<flow_unknowns> problem_of(const LinearFlow& flow, int m, Parity parity) {
  const SecondVariation& second = flow.second;
  const model::Material& material = flow.material;
  const Nodes& X = second.state.X;
  // Where area is volume; not so where the order changes the area.
  const bool round = is_sphere(area(X), volume(X)) && !material.has_lipid_density();
  ModeProblem<flow_unknowns> problem{
      .m = m,
      .A = among_flow_unknowns(second.form(m, parity)),
      .M = flow.dissipation.form(second, m, parity),
      .constraints = {},
      .soft = {},
      .idle = {},
      .square = second.mass_of(m, parity),
      .rigid = {},
      .free = {},
      .scale = second.stiffness
             / (material.viscosity + material.friction_tangential + material.friction_normal)};
  hold_flow(second.sector, m, parity, 1, problem.A);
  problem.free = free_motions(flow, m, parity, problem.square);
  // Nothing resists what turns a sphere without tangential friction.
  if (m == 1 && parity != Parity::even && is_sphere(area(X), volume(X))
      && material.friction_tangential == 0)
    problem.free.held.push_back(flow_index(0, flow_v_t));
  const Eigen::MatrixXd kept = second.constraints_of(m, parity);
  if (kept.cols() > 0) {
    problem.idle = among_flow_unknowns(Eigen::VectorXd(kept.col(0)));  // a constant p
    // On a sphere volume is area, which p keeps.
    const Eigen::Index first = round ? 2 : 1, others = kept.cols() - first;
    if (others > 0) problem.constraints.resize(problem.idle.rows(), others);
    for (Eigen::Index k = 0; k < others; ++k)
      problem.constraints.col(k) = among_flow_unknowns(Eigen::VectorXd(kept.col(first + k)));
    problem.soft = second.moment_of(m, parity);
    if (round) problem.soft = {};
    if (problem.soft.b.size() > 0) problem.soft.b = among_flow_unknowns(problem.soft.b);
  }
  return problem;
}

}  // namespace

LinearFlow::LinearFlow(const SecondVariation& of, const model::Material& of_material,
                       model::Model of_model)
    : second(of),
      material(effective(of_material, of_model)),
      is_along_normals(area_constraint(of_model) == model::AreaConstraint::global) {
  if (!is_along_normals) dissipation = axisym::dissipation(material, second);
}

std::optional<std::vector<GrowthMode>> growth_rates(const LinearFlow& flow, int m, int count) {
  const Sector& sector = flow.second.sector;
  if (flow.material.order == model::OrderDynamics::diffusive) return {};
  std::vector<GrowthMode> growth;
  if (flow.is_along_normals) {
    // σ = −λ/γ_⊥ of the second variation.
    auto spectrum = lowest_modes(flow.second, m, count);
    if (!spectrum) return {};
    for (Eigenmode& mode : spectrum->modes)
      growth.push_back({m, mode.parity, -mode.eigenvalue / flow.material.friction_normal,
                        std::move(mode.u), std::move(mode.b)});
    return growth;
  }
  for (const Parity parity : sector.parities()) {
    const auto found = lowest(problem_of(flow, m, parity), count);
    if (!found) return {};
    for (const AzimuthalMode& mode : found->modes)
      growth.push_back(
          {m, parity, -mode.lambda, sector.whole(mode.u, parity), sector.whole(mode.b, parity)});
  }
  std::ranges::stable_sort(growth, std::greater{}, &GrowthMode::rate);
  return growth;
}

}  // namespace sbeh::axisym
