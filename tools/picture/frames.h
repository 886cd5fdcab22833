// Which of the states of an evolution a picture shows.
#pragma once

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

}  // namespace sbeh::picture
