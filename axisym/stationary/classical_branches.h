// The classical diagram by the finite elements: branches, and the special points between them.
#pragma once

#include "axisym/options.h"
#include "axisym/stationary/branch_entry.h"

#include <array>
#include <optional>
#include <span>

namespace sbeh::axisym {

/// κ = 1 and no potential: the energy is F − 4π and the multipliers are those of F.
model::Material classical_material();

/// F/(8πκ) of a state of that material.
double reduced_energy(const BranchState& state);

/// The shape of such a state.
ClassicalShape shape_of(Branch branch, const BranchState& state);

/// The branches, each entered once: oblates and prolates from spheroids with V_r = 0.95, stomatocytes from
/// the pitchfork of the oblates over their fold. All functions throw std::domain_error where a branch is
/// lost.
class ElementBranches {
 public:
  explicit ElementBranches(const Numerics& numerics) : numerics_(numerics) {}

  /// The states of a branch at these reduced volumes, in their order; those of the stomatocytes are the
  /// stable ones, beyond the fold. Throws std::domain_error naming the reduced volume that the branch does
  /// not reach.
  std::vector<BranchState> states(Branch branch, std::span<const double> reduced_volumes);
  std::vector<ClassicalShape> shapes(Branch branch, std::span<const double> reduced_volumes);

  /// The five special points. The errors are the differences from half as many elements, which
  /// overestimate: the energies converge with the sixth power.
  SpecialPoints special_points_with_errors();

 private:
  const BranchState& entry(Branch branch);
  const BranchState& flat_oblate();  // V_r = 0.59
  const BranchEntry& stomatocytes();
  SpecialPoints special_points();  // errors 0

  Numerics numerics_;
  std::array<std::optional<BranchState>, 3> entries_;
  std::optional<BranchState> flat_;
  std::optional<BranchEntry> stomatocytes_;
};

}  // namespace sbeh::axisym
