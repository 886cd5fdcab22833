#include "studies/io/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <mutex>

namespace sbeh::studies {

namespace {
struct Listener {
  std::mutex mutex;
  std::function<void(std::string_view)> hear;
  bool terminal = false;
};
Listener& listener() {
  static Listener one;
  return one;
}
bool tells_a_terminal() {
  return listener().hear ? listener().terminal : isatty(STDERR_FILENO) != 0;
}
}  // namespace

void tell_to(std::function<void(std::string_view)> hear, bool terminal) {
  const std::lock_guard lock(listener().mutex);
  listener().hear = std::move(hear);
  listener().terminal = terminal;
}

void tell(std::string_view text) {
  if (listener().hear) {
    const std::lock_guard lock(listener().mutex);
    listener().hear(text);
    return;
  }
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

ProgressLine::ProgressLine() : terminal_(tells_a_terminal()) {}

ProgressLine::~ProgressLine() { end(); }

double ProgressLine::age() const {
  return shown_ ? shown_->seconds() : std::numeric_limits<double>::infinity();
}

void ProgressLine::show(std::string_view text) {
  tell(fmt::format("{}{}{}", terminal_ ? "\r\033[K" : "", text, terminal_ ? "" : "\n"));
  open_ = terminal_;
  shown_.emplace();
}

void ProgressLine::say(std::string_view message) {
  tell(fmt::format("{}{}\n", terminal_ ? "\r\033[K" : "", message));
  open_ = false;
}

void ProgressLine::end() {
  if (open_) tell("\n");
  open_ = false;
}

Progress::Progress(std::string_view unit, int total, int done)
    : unit_(unit), total_(total), done_(done), before_(done) {
  if (done > 0) say(fmt::format("{} of {} {} are there from before", done, total, unit));
}

void Progress::advance() {
  ++done_;
  if (due()) show();
}

bool Progress::due() const {
  if (done_ == total_) return true;
  if (line_.on_terminal()) return line_.age() > 0.1;
  return 10 * done_ / total_ > shown_tenths_ && line_.age() > 1;
}

void Progress::show() {
  const double rate = (done_ - before_) / std::max(watch_.seconds(), 1e-9);
  shown_tenths_ = 10 * done_ / total_;
  line_.show(fmt::format("{}/{} {}, {:.3g} per second, {:.0f} s left", done_, total_, unit_, rate,
                         (total_ - done_) / std::max(rate, 1e-9)));
}

}  // namespace sbeh::studies
