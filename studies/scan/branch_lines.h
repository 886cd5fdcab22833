// The lines of a diagram: where a branch of SBEH ends in a fold, and where two branches have equal energy.
#pragma once

#include "axisym/stationary/fold_kind.h"
#include "studies/scan/branch_points.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// Gives the state of a finished stationary point; empty where there is none.
using PointLookup = std::function<std::optional<PointOutcome>(const PointKey&)>;

/// A fold of a branch at a reduced volume of the scan, or at an L of it.
struct FoldRow {
  axisym::Branch branch;
  double reduced_volume, L, energy, order_min, H_abs_max;
  /// Where the order is lost; none in tables of other versions.
  std::optional<axisym::FoldKind> kind{};
  double L_error = not_known, energy_error = not_known;  ///< estimated
  double reduced_volume_error = not_known;               ///< of a fold along V_r, whose L is given
};

/// Whether the branch ends there as V_r changes, at a given L, and not as L does.
inline bool is_along_volume(const FoldRow& fold) { return !std::isnan(fold.reduced_volume_error); }

/// The folds of SBEH in which the branches end as L grows, below L = 2, one per reduced volume and
/// branch: those that the scan has run into, and those ahead of its largest L. Of states with domains also those in which
/// they end as V_r falls, that the scan has run into. In parallel.
std::vector<FoldRow> find_folds(const ScanInput& input, const PointLookup& point);

/// Two branches of equal energy.
struct EqualEnergyRow {
  axisym::Branch first, second;
  double L, reduced_volume, energy;
};

/// For every L and pair of branches: the reduced volumes between two of the scan's at which their
/// energies (SBEH's, or SSH's when only that is scanned) are equal, by Newton's method with the
/// slope ∂U/∂V = P. In parallel.
std::vector<EqualEnergyRow> find_equal_energies(const ScanInput& input, const PointLookup& point);

/// Of folds.csv and equal_energy.csv.
const Columns<FoldRow>& fold_columns();
const Columns<EqualEnergyRow>& equal_energy_columns();

}  // namespace sbeh::studies
