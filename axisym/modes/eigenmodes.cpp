#include "axisym/modes/eigenmodes.h"

#include "axisym/modes/mode_problem.h"
#include "axisym/modes/rigid_motions.h"

#include <algorithm>

namespace sbeh::axisym {

namespace {

// Of each parity what `find` gives.
template <class Find>
std::optional<ModeSpectrum> of_all_parities(const Sector& sector, Find&& find) {
  ModeSpectrum all;
  for (const Parity parity : sector.parities()) {
    std::optional<ModeSpectrum> found = find(parity);
    if (!found) return {};
    std::ranges::move(found->modes, std::back_inserter(all.modes));
    all.rigid_residual = std::max(all.rigid_residual, found->rigid_residual);
  }
  std::ranges::stable_sort(all.modes, {}, &Eigenmode::eigenvalue);
  return all;
}

}  // namespace

std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, Parity parity,
                                         int count) {
  const NodeChain mass = second.mass_of(m, parity);
  ModeProblem<node_unknowns> problem{.m = m,
                                     .A = second.form(m, parity),
                                     .M = mass,
                                     .constraints = second.constraints_of(m, parity),
                                     .soft = second.moment_of(m, parity),
                                     .idle = {},
                                     .square = mass,
                                     .rigid = unknowns_of(rigid_motions(second, m, parity, mass)),
                                     .free = {},
                                     .scale = second.stiffness};
  auto found = lowest(problem, count);
  if (!found) return {};
  ModeSpectrum spectrum{.modes = {}, .rigid_residual = found->rigid_residual};
  for (const AzimuthalMode& mode : found->modes)
    spectrum.modes.push_back({m, parity, mode.lambda, second.sector.whole(mode.u, parity),
                              second.sector.whole(mode.b, parity)});
  return spectrum;
}

std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, int count) {
  return of_all_parities(second.sector,
                         [&](Parity parity) { return lowest_modes(second, m, parity, count); });
}

std::optional<ModeSpectrum> lowest_and_negative_modes(const SecondVariation& second, int m,
                                                      int count) {
  return of_all_parities(second.sector, [&](Parity parity) {
    return lowest_and_negative_modes(second, m, parity, count);
  });
}

std::optional<ModeSpectrum> lowest_and_negative_modes(const SecondVariation& second, int m,
                                                      Parity parity, int count) {
  for (int several = count; several <= 64 * count; several *= 2) {
    auto found = lowest_modes(second, m, parity, several);
    if (!found || found->modes.empty()) return {};
    if (found->modes.back().eigenvalue >= 0 || int(found->modes.size()) < several) return found;
  }
  return {};
}

}  // namespace sbeh::axisym
