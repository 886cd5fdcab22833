#include "studies/report/live_data.h"
#include "studies/report/packed_profiles.h"
#include "studies/scan/scan_table.h"

namespace sbeh::studies {

namespace fs = std::filesystem;

Bundle live_scan(const fs::path& folder, const std::optional<ResultUnits>& units) {
  Bundle bundle;
  for (const char* table :
       {"scan.csv", "folds.csv", "equal_energy.csv", "stability_lines.csv", "lowest.csv"})
    if (fs::exists(folder / table)) add_table(bundle, folder, table, units);
  add_units(bundle, units, read_csv(folder / "scan.csv").columns);
  bundle.add("folder", folder.string());
  const std::vector<PointResult> points = read_rows(scan_columns(), folder / "scan.csv");
  PackedProfiles profiles(points.size());
  int row = 0;
  for (const PointResult& point : points) {
    const fs::path file = point_file(folder, point.key, ".csv");
    if (fs::exists(file)) profiles.add(row, file);
    ++row;
  }
  profiles.put_into(bundle);
  return bundle;
}

}  // namespace sbeh::studies
