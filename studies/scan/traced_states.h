// SSH's states by tracing: pears, and what the branches have behind their folds.
#pragma once

#include "axisym/diagram/traced_branches.h"
#include "axisym/stationary/ssh_branch.h"
#include "studies/scan/branch_points.h"

#include <array>
#include <vector>

namespace sbeh::studies {

/// SSH's branches of one material from the sphere down to V_r = 0.3, over their folds to where their necks close, with what leaves the
/// symmetric ones: all that `sbeh diagram` follows. With an area difference, whose branches may not reach the sphere, also from the
/// symmetric states at the reduced volumes that are asked for. Not for a bilayer couple.
class TracedStates {
 public:
  TracedStates(const model::Material& material, const axisym::Numerics& numerics);

  /// Traces the branches of the prolate and the oblate of this volume, and what leaves them, where none of these is known; only
  /// with an area difference.
  void begin_at(double reduced_volume);

  /// The states of this class at a reduced volume 0 < V_r < 1, on any of the branches: those with fewer negative directions (within
  /// axisymmetry) first, among these lower ones.
  std::vector<axisym::BranchState> at(axisym::Branch branch, double reduced_volume) const;

  /// The first of them as a point of SSH's; where there is none, the limit that the branch has passed, or where the branch is.
  PointOutcome point(const axisym::StationaryCase& of);

 private:
  bool is_same(const axisym::BranchState& a, const axisym::BranchState& b) const;

  model::Material material_;
  axisym::Numerics numerics_;
  axisym::Line line_;
  std::array<axisym::SshBranch, 2> symmetric_;  // prolate, oblate
  std::vector<axisym::TracedBranch> branches_;
};

}  // namespace sbeh::studies
