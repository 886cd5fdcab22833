#include "studies/scan/scan_row.h"

#include "studies/io/errors.h"
#include "studies/parameters/material_input.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

namespace sbeh::studies {

ScanRow read_scan_row(const TomlTable& start, model::Model absent) {
  ScanRow row;
  row.folder = start.text("folder");
  row.model = start.choice("model", rest_models, std::optional(rest_model(absent)));
  read_value(start, "branch", row.branch);
  row.reduced_volume = start.number("reduced_volume", reduced_volumes);
  row.L = start.number("L", above(0));
  return row;
}

const std::vector<std::string>& scan_row_keys() {
  static const std::vector<std::string> keys{"folder", "model", "branch", "reduced_volume", "L"};
  return keys;
}

void write_shape(TomlText& toml, const ScanRow& row) {
  toml.value("folder", row.folder);
  toml.value("model", row.model);
  toml.value("branch", row.branch);
  toml.value("reduced_volume", row.reduced_volume);
  toml.value("L", row.L);
}

axisym::State state_of(const ScanRow& row) {
  const std::filesystem::path file = point_file(row.folder, row, ".csv");
  if (!std::filesystem::exists(file))
    throw OutputError(fmt::format("{}: is not there; the rows of that scan stand in {}/scan.csv",
                                  file.string(), row.folder));
  return read_profile(file);
}

}  // namespace sbeh::studies
