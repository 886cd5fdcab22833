#include "studies/evolution/frame_writer.h"

namespace sbeh::studies {

FrameWriter::FrameWriter(const OutputFolder& folder, const std::vector<double>& times, double until)
    : folder_(folder), files_(folder, "frames", ".vtu", times, until) {
  if (count() > 0) write_index();
}

bool FrameWriter::see(const Moment& moment, bool exact) {
  const bool due =
      files_.see(moment.record.time, exact, [&](const auto& path) { write_frame(path, moment); });
  if (due) write_index();
  return due;
}

void FrameWriter::finish(const Moment& moment) {
  if (files_.finish(moment.record.time, [&](const auto& path) { write_frame(path, moment); }))
    write_index();
}

void FrameWriter::write_index() const {
  write_file(folder_ / "run.pvd", pvd_text(files_.entries()));
}

}  // namespace sbeh::studies
