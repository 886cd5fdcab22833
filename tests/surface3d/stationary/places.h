// Axisymmetric states as starts of those in 3D.
#pragma once

#include "axisym/stationary/ssh_branch.h"
#include "meshing/revolution.h"
#include "tests/surface3d/cases.h"

#include <memory>

namespace sbeh::surface3d::test {

using axisym::Branch;

struct Place {
  Model model;
  Branch branch;
  double reduced_volume, L;
  Target target() const { return {4 * pi, reduced_volume * 4 * pi / 3}; }
};
inline const Place ordered_oblate{Model::SBEH, Branch::oblate, 0.8, 0.05};

inline axisym::BranchState with_axis(const Place& place) {
  axisym::Numerics numerics;
  numerics.elements = 96;
  axisym::SshBranch branch(place.branch, {}, numerics);
  const double v = place.reduced_volume;
  const auto ssh = branch.at(v);
  EXPECT_TRUE(ssh && ssh->arrival == axisym::Arrival::reached);
  if (place.model == Model::SSH)
    return *axisym::solve_at({}, place.model, {v, place.L}, ssh->state);
  const auto first = axisym::solve_at({}, place.model, {v, 1e-4}, ssh->state);
  const auto there = axisym::follow({}, place.model, *first, {v, place.L}, numerics);
  EXPECT_EQ(there.arrival, axisym::Arrival::reached);
  return there.state;
}

inline Surface revolved(const axisym::State& state, int triangles) {
  const meshing::RevolvedMesh made = meshing::revolved(state, {.triangles = triangles});
  return {std::make_shared<const Triangulation>(made.mesh), {made.mesh.nodes, made.beta}};
}

}  // namespace sbeh::surface3d::test
