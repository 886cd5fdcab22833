// Traces of SSH's branches which the tests of diagrams share.
#pragma once

#include "axisym/diagram/trace.h"
#include "axisym/stationary/classical_branches.h"
#include "axisym/stationary/symmetry.h"
#include "tests/axisym/cases.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace sbeh::axisym::test {

/// κ = 1, no potential.
inline Material bare(double H0, const model::AreaDifference& ad = {}) {
  Material m = classical_material();
  m.spontaneous_curvature = H0;
  m.area_difference = ad;
  return m;
}

/// V_r from 0.98 down to `to`.
inline Line down_to(double to, const Material& m, bool symmetric) {
  Line line{.material = m, .model = Model::SSH, .from = {0.98, m.L1}, .to = {to, m.L1}};
  line.symmetric = symmetric;
  return line;
}

/// At the beginning of the line, from a spheroid.
inline PathState round(const Line& line, bool prolate, int elements) {
  const State start{spheroid(line.from.reduced_volume, prolate, elements, Numerics{}.grading),
                    Field::Constant(3 * elements + 1, model::full_order)};
  const auto state = solve_at(line.material, line.model, line.from,
                              guess_from(line.material, line.model, start), {.symmetric = true});
  EXPECT_TRUE(state);
  const auto path = with_tangent(line, {symmetric_part(*state), 0});
  EXPECT_TRUE(path);
  return *path;
}

inline double volume_of(const Line& line, const SpecialState& s) {
  return line.at(s.state.mu).reduced_volume;
}

inline std::vector<SpecialState> of_kind(const Trace& trace, Special kind) {
  std::vector<SpecialState> found;
  std::ranges::copy_if(trace.specials, std::back_inserter(found),
                       [&](const SpecialState& s) { return s.kind == kind; });
  return found;
}

inline double F_of(const Line& line, const StationaryState& s, double mu) {
  const Material m = line.material_at(mu);
  return energy(m, s, s.H).total() - 4 * pi * m.kappa_gauss(model::full_order);
}

}  // namespace sbeh::axisym::test
