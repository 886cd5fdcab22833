#include "tools/picture/canvas/frames.h"

#include "studies/io/errors.h"
#include "tools/picture/canvas/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::picture {

std::vector<Frame> read_frames(const std::filesystem::path& path) {
  const CsvTable table(path);
  const std::size_t time = table.column("time"), file = table.column("file");
  std::vector<Frame> frames;
  for (std::size_t row = 0; row < table.rows(); ++row)
    frames.push_back({table.number(row, time), path.parent_path() / table.text(row, file)});
  return frames;
}

std::vector<Frame> chosen_frames(const std::vector<Frame>& frames, std::size_t most) {
  if (frames.size() <= most) return frames;
  const std::size_t first =
      std::ranges::find_if(frames, [](const Frame& f) { return f.time > 0.0; }) - frames.begin();
  std::vector<Frame> chosen(1, frames.front());
  std::size_t next = 1;
  for (std::size_t i = 1; i < most; ++i) {
    const double fraction = double(i - 1) / double(most - 2);
    const double wanted =
        frames[first].time * std::pow(frames.back().time / frames[first].time, fraction);
    const std::size_t latest = frames.size() - (most - i);  // leaves one frame for each to come
    while (next < latest
           && std::abs(frames[next + 1].time - wanted) < std::abs(frames[next].time - wanted)) {
      ++next;
    }
    chosen.push_back(frames[next]);
    next = std::min(next + 1, latest + 1);
  }
  return chosen;
}

studies::CurvedFile read_state(const std::filesystem::path& frame) {
  try {
    studies::MeshFile file = studies::read_mesh(frame);
    if (auto* curved = std::get_if<studies::CurvedFile>(&file))
      if (curved->fields.contains("order") && curved->fields.contains("mean_curvature"))
        return std::move(*curved);
  } catch (const studies::InputError& error) {
    throw InputError(error.what());
  }
  throw InputError(fmt::format("{}: is no frame of a run", frame.string()));
}

}  // namespace sbeh::picture
