// The modes of one stationary state: what is stable, how it moves, how it fluctuates.
#pragma once

#include "studies/io/columns.h"
#include "studies/modes/mode_file.h"
#include "studies/modes/modes_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// A row of modes.csv.
struct ModeRow {
  ModeKey key;
  double eigenvalue = not_known;  ///< λ: δ²F = λ ∫(u² + b²) cos² mφ dS; < 0: the energy falls
  double rate = not_known;        ///< of the flow; > 0: it grows
  /// Estimated by half as many elements, which may not have the mode; besides, λ is off by the rigid residual.
  double eigenvalue_error = not_known, rate_error = not_known;
};
const Columns<ModeRow>& mode_columns();

/// A row of a mode's table, modes/m2_even_1.csv: a node.
struct ModeNode {
  double arc_length, r, z, order, displacement, order_change;
  double energy_displacement, energy_order_change;  ///< of the eigenfunction of λ
};
const Columns<ModeNode>& mode_node_columns();

/// A row of fluctuations.csv.
struct FluctuationRow {
  ModeKey key;
  double eigenvalue = not_known;
  double mean_square = not_known;  ///< of the amplitude a, ∫(u² + b²) cos² mφ dS = 1: k_BT/λ
};
const Columns<FluctuationRow>& fluctuation_columns();

/// A row of contour.csv: of the widest circle's radius R + Σ (a_m cos mφ + b_m sin mφ).
struct ContourRow {
  int m = 0;
  double mean_square = not_known;  ///< ⟨a_m²⟩, for m ≥ 1 also ⟨b_m²⟩
  double spectrum = not_known;  ///< ⟨|c_m|²⟩ of c_m = (1/2π) ∫ (radius − R) e^{−imφ} dφ
};
const Columns<ContourRow>& contour_columns();

struct ModesSummary {
  std::vector<ModeRow> modes;
  std::vector<FluctuationRow> fluctuations;
  std::vector<ContourRow> contour;
  double rigid_residual = 0;  ///< largest |λ| of a rigid motion, which is 0 of the exact state
  double largest_radius = 0;  ///< of the widest circle
  std::vector<std::string> warnings;
  /// Whether all signs are known: otherwise some |λ| is no larger than its error or the residual.
  bool is_resolved() const;
};

/// Computes them into a folder: run.toml (the resolved input), modes.csv, modes/ (a .vtu and a .csv of each), and where
/// k_BT is given fluctuations.csv and contour.csv. A folder that holds other results is refused. Throws InputError,
/// OutputError, Interrupted, and std::runtime_error where there is no such state.
ModesSummary run_modes(const ModesInput& input, const std::filesystem::path& folder,
                       std::string_view version);

/// The rows and what they say, for people.
std::string table_of(const ModesInput& input, const ModesSummary& summary);

}  // namespace sbeh::studies
