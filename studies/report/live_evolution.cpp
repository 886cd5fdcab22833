#include "studies/evolution/evolution_files.h"
#include "studies/io/columns.h"
#include "studies/report/history_charts.h"
#include "studies/report/live_data.h"
#include "studies/report/packed_film.h"
#include "studies/report/packed_profiles.h"

#include <algorithm>
#include <string>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_states = 200;

const std::vector<std::string> frame_fields{"order", "H", "speed"};

CurvedFile read_frame_surface(const fs::path& path) {
  return read_surface(path, {"order", "mean_curvature"}, "frame of a run");
}

// fields x nodes
Eigen::MatrixXf fields_of(const CurvedFile& file) {
  Eigen::MatrixXf fields(3, file.mesh.node_count());
  fields.row(0) = file.fields.at("order").row(0).cast<float>();
  fields.row(1) = file.fields.at("mean_curvature").row(0).cast<float>();
  const auto velocity = file.fields.find("velocity");  // none at the start
  if (velocity == file.fields.end())
    fields.row(2).setZero();
  else
    fields.row(2) = velocity->second.colwise().norm().cast<float>();
  return fields;
}

// Those of a table whose files are there.
std::vector<FrameEntry> entries_there(const fs::path& folder, const char* table) {
  std::vector<FrameEntry> there;
  for (const FrameEntry& entry : read_rows(frame_columns(), folder / table))
    if (fs::exists(folder / entry.file)) there.push_back(entry);
  return there;
}

// As many as a page can hold, when all have as many nodes as the last.
std::size_t most_frames(const fs::path& folder, const std::vector<FrameEntry>& frames) {
  if (frames.empty()) return 0;
  const auto nodes = std::size_t(read_frame_surface(folder / frames.back().file).mesh.node_count());
  const std::size_t fields = 3 + frame_fields.size();
  return std::clamp<std::size_t>(most_film_numbers / (fields * nodes), 1, most_states);
}

// What every evolution's data have.
Bundle history(const fs::path& folder, std::size_t states,
               const std::optional<ResultUnits>& units) {
  Bundle bundle;
  add_table(bundle, folder, "series.csv", units);
  add_units(bundle, units, read_csv(folder / "series.csv").columns);
  bundle.add("charts.csv", table_of_charts(units));
  bundle.add("states", std::to_string(states));
  return bundle;
}

// As in series.csv, so that the page finds the row of a state.
std::string shown_time(double time, const std::optional<ResultUnits>& units) {
  return units ? converted_number(time, units->scales().factor(dimension::time))
               : fmt::format("{}", time);
}

}  // namespace

Bundle live_run(const fs::path& folder, const std::optional<ResultUnits>& units) {
  const std::vector<FrameEntry> there = entries_there(folder, "frames.csv");
  Bundle bundle = history(folder, there.size(), units);
  PackedFilm film(frame_fields);
  std::string shown = "time,file,mesh\n";
  for (const FrameEntry& entry : evenly(there, most_frames(folder, there))) {
    const CurvedFile file = read_frame_surface(folder / entry.file);
    shown += fmt::format("{},{},{}\n", shown_time(entry.time, units), csv_field(entry.file),
                         film.add(file.mesh, fields_of(file)));
  }
  bundle.add("shown.csv", shown);
  film.put_into(bundle);
  return bundle;
}

Bundle live_relax(const fs::path& folder, const std::optional<ResultUnits>& units) {
  const std::vector<FrameEntry> there = entries_there(folder, "profiles.csv");
  Bundle bundle = history(folder, there.size(), units);
  const std::vector<FrameEntry> entries = evenly(there, most_states);
  PackedProfiles profiles(entries.size());
  std::string shown = "time,file\n";
  int index = 0;
  for (const FrameEntry& entry : entries) {
    profiles.add(index++, folder / entry.file);
    shown += fmt::format("{},{}\n", shown_time(entry.time, units), csv_field(entry.file));
  }
  bundle.add("shown.csv", shown);
  profiles.put_into(bundle);
  return bundle;
}

}  // namespace sbeh::studies
