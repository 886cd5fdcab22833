#include "tools/picture/surface/frames.h"

#include "tools/picture/chart/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::picture {

using studies::FrameEntry;

std::vector<FrameEntry> read_frames(const std::filesystem::path& table) {
  std::vector<FrameEntry> frames = studies::read_rows(studies::frame_columns(), table);
  for (FrameEntry& frame : frames) frame.file = table.parent_path() / frame.file;
  return frames;
}

std::vector<FrameEntry> chosen_frames(const std::vector<FrameEntry>& frames, std::size_t most) {
  if (frames.size() <= most) return frames;
  const std::size_t first =
      std::ranges::find_if(frames, [](const FrameEntry& f) { return f.time > 0.0; })
      - frames.begin();
  std::vector<FrameEntry> chosen(1, frames.front());
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

std::vector<FrameEntry> nearest_frames(const std::vector<FrameEntry>& frames,
                                       const std::vector<double>& times) {
  std::set<std::size_t> chosen;
  if (!frames.empty())
    for (const double time : times)
      chosen.insert(
          std::size_t(std::ranges::min_element(
                          frames, {}, [&](const FrameEntry& f) { return std::abs(f.time - time); })
                      - frames.begin()));
  std::vector<FrameEntry> nearest;
  nearest.reserve(chosen.size());
  for (const std::size_t i : chosen) nearest.push_back(frames[i]);
  return nearest;
}

std::vector<FrameEntry> shown_frames(const std::filesystem::path& table, const Options& options,
                                     std::size_t most) {
  const std::vector<FrameEntry> frames = read_frames(table);
  return options.frames.empty() ? chosen_frames(frames, most)
                                : nearest_frames(frames, options.frames);
}

studies::CurvedFile read_state(const std::filesystem::path& frame) {
  if (auto curved = studies::read_curved_mesh(frame))
    if (curved->fields.contains("order") && curved->fields.contains("mean_curvature"))
      return std::move(*curved);
  throw InputError(fmt::format("{}: is no frame of a run", frame.string()));
}

Eigen::VectorXd field_of(const studies::CurvedFile& state, Field field) {
  const char* name = field == Field::order ? "order" : "mean_curvature";
  return state.fields.at(name).row(0).transpose();
}

Range shown_range(std::vector<double> values, Field field) {
  constexpr double least_width = 0.02;  // relatively: otherwise noise is all that is seen
  std::ranges::sort(values);
  const std::size_t cut = field == Field::curvature ? values.size() / 100 : 0;
  const double low = values[cut], high = values[values.size() - 1 - cut];
  if (field == Field::order) return {low, high};
  const double width = std::max(high - low, least_width * std::max(std::abs(low), std::abs(high)));
  const double middle = 0.5 * (low + high);
  return {middle - 0.5 * width, middle + 0.5 * width};
}

std::string shown_title(Field field, const Options& options) {
  const std::string title = options.titled(title_of(field), dimension_of(field));
  return field == Field::curvature && !options.scale ? title + ", but for 1 % at either end"
                                                     : title;
}

std::string time_title(const FrameEntry& frame, const Options& options) {
  const double time = options.factor(studies::dimension::time) * frame.time;
  return "t = " + short_number(time) + options.unit_after(studies::dimension::time);
}

}  // namespace sbeh::picture
