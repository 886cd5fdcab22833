#include "meshing/quality.h"
#include "studies/evolution/evolution_files.h"
#include "studies/io/columns.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/report/history_charts.h"
#include "studies/report/live_data.h"
#include "studies/report/packed_profiles.h"

#include <algorithm>
#include <array>
#include <string>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_states = 200;
constexpr std::size_t most_numbers = 24'000'000;  // of all frames: the page stays below some 40 MB

constexpr std::array field_names{"x", "y", "z", "order", "H", "speed"};
constexpr std::size_t field_count = field_names.size();
using Fields = Eigen::Matrix<float, field_count, Eigen::Dynamic>;  // fields x nodes

struct Frame {
  FrameEntry entry;
  std::size_t mesh;
  Fields fields;
};
struct Mesh {
  Eigen::MatrixXi curved;  // 10 nodes x triangles
  Eigen::Matrix3Xi plain;
};

CurvedFile read_curved_frame(const fs::path& path) {
  if (auto file = read_curved_mesh(path))
    if (file->fields.contains("order") && file->fields.contains("mean_curvature"))
      return std::move(*file);
  throw InputError(
      fmt::format("{}: is no frame of a run: delete it to have a page without it", path.string()));
}

Fields fields_of(const CurvedFile& file) {
  Fields fields(field_count, file.mesh.node_count());
  fields.topRows<3>() = file.mesh.nodes.cast<float>();
  fields.row(3) = file.fields.at("order").row(0).cast<float>();
  fields.row(4) = file.fields.at("mean_curvature").row(0).cast<float>();
  const auto velocity = file.fields.find("velocity");  // none at the start
  if (velocity == file.fields.end())
    fields.row(5).setZero();
  else
    fields.row(5) = velocity->second.colwise().norm().cast<float>();
  return fields;
}

std::vector<FrameEntry> evenly(const std::vector<FrameEntry>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<FrameEntry> chosen;
  for (std::size_t k = 0; k < most; ++k)
    chosen.push_back(all[most == 1 ? 0 : k * (all.size() - 1) / (most - 1)]);
  return chosen;
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
  const auto nodes = std::size_t(read_curved_frame(folder / frames.back().file).mesh.node_count());
  return std::clamp<std::size_t>(most_numbers / (field_count * nodes), 1, most_states);
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

struct Film {
  std::vector<Frame> frames;
  std::vector<Mesh> meshes;
  std::array<NumberRange, field_count> ranges;
};
bool same(const Eigen::MatrixXi& a, const Eigen::MatrixXi& b) {
  return a.cols() == b.cols() && a == b;
}

Film read_film(const fs::path& folder, const std::vector<FrameEntry>& frames) {
  Film film;
  for (const FrameEntry& entry : frames) {
    const CurvedFile file = read_curved_frame(folder / entry.file);
    if (film.meshes.empty() || !same(film.meshes.back().curved, file.mesh.triangles))
      film.meshes.push_back({file.mesh.triangles, meshing::lattice(file.mesh).triangles});
    const Frame& frame =
        film.frames.emplace_back(Frame{entry, film.meshes.size() - 1, fields_of(file)});
    for (std::size_t k = 0; k < field_count; ++k)
      for (const float value : frame.fields.row(Eigen::Index(k))) film.ranges[k].include(value);
  }
  return film;
}

void add_mesh(Bundle& bundle, const Film& film, std::size_t index, std::string& table) {
  const Mesh& mesh = film.meshes[index];
  std::vector<std::uint16_t> numbers;
  Eigen::Index nodes = 0;
  int count = 0;
  for (const Frame& frame : film.frames) {
    if (frame.mesh != index) continue;
    nodes = frame.fields.cols();
    ++count;
    for (std::size_t k = 0; k < field_count; ++k)
      for (const float value : frame.fields.row(Eigen::Index(k)))
        numbers.push_back(quantised(value, film.ranges[k]));
  }
  bundle.add(fmt::format("mesh/{}", index),
             std::vector<std::uint32_t>(mesh.plain.data(), mesh.plain.data() + mesh.plain.size()));
  bundle.add(fmt::format("frames/{}", index),
             differences(numbers, field_count * std::size_t(nodes)));
  table += fmt::format("{},{},{}\n", mesh.curved.cols(), nodes, count);
}

}  // namespace

Bundle live_run(const fs::path& folder, const std::optional<ResultUnits>& units) {
  const std::vector<FrameEntry> there = entries_there(folder, "frames.csv");
  const Film film = read_film(folder, evenly(there, most_frames(folder, there)));
  Bundle bundle = history(folder, there.size(), units);
  std::string shown = "time,file,mesh\n", fields = "name,low,high\n",
              meshes = "triangles,nodes,frames\n";
  for (const Frame& frame : film.frames)
    shown += fmt::format("{},{},{}\n", shown_time(frame.entry.time, units),
                         csv_field(frame.entry.file), frame.mesh);
  for (std::size_t k = 0; k < field_count; ++k)
    fields +=
        fmt::format("{},{:.8g},{:.8g}\n", field_names[k], film.ranges[k].low, film.ranges[k].high);
  for (std::size_t k = 0; k < film.meshes.size(); ++k) add_mesh(bundle, film, k, meshes);
  bundle.add("shown.csv", shown);
  bundle.add("fields.csv", fields);
  bundle.add("meshes.csv", meshes);
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
