// States whose modes are looked at.
#pragma once

#include "axisym/stationary/continuation.h"
#include "axisym/stationary/ssh_branch.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym::test {

/// The unit sphere at rest under a tension that counts the potential too.
inline StationaryState sphere_at_rest(const model::Material& material, model::Model model,
                                      double order, double tension, int elements) {
  StationaryState s = guess_from(
      material, model, {spheroid(1., 1., elements, 0.5), Field::Constant(3 * elements + 1, order)});
  s.H.setConstant(-2);
  s.tension = (tension - material.potential.value(order)) / material.packing(order);
  s.pressure = 2 * tension;
  return s;
}

inline std::optional<BranchState> ssh_oblate(double v, int elements) {
  Numerics numerics;
  numerics.elements = elements;
  SshBranch branch(Branch::oblate, model::Material{}, numerics);
  const auto found = branch.at(v);
  return found && found->arrival == Arrival::reached ? std::optional(found->state) : std::nullopt;
}

inline std::optional<BranchState> ordered_oblate(double v, double L, int elements) {
  using model::Model;
  Numerics numerics;
  numerics.elements = elements;
  const auto ssh = ssh_oblate(v, elements);
  const auto first = ssh ? solve_at({}, Model::SBEH, {v, 1e-4}, *ssh) : std::nullopt;
  if (!first) return {};
  const FollowResult there = follow({}, Model::SBEH, *first, {v, L}, numerics);
  return there.arrival == Arrival::reached ? std::optional(there.state) : std::nullopt;
}

}  // namespace sbeh::axisym::test
