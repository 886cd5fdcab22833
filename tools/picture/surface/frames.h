// Which of the states of an evolution a picture shows, and what is in their files.
#pragma once

#include "studies/evolution/evolution_files.h"
#include "studies/mesh_files/mesh_file.h"
#include "tools/picture/options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace sbeh::picture {

/// The rows of frames.csv or profiles.csv, with the file by its path. Throws OutputError.
std::vector<studies::FrameEntry> read_frames(const std::filesystem::path& table);

/// At most so many: the first, the last, and between them the frames nearest to times in geometric
/// progression: an evolution is fast at first.
std::vector<studies::FrameEntry> chosen_frames(const std::vector<studies::FrameEntry>& frames,
                                               std::size_t most);

/// The frames nearest to these times, each once, in the order of time.
std::vector<studies::FrameEntry> nearest_frames(const std::vector<studies::FrameEntry>& frames,
                                                const std::vector<double>& times);

/// Those the user asks for, or at most so many.
std::vector<studies::FrameEntry> shown_frames(const std::filesystem::path& table,
                                              const Options& options, std::size_t most);

/// The surface of a frame with its fields `order` and `mean_curvature`. Throws InputError.
studies::CurvedFile read_state(const std::filesystem::path& frame);
/// At its nodes.
Eigen::VectorXd field_of(const studies::CurvedFile& state, Field field);

/// That of the colours: all values of an order; of a curvature, where a few extremes would take all colours, all but a
/// hundredth at either end.
Range shown_range(std::vector<double> values, Field field);
/// Of the bar of these colours; says what they leave out.
std::string shown_title(Field field, const Options& options);

/// "t = 0.3", in units "t = 0.3 s"
std::string time_title(const studies::FrameEntry& frame, const Options& options);

}  // namespace sbeh::picture
