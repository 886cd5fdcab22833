#include "studies/scan/scan_folder.h"

#include "studies/io/description.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {
bool has_profile(const PointResult& row) {
  return row.diagnostics && row.status != PointStatus::limit;
}
}  // namespace

Scan::Scan(const ScanInput& of, const fs::path& path, std::string_view version, const Part& some)
    : input(of),
      part(some),
      folder(path),
      table(scan_table(prepare(version))),
      progress(begun(version)) {}

bool Scan::takes(double reduced_volume) const {
  const auto& all = input.reduced_volume;
  return part.has(1 + int(std::ranges::find(all, reduced_volume) - all.begin()));
}

std::optional<PointOutcome> Scan::finished(const PointKey& key) {
  const PointResult* row = row_of(key);
  if (!row) return {};
  PointOutcome point{*row, {}};
  if (has_profile(*row))
    point.state = axisym::StationaryState{read_profile(point_file(folder.path(), key, ".csv"))};
  return point;
}

void Scan::keep(const PointKey& key, PointOutcome& point) {
  point.row.key = key;
  if (input.modes > 0) add_modes(case_of(input, key), input.modes, point);
  if (point.state) {
    auto z = point.state->X.row(1).array();
    z -= (z.maxCoeff() + z.minCoeff()) / 2;  // in what goes on from here too
    write_profile(point_file(folder.path(), key, ".csv"), *point.state);
  }
  const std::lock_guard lock(mutex);
  table.append(point.row);
  ++computed;
  progress.advance();
}

const OutputFolder& Scan::prepare(std::string_view version) const {
  begin_or_continue(folder, describe(input, version), "scan.csv", "a scan");
  make_folder(folder / "points");
  if (input.beyond_fold) make_folder(folder / "beyond_fold");
  return folder;
}

Progress Scan::begun(std::string_view version) {
  take_parts(version);
  std::vector<PointKey> keys = points_of(input);
  std::erase_if(keys, [&](const PointKey& key) { return !takes(key.reduced_volume); });
  const auto there = std::ranges::count_if(keys, [&](const auto& key) { return has(key); });
  return Progress("points", int(keys.size()), int(there));
}

// Takes the points over that parts have computed: the files of each first.
void Scan::take_parts(std::string_view version) {
  if (!fs::exists(folder / "parts")) return;
  for (const auto& entry : fs::directory_iterator(folder / "parts")) {
    const fs::path rows = entry.path() / "scan.csv";
    if (!fs::exists(rows)) continue;
    if (const std::string other = studies::mismatch(read_file(entry.path() / "run.toml"),
                                                    describe(input, version), "a part of a scan");
        !other.empty())
      throw OutputError(fmt::format("{}: {}; move it away", entry.path().string(), other));
    for (const PointResult& row : read_rows(scan_columns(), rows)) {
      if (has(row.key)) continue;
      for (const char* ending : {".csv", ".series.csv"})
        if (const fs::path file = point_file(entry.path(), row.key, ending); fs::exists(file))
          write_file(point_file(folder.path(), row.key, ending), read_file(file));
      table.append(row);
    }
  }
}

// None when its profile has gone: then the point counts as not computed.
const PointResult* Scan::row_of(const PointKey& key) {
  const std::lock_guard lock(mutex);
  const PointResult* row = table.find(key);
  return row && has_profile(*row) && !fs::exists(point_file(folder.path(), key, ".csv")) ? nullptr
                                                                                         : row;
}

}  // namespace sbeh::studies
