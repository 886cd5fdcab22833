// SSH's states by tracing: pears, and what the branches have behind their folds.
#pragma once

#include "axisym/diagram/traced_branches.h"
#include "studies/scan/branch_points.h"

#include <vector>

namespace sbeh::studies {

/// SSH's branches of one material from the sphere down to V_r = 0.3, over their folds to where their necks close, with what leaves the
/// symmetric ones: all that `sbeh diagram` follows. Not for a bilayer couple, whose branches do not begin at the sphere.
class TracedStates {
 public:
  TracedStates(const model::Material& material, const axisym::Numerics& numerics);

  /// The states of this class at a reduced volume 0 < V_r < 1, on any of the branches: those with fewer negative directions (within
  /// axisymmetry) first, among these lower ones.
  std::vector<axisym::BranchState> at(axisym::Branch branch, double reduced_volume) const;

  /// The first of them as a point of SSH's; where there is none, the limit that the branch has passed, or where the branch is.
  PointOutcome point(const axisym::StationaryCase& of) const;

 private:
  model::Material material_;
  axisym::Numerics numerics_;
  std::vector<axisym::TracedBranch> branches_;
};

}  // namespace sbeh::studies
