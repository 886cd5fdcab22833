#include "studies/io/interrupt.h"

#include <csignal>

namespace sbeh::studies {

namespace {
volatile std::sig_atomic_t received = 0;
void remember(int signal) { received = signal; }
}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, remember);
  std::signal(SIGTERM, remember);
}

CaughtInterrupts::CaughtInterrupts()
    : on_interrupt_(std::signal(SIGINT, remember)), on_end_(std::signal(SIGTERM, remember)) {}

CaughtInterrupts::~CaughtInterrupts() {
  std::signal(SIGINT, on_interrupt_);
  std::signal(SIGTERM, on_end_);
  received = 0;
}

void let_writes_fail() { std::signal(SIGXFSZ, SIG_IGN); }

int interrupt_signal() { return received; }

}  // namespace sbeh::studies
