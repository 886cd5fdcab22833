// What a comparison is asked for: one case, the methods that compute it, and how well they must agree.
#pragma once

#include "axisym/stationary/stationary_case.h"
#include "studies/evolution/run_input.h"
#include "studies/parameters/units.h"
#include "studies/witnesses/witness.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Largest differences allowed, by the names of tolerated_quantities(). Energies are relative to the
/// total energy, all others as they are.
using Tolerances = std::map<std::string, double>;
/// The quantities that are compared: those of witnesses/state.h, "distance" of the profiles, and "history"
/// of the energy, which flow and surface3d have.
std::vector<std::string> tolerated_quantities();

/// An evolution in 3D that several methods follow.
struct EvolutionCase {
  std::string
      file;  ///< an input of `sbeh run`, or the folder of a run that has ended; empty where the input itself holds the run
  RunInput run;

  bool has_ended() const;  ///< whether it is a folder
  bool operator==(const EvolutionCase&) const = default;
};

/// Of a stationary state. Table [compare]: model, branch, reduced_volume, L, methods; optional [material] (without L),
/// [numerics] (of newton), [surface3d], [harmonics], [tolerance] (pairs of axisymmetric methods) and
/// [tolerance_3d] (pairs with surface3d or harmonics).
/// Of an evolution. Table [compare]: evolution, methods ("surface3d", "harmonic_flow"); optional [harmonic_flow] and
/// [tolerance_3d]. The run may stand in the input itself, its tables as [evolution.surface] and so on; beside the folder of a run
/// that has ended they say what it must be.
struct CompareInput {
  axisym::StationaryCase state;  ///< V_r < 1, one-constant approximation
  std::vector<Witness> methods;  ///< two at least; the first is the reference
  SurfaceMethod surface3d;
  HarmonicMethod harmonics;
  Tolerances tolerance, tolerance_3d;
  std::optional<EvolutionCase> evolution{};  ///< then the state has but its model and material
  HarmonicFlowMethod harmonic_flow{};

  bool has(Witness witness) const;
  std::optional<Units> units{};  ///< for people: no number depends on them

  bool operator==(const CompareInput&) const = default;
};

/// Throws InputError.
CompareInput read_compare(const std::filesystem::path& path);

/// The whole input, as that of a scan (scan_input.h).
std::string describe(const CompareInput& input, std::string_view version);

}  // namespace sbeh::studies
