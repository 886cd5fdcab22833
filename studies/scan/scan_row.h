// One point of an earlier scan as a start.
#pragma once

#include "axisym/curve.h"
#include "studies/scan/scan_input.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// The stationary state of one point of an earlier scan.
struct ScanRow : PointKey {
  std::string folder;  ///< the scan's results, as written: relative to the working directory

  bool operator==(const ScanRow&) const = default;
};

/// The keys of a start with shape = "scan", `absent` the model where none is named. Throws InputError.
ScanRow read_scan_row(const TomlTable& start, model::Model absent);
const std::vector<std::string>& scan_row_keys();
void write_shape(TomlText& toml, const ScanRow& row);

/// The profile of that point. Throws OutputError where it is not there or is none.
axisym::State state_of(const ScanRow& row);

}  // namespace sbeh::studies
