#include "studies/evolution/run_cost.h"

#include <cmath>

namespace sbeh::studies {

namespace {

// As surface3d::CoupledSystem has them.
int unknowns_of(const RunInput& input, int nodes, int quadratic_nodes) {
  const model::Material m = model::effective(input.material, input.model);
  const model::AreaConstraint area = model::area_constraint(input.model);
  const auto scheme = surface3d::stable_scheme(m, area, input.numerics.scheme);
  const int mesh_motion = scheme == surface3d::Scheme::split ? 0 : 3 * nodes;
  if (area == model::AreaConstraint::global) return 2 * nodes + mesh_motion + 2;
  const bool free = m.friction_tangential == 0 && m.friction_normal == 0;
  return 4 * nodes + quadratic_nodes + mesh_motion + (free ? 7 : 1);
}

}  // namespace

RunCost cost_of(const RunInput& input, int triangles) {
  const int nodes = 9 * triangles / 2 + 2, quadratic_nodes = 2 * triangles + 2;
  const int unknowns = unknowns_of(input, nodes, quadratic_nodes);
  return {.unknowns = unknowns,
          .seconds_per_step = 5.1e-6 * unknowns * std::pow(unknowns / 6400., 0.15),
          .megabytes = 40 + 0.011 * unknowns,
          .frame_megabytes = 3.1e-4 * nodes};
}

}  // namespace sbeh::studies
