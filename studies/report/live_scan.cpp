#include "studies/modes/modes.h"
#include "studies/parameters/material_input.h"
#include "studies/report/live_data.h"
#include "studies/report/packed_profiles.h"
#include "studies/scan/scan_table.h"

#include <fmt/format.h>

#include <array>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// Of a point, by its row.
struct PointModes {
  int row;
  fs::path folder;  // relative to the scan's
  std::vector<ModeRow> modes;
};

std::vector<PointModes> modes_there(const fs::path& folder,
                                    const std::vector<PointResult>& points) {
  std::vector<PointModes> there;
  for (std::size_t row = 0; row < points.size(); ++row)
    if (const fs::path of = "modes/" + stem(points[row].key); fs::exists(folder / of / "modes.csv"))
      there.push_back({int(row), of, read_rows(mode_columns(), folder / of / "modes.csv")});
  return there;
}

// A folder may have been renamed, or be of another scan.
void require_modes_of(const axisym::StationaryCase& of, const fs::path& modes) {
  const axisym::StationaryCase there = described_state(modes / "run.toml");
  const std::string here = text_of(of), other = text_of(there);
  const auto differ = differences(there.material, of.material, parameters_of_motion);
  if (here == other && differ.empty()) return;
  throw InputError(fmt::format(
      "{}: holds the modes of {}{}, not of {}: delete it, or make them again by sbeh modes --scan",
      modes.string(), other, here == other ? " with another " + differ.front().name : "", here));
}

void add_shapes(const fs::path& folder, const PointModes& of, std::size_t most_nodes,
                PackedFields& shapes) {
  for (const ModeRow& mode : of.modes) {
    const fs::path file = folder / of.folder / "modes" / (stem(mode.key) + ".csv");
    if (!fs::exists(file)) continue;
    const auto nodes = evenly(read_rows(mode_node_columns(), file), most_nodes);
    using Node = ModeNode;
    shapes.add(fmt::format("{}/{}", of.row, stem(mode.key)),
               field_values(nodes, std::array{&Node::r, &Node::z, &Node::order, &Node::displacement,
                                              &Node::order_change}));
  }
}

// modes.csv of all, after the row they belong to.
std::string table_of_modes(const fs::path& folder, const std::vector<PointModes>& all,
                           const std::optional<ResultUnits>& units) {
  CsvTable table;
  for (const PointModes& of : all) {
    CsvTable part = read_csv(folder / of.folder / "modes.csv");
    if (units) part = units->values(part, of.folder / "modes.csv");
    if (table.columns.empty()) {
      table.columns = part.columns;
      table.columns.insert(table.columns.begin(), "row");
    }
    for (std::size_t k = 0; k < part.rows.size(); ++k) {
      auto& fields = table.rows.emplace_back(std::vector{std::to_string(of.row)});
      for (std::size_t c = 1; c < table.columns.size(); ++c)
        fields.push_back(part.text(k, table.columns[c]));
    }
  }
  return text_of(table);
}

void add_modes(Bundle& bundle, const fs::path& folder, const std::vector<PointResult>& points,
               const std::optional<ResultUnits>& units) {
  const std::vector<PointModes> there = modes_there(folder, points);
  if (there.empty()) return;
  const ScanInput scan = read_scan(folder / "run.toml");
  std::size_t count = 0;
  for (const PointModes& of : there) {
    require_modes_of(case_of(scan, points[std::size_t(of.row)].key), folder / of.folder);
    count += of.modes.size();
  }
  PackedFields shapes("mode_shapes", {"r", "z", "order", "u", "b"});
  for (const PointModes& of : there) add_shapes(folder, of, most_profile_nodes(count), shapes);
  bundle.add("point_modes.csv", table_of_modes(folder, there, units));
  shapes.put_into(bundle);
}

}  // namespace

Bundle live_scan(const fs::path& folder, const std::optional<ResultUnits>& units) {
  Bundle bundle;
  for (const char* table :
       {"scan.csv", "folds.csv", "equal_energy.csv", "stability_lines.csv", "lowest.csv"})
    if (fs::exists(folder / table)) add_table(bundle, folder, table, units);
  std::vector<std::string> columns = read_csv(folder / "scan.csv").columns;
  for (const auto& column : mode_columns()) columns.push_back(column.name);
  add_units(bundle, units, columns);
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
  add_modes(bundle, folder, points, units);
  return bundle;
}

}  // namespace sbeh::studies
