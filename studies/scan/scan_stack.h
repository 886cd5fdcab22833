// A scan over further numbers of the material: a scan over (V_r, L) for each of their values, in a folder of its own.
#pragma once

#include "studies/scan/scan.h"

#include <string>
#include <vector>

namespace sbeh::studies {

struct ScanLayer {
  std::vector<double> values;  ///< of the input's axes
  std::string folder;          ///< in that of the stack, such as "H0_-2"
  ScanInput input;             ///< without axes
};
/// All combinations of the axes' values, the last axis fastest.
std::vector<ScanLayer> layers_of(const ScanInput& input);

/// Runs the layers one after the other. The tables of the stack's folder are those of all layers, below columns with the axes'
/// values. As run_scan.
ScanSummary run_stack(const ScanInput& input, const std::filesystem::path& folder,
                      std::string_view version);

/// A part of each layer, in the folder of that. As run_scan_part.
ScanSummary run_stack_part(const ScanInput& input, const std::filesystem::path& folder,
                           const Part& part, std::string_view version);

}  // namespace sbeh::studies
