#include "axisym/modes/eigenmodes.h"

#include "axisym/modes/rigid_motions.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/symmetry.h"

namespace sbeh::axisym {

std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, int count) {
  const model::BandMatrix mass = second.mass_of(m);
  ModeProblem problem{.m = m,
                      .node_size = node_unknowns,
                      .A = second.shifted(m, 0),
                      .M = mass,
                      .constraints = m == 0 ? second.constraints : Eigen::MatrixXd(),
                      .idle = {},
                      .square = mass,
                      .rigid = {},
                      .free = {},
                      .scale = second.stiffness};
  for (const RigidMotion& motion : rigid_motions(second.state, m, mass))
    problem.rigid.push_back(unknowns_of(motion));
  auto found = lowest(problem, is_symmetric(second.state.X), count);
  if (!found) return {};
  ModeSpectrum spectrum{.modes = {}, .rigid_residual = found->rigid_residual};
  for (AzimuthalMode& mode : found->modes)
    spectrum.modes.push_back({m, mode.parity, mode.lambda, std::move(mode.u), std::move(mode.b)});
  return spectrum;
}

}  // namespace sbeh::axisym
