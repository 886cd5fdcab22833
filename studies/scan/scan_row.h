// One point of an earlier scan as a start.
#pragma once

#include "axisym/curve.h"
#include "studies/parameters/physics.h"
#include "studies/scan/scan_input.h"

#include <filesystem>
#include <optional>
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

/// Whether the scan's folder still says with what it was computed.
bool is_there(const ScanRow& row);
/// With the row's model, and the scan's material with the row's L. Throws InputError where the folder holds no
/// scan.
Origin origin_of(const ScanRow& row);

/// The profile of that point. Throws OutputError where it is not there or is none, and where the row is not
/// stationary: its profile is that of another L or of nothing at rest.
axisym::State state_of(const ScanRow& row);

/// What is to be said of a profile as it stands in the folder of a scan, which is not that of a stationary row;
/// empty for all others.
std::optional<std::string> remark_on_profile(const std::filesystem::path& profile);

}  // namespace sbeh::studies
