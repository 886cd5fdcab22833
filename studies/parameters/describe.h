// Inputs as text: which kind a file is, and a resolved input written back as TOML.
#pragma once

#include "studies/compare/compare_input.h"
#include "studies/evolution/relax_input.h"
#include "studies/evolution/run_input.h"
#include "studies/scan/scan_input.h"
#include "studies/stability/stability_input.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace sbeh::studies {

enum class InputKind {
  scan,      ///< has a table [scan]: read_scan
  relax,     ///< has a table [start]: read_relax
  run,       ///< has a table [surface]: read_run
  compare,   ///< has a table [compare]: read_compare
  stability  ///< has a table [stability]: read_stability
};

/// Throws InputError if the file cannot be read or has not one of these tables.
InputKind kind_of(const std::filesystem::path& path);

/// The whole input, defaults included, as TOML under a comment with the program's version. Numbers
/// have as many digits as they need: reading the text gives the same input, bit for bit.
std::string describe(const ScanInput& input, std::string_view version);
std::string describe(const RelaxInput& input, std::string_view version);
std::string describe(const RunInput& input, std::string_view version);
std::string describe(const CompareInput& input, std::string_view version);
std::string describe(const StabilityInput& input, std::string_view version);

}  // namespace sbeh::studies
