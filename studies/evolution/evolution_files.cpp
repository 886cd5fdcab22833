#include "studies/evolution/evolution_files.h"

namespace sbeh::studies {

const Columns<FrameEntry>& frame_columns() {
  static const Columns<FrameEntry> columns{
      column("index", &FrameEntry::index),
      column("time", &FrameEntry::time),
      column("file", &FrameEntry::file),
  };
  return columns;
}

StateFiles::StateFiles(const OutputFolder& folder, std::string kind, std::string extension,
                       const std::vector<double>& times, double until)
    : folder_(folder),
      kind_(std::move(kind)),
      extension_(std::move(extension)),
      times_(times),
      table_(folder / (kind_ + ".csv"), header_of(frame_columns()), until),
      entries_(rows_of(frame_columns(), table_.kept())) {
  make_folder(folder / kind_);
  if (!entries_.empty()) write_index();
}

bool StateFiles::see(double time, bool exact, const Write& write) {
  const bool due = exact && contains(times_, time);
  if (due) add(time, write);
  return due;
}

void StateFiles::finish(double time, const Write& write) {
  if (time != table_.last_time()) add(time, write);
}

// The file before its row: a row without a file would lead nowhere.
void StateFiles::add(double time, const Write& write) {
  const std::string file = fmt::format("{}/{:04d}{}", kind_, entries_.size(), extension_);
  write(folder_ / file);
  entries_.push_back({time, file, int(entries_.size())});
  table_.append(time, line_of(frame_columns(), entries_.back()));
  write_index();
}

void StateFiles::write_index() const {
  if (extension_ != ".vtu") return;
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const FrameEntry& frame : entries_)
    text +=
        fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time, frame.file);
  write_file(folder_ / "run.pvd", text + "</Collection>\n</VTKFile>\n");
}

}  // namespace sbeh::studies
