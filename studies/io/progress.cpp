#include "studies/io/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace sbeh::studies {

using std::chrono::duration;
using std::chrono::steady_clock;

void tell(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

Progress::Progress(std::string_view unit, int total, int done)
    : unit_(unit),
      total_(total),
      done_(done),
      before_(done),
      terminal_(isatty(STDERR_FILENO) != 0),
      start_(steady_clock::now()),
      shown_(start_ - std::chrono::hours(1)) {
  if (done > 0) say(fmt::format("{} of {} {} are there from before", done, total, unit));
}

void Progress::advance() {
  ++done_;
  const auto now = steady_clock::now();
  const int tenths = 10 * done_ / total_;
  const bool due =
      terminal_
          ? now - shown_ > std::chrono::milliseconds(100) || done_ == total_
          : done_ == total_ || (tenths > shown_tenths_ && now - shown_ > std::chrono::seconds(1));
  if (!due) return;
  shown_ = now;
  shown_tenths_ = tenths;
  show();
}

void Progress::show() {
  const double seconds = duration<double>(steady_clock::now() - start_).count();
  const double rate = (done_ - before_) / std::max(seconds, 1e-9);
  const std::string line = fmt::format("{}/{} {}, {:.3g} per second, {:.0f} s left", done_, total_,
                                       unit_, rate, (total_ - done_) / std::max(rate, 1e-9));
  tell(fmt::format("{}{}{}", terminal_ ? "\r\033[K" : "", line, terminal_ ? "" : "\n"));
}

void Progress::say(std::string_view message) {
  tell(fmt::format("{}{}\n", terminal_ ? "\r\033[K" : "", message));
}

void Progress::finish() {
  if (terminal_ && done_ > before_) tell("\n");
}

}  // namespace sbeh::studies
