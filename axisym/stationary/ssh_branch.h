// SSH's states of a branch at any reduced volume, whatever others are asked for.
#pragma once

#include "axisym/stationary/branch_entry.h"

#include <map>
#include <optional>

namespace sbeh::axisym {

/// A branch of SSH at one material. Without spontaneous curvature, H₀ or that of f, and area difference it is followed from its
/// entry over waypoints, multiples of 0.05 in V_r; these are then carried on to H₀ and W₂⁰ at fixed V_r, and from both neighbours
/// along V_r at fixed material, since neither way reaches all: where several states of the branch's class are found,
/// that with the fewest negative directions counts, of these the lowest. Stomatocytes whose necks H₀ closes up to V_r = 0.65
/// are reached where it leaves them open. Symmetric branches stay symmetric.
/// The shapes depend on H₀ − f/κ, k_ad/κ and W₂⁰ alone of the material.
class SshBranch {
 public:
  SshBranch(Branch branch, const model::Material& material, const Numerics& numerics);

  /// Its state at 0 < V_r < 1; or where it ends on the way there, in a fold, a closed neck or by a failure of
  /// Newton's method. Empty when Newton's method fails at the entry.
  std::optional<FollowResult> at(double reduced_volume);

 private:
  using Waypoint = std::optional<BranchState>;

  const std::optional<BranchState>& entry();
  const Waypoint& classical(int k);  // H₀ = 0
  const Waypoint& downward(int k);   // carried on from above
  const Waypoint& waypoint(int k);   // the best
  bool is_classical() const;
  FollowResult with_H0(const BranchState& classical) const;
  std::optional<FollowResult> end_towards_H0(double reduced_volume);  // where no waypoint is there
  double share_of_closing(
      double reduced_volume) const;  // H₀ over that which closes the neck; 0 of symmetric branches
  /// Of stomatocytes that are all closed at V_r <= 0.65: where H₀ is 0.8 of what closes the neck, by a way on which it is
  /// always that.
  const Waypoint& with_open_neck();
  FollowResult along(const BranchState& from, double reduced_volume) const;
  bool is_ours(const FollowResult& found) const;
  bool is_better(const BranchState& a, const BranchState& b) const;
  Waypoint better(const Waypoint& a, const FollowResult& b) const;

  Branch branch_;
  model::Material material_, classical_material_;
  Numerics numerics_;
  std::optional<std::optional<BranchState>> entry_;
  std::map<int, Waypoint> classical_, downward_, waypoints_, open_;
};

}  // namespace sbeh::axisym
