#include "studies/io/interrupt.h"

#include <csignal>

namespace sbeh::studies {

namespace {
volatile std::sig_atomic_t received = 0;
}

void catch_interrupts() {
  const auto remember = [](int signal) { received = signal; };
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

void let_writes_fail() { std::signal(SIGXFSZ, SIG_IGN); }

int interrupt_signal() { return received; }

}  // namespace sbeh::studies
