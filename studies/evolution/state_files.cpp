#include "studies/evolution/state_files.h"

#include "studies/evolution/times.h"

#include <fmt/format.h>

namespace sbeh::studies {

StateFiles::StateFiles(const OutputFolder& folder, std::string kind, std::string extension,
                       const std::vector<double>& times, double until)
    : folder_(folder),
      kind_(std::move(kind)),
      extension_(std::move(extension)),
      times_(times),
      index_(folder / (kind_ + ".csv"), header_of(frame_columns()), until),
      entries_(rows_of(frame_columns(), index_.kept())) {
  make_folder(folder / kind_);
}

bool StateFiles::see(double time, bool exact, const Write& write) {
  const bool due = exact && contains(times_, time);
  if (due) add(time, write);
  return due;
}

bool StateFiles::finish(double time, const Write& write) {
  const bool missing = time != index_.last_time();
  if (missing) add(time, write);
  return missing;
}

// The file before its row: a row without a file would lead nowhere.
void StateFiles::add(double time, const Write& write) {
  const std::string file = fmt::format("{}/{:04d}{}", kind_, entries_.size(), extension_);
  write(folder_ / file);
  entries_.push_back({time, file, int(entries_.size())});
  index_.append(time, line_of(frame_columns(), entries_.back()));
}

}  // namespace sbeh::studies
