// Of which stationary state the modes are asked for, and which of them.
#pragma once

#include "axisym/stationary/stationary_case.h"
#include "studies/parameters/units.h"
#include "studies/scan/scan_row.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sbeh::studies {

inline constexpr int largest_mode_m = 50, most_mode_number = 20;
inline constexpr const char* no_sphere =
    "must be < 1: a sphere may have any tension, and its modes depend on that";

/// Table [modes], all keys as the members, those of `state` without its name; optional [material] (without L) and
/// [numerics], which a scan's row brings.
struct ModesInput {
  /// Folder of a scan whose row is the state; empty: the branch is followed from its entry on.
  std::string scan;
  axisym::StationaryCase state;  ///< V_r < 1: the tension of the sphere may be any
  int largest_m = 5;             ///< 0 … 50
  int number = 1;  ///< modes of each m and parity, 1 … 20; all unstable ones are there besides
  double thermal_energy = 0;     ///< k_BT, key `fluctuations`; 0: no fluctuations
  std::optional<Units> units{};  ///< for people: no number depends on them

  bool operator==(const ModesInput&) const = default;
};

/// The row of the scan that is the state.
ScanRow row_of(const ModesInput& input);

/// Takes the material of the scan. Throws InputError where the folder holds no scan.
void take_from_scan(ModesInput& input);

/// Throws InputError.
ModesInput read_modes(const std::filesystem::path& path);

/// The state alone that a run.toml of modes describes, the scan it may be from not being looked at. Throws InputError.
axisym::StationaryCase described_state(const std::filesystem::path& description);

/// The state for people, such as "SSH oblate, V_r = 0.8, L = 0.05".
std::string text_of(const axisym::StationaryCase& of);

struct ModesCost {
  int modes;       ///< without more unstable ones than are asked for
  double seconds;  ///< of one core
  double megabytes;
};
/// About what was measured, within a factor of two; more where a slender state needs many elements.
ModesCost cost_of(const ModesInput& input);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const ModesInput& input, std::string_view version);

}  // namespace sbeh::studies
