// Which of the states of an evolution a picture shows, and what is in their files.
#pragma once

#include "studies/mesh_files/mesh_file.h"

#include <filesystem>
#include <vector>

namespace sbeh::picture {

struct Frame {
  double time = 0.0;
  std::filesystem::path file;
};

/// The rows of a table with columns `time` and `file`, file names relative to its folder.
std::vector<Frame> read_frames(const std::filesystem::path& table);

/// At most so many: the first, the last, and between them the frames nearest to times in geometric
/// progression: an evolution is fast at first.
std::vector<Frame> chosen_frames(const std::vector<Frame>& frames, std::size_t most);

/// The surface of a frame with its fields `order` and `mean_curvature`. Throws InputError.
studies::CurvedFile read_state(const std::filesystem::path& frame);

}  // namespace sbeh::picture
