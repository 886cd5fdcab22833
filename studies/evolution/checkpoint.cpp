#include "studies/evolution/checkpoint.h"

#include "studies/io/errors.h"
#include "studies/io/output.h"

#include <fmt/format.h>

namespace sbeh::studies {

Checkpoint::Checkpoint(std::filesystem::path file, double minutes, ProgressLine& line)
    : file_(std::move(file)), minutes_(minutes), line_(line) {
  put_off();
}

void Checkpoint::see(const Moment& moment) {
  using Minutes = std::chrono::duration<double, std::ratio<60>>;
  if (Minutes(std::chrono::steady_clock::now() - kept_).count() < minutes_) return;
  try {
    write(moment);
  } catch (const OutputError& error) {
    line_.say(fmt::format("sbeh: {}; the run goes on without this checkpoint", error.what()));
  }
  put_off();
}

void Checkpoint::remove() const { remove_file(file_); }

}  // namespace sbeh::studies
