#include "studies/modes/mode_file.h"
#include "studies/report/live_data.h"
#include "studies/report/packed_fields.h"
#include "studies/report/packed_film.h"
#include "studies/rest_states/rest_row.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> film_fields{"order", "H"};
const std::vector<std::string> mode_fields{"u", "b"};

CurvedFile read_state_frame(const fs::path& path) {
  return read_surface(path, {"order", "mean_curvature", "normal"}, "frame of a state");
}

std::vector<int> frames_there(const fs::path& folder) {
  const StatesInput input = read_states(folder / "run.toml");
  std::vector<int> numbers;
  for (const RestRow& row : read_rows(rest_columns(input), folder / "states.csv"))
    if (fs::exists(frame_of(folder, row.key))) numbers.push_back(row.key);
  return numbers;
}

// When all have as many nodes as the last.
FilmRoom room_for(const fs::path& folder, const std::vector<int>& numbers) {
  if (numbers.empty()) return {};
  const auto nodes =
      std::size_t(read_state_frame(frame_of(folder, numbers.back())).mesh.node_count());
  return film_room(numbers.size(), (3 + film_fields.size()) * nodes, mode_fields.size() * nodes);
}

std::vector<double> numbers_of(const Eigen::VectorXd& field) {
  return {field.data(), field.data() + field.size()};
}

// u along the normals of the frame, and b.
void add_mode(const fs::path& path, std::string_view key, const CurvedFile& frame,
              PackedFields& shapes) {
  const CurvedFile file = read_surface(path, {"displacement", "order_change"}, "mode of a state");
  if (file.mesh.node_count() != frame.mesh.node_count())
    throw InputError(fmt::format("{}: is no mode of the state in frames/, which has other nodes",
                                 path.string()));
  Eigen::VectorXd u = file.fields.at("displacement")
                          .cwiseProduct(frame.fields.at("normal"))
                          .colwise()
                          .sum()
                          .transpose();
  Eigen::VectorXd b = file.fields.at("order_change").row(0).transpose();
  normalise(u, b);
  shapes.add(key, {numbers_of(u), numbers_of(b)});
}

}  // namespace

Bundle live_states(const fs::path& folder, const std::optional<ResultUnits>& units) {
  Bundle bundle;
  add_table(bundle, folder, "states.csv", units);
  add_units(bundle, units, read_csv(folder / "states.csv").columns);
  const std::vector<int> there = frames_there(folder);
  const FilmRoom room = room_for(folder, there);
  PackedFilm film(film_fields);
  PackedFields shapes("mode_shapes", mode_fields);
  std::string shown = "number,mesh\n";
  for (const int number : evenly(there, room.frames)) {
    const CurvedFile frame = read_state_frame(frame_of(folder, number));
    Eigen::MatrixXf values(film_fields.size(), frame.mesh.node_count());
    values << frame.fields.at("order").cast<float>(),
        frame.fields.at("mean_curvature").cast<float>();
    shown += fmt::format("{},{}\n", number, film.add(frame.mesh, values));
    for (std::size_t k = 1; k <= room.modes && fs::exists(mode_of(folder, number, int(k))); ++k)
      add_mode(mode_of(folder, number, int(k)), fmt::format("{}/{}", number, k), frame, shapes);
  }
  bundle.add("shown.csv", shown);
  film.put_into(bundle);
  shapes.put_into(bundle);
  return bundle;
}

}  // namespace sbeh::studies
