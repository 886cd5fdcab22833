#include "studies/scan/scan_row.h"

#include "studies/io/columns.h"
#include "studies/io/errors.h"
#include "studies/io/input_path.h"
#include "studies/parameters/material_input.h"
#include "studies/scan/scan_table.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// Of a row of scan.csv, be it of an older version's.
struct RowStatus {
  PointKey key;
  std::string status, reason;

  bool stationary() const { return status == name(PointStatus::stationary); }
};
const Columns<RowStatus>& status_columns() {
  using Row = RowStatus;
  static const Columns<Row> columns{
      column<Row>("model", inside(&Row::key, &PointKey::model)),
      column<Row>("reduced_volume", inside(&Row::key, &PointKey::reduced_volume)),
      column<Row>("L", inside(&Row::key, &PointKey::L)),
      column<Row>("branch", inside(&Row::key, &PointKey::branch)),
      column("status", &Row::status),
      column("stop_reason", &Row::reason),
  };
  return columns;
}

std::string text_of(const PointKey& key) {
  return fmt::format("{} {}, V_r = {}, L = {}", sbeh::name(key.model), name(key.branch),
                     key.reduced_volume, key.L);
}

// Where to start instead: the row at rest with the nearest L, all else being the same.
std::string advice_for(const PointKey& key, const std::vector<RowStatus>& rows) {
  std::optional<double> nearest;
  for (const RowStatus& row : rows) {
    const double L = row.key.L;
    PointKey same = row.key;
    same.L = key.L;
    if (!row.stationary() || same != key) continue;
    if (!nearest || std::abs(L - key.L) < std::abs(*nearest - key.L)) nearest = L;
  }
  if (!nearest) return "none of that model, branch and reduced volume is";
  return fmt::format(
      "that with L = {} is: start from it, and give L = {} in [material] to go on with that",
      *nearest, key.L);
}

// As a clause.
std::string nearest_to(const PointKey& key, const std::vector<RowStatus>& rows) {
  const auto distance = [&](const RowStatus& row) {
    return std::tuple(!row.stationary(), row.key.model != key.model, row.key.branch != key.branch,
                      std::abs(row.key.reduced_volume - key.reduced_volume),
                      std::abs(row.key.L - key.L));
  };
  const auto nearest = std::ranges::min_element(rows, {}, distance);
  return nearest == rows.end() || !nearest->stationary()
           ? "none of its rows is stationary"
           : "the nearest that is stationary is " + text_of(nearest->key);
}

void require_stationary(const ScanRow& start) {
  const fs::path table = fs::path(start.folder) / "scan.csv";
  const std::vector<RowStatus> rows = read_rows(status_columns(), table);
  const PointKey& key = start;
  const auto at = std::ranges::find_if(rows, [&](const RowStatus& row) { return row.key == key; });
  if (at == rows.end())
    throw OutputError(
        fmt::format("{}: has no row {}; {}", table.string(), text_of(key), nearest_to(key, rows)));
  if (!at->stationary())
    throw OutputError(fmt::format("{}: its row {} is {}, not stationary, and so no start ({}); {}",
                                  table.string(), text_of(key), at->status, at->reason,
                                  advice_for(key, rows)));
}

fs::path description_of(const ScanRow& row) { return fs::path(row.folder) / "run.toml"; }

}  // namespace

ScanRow read_scan_row(const TomlTable& start, model::Model absent) {
  ScanRow row;
  row.folder = start.path("folder");
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

bool is_there(const ScanRow& row) { return fs::exists(description_of(row)); }

Origin origin_of(const ScanRow& row) {
  require_there(row.folder);
  if (!is_there(row) || !fs::exists(fs::path(row.folder) / "scan.csv"))
    throw InputError(fmt::format(
        "{}: is no folder of a scan: it lacks run.toml or scan.csv (make it by: sbeh scan)",
        row.folder));
  const TomlTable file = TomlFile::parse(description_of(row));
  const model::Material material = read_material_without_L(file.table("material"), {row.L});
  return {fmt::format("{}, {}", row.folder, text_of(row)),
          Physics{row.model, material.with_L1(row.L)}};
}

axisym::State state_of(const ScanRow& row) {
  require_stationary(row);
  return read_profile(point_file(row.folder, row, ".csv"));
}

std::optional<std::string> remark_on_profile(const fs::path& profile) {
  const fs::path folder = fs::absolute(profile).parent_path(),
                 table = folder.parent_path() / "scan.csv";
  if (folder.filename() != "points" || !fs::exists(table)) return {};
  for (const RowStatus& row : read_rows(status_columns(), table))
    if (stem(row.key) == profile.stem().string() && !row.stationary())
      return fmt::format("{}: the row of this profile is {}, not stationary: {}", profile.string(),
                         row.status, row.reason);
  return {};
}

}  // namespace sbeh::studies
