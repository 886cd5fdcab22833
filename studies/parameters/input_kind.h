// Which kind of input a file is.
#pragma once

#include "model/names.h"
#include "studies/io/toml_reader.h"

#include <array>
#include <filesystem>

namespace sbeh::studies {

enum class InputKind {
  scan,       ///< has a table [scan]: read_scan
  relax,      ///< has a table [start]: read_relax
  run,        ///< has a table [surface]: read_run
  compare,    ///< has a table [compare]: read_compare
  stability,  ///< has a table [stability]: read_stability
  modes,      ///< has a table [modes]: read_modes
  states,     ///< has a table [states]: read_states
  diagram,    ///< has a table [diagram]: read_diagram
  sweep       ///< has a table [sweep], whatever else: read_sweep
};

/// Those of the commands.
constexpr auto names(InputKind) {
  return std::array{"scan",  "relax",  "run",     "compare", "stability",
                    "modes", "states", "diagram", "sweep"};
}

/// Throws InputError if the file cannot be read or has not one of these tables.
InputKind kind_of(const std::filesystem::path& path);
/// The same of a file that was read already, but for sweeps.
InputKind kind_in(const TomlTable& file, const std::filesystem::path& path);

}  // namespace sbeh::studies
