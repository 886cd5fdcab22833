// Signals. Ctrl-C and SIGTERM: finish what is at hand, then stop.
#pragma once

namespace sbeh::studies {

/// From now on SIGINT and SIGTERM are remembered instead of ending the program at once.
void catch_interrupts();

/// The same while it lives; then signals do again what they did, and those that came are forgotten. For programs that
/// go on afterwards.
class CaughtInterrupts {
 public:
  CaughtInterrupts();
  ~CaughtInterrupts();
  CaughtInterrupts(const CaughtInterrupts&) = delete;
  CaughtInterrupts& operator=(const CaughtInterrupts&) = delete;

 private:
  void (*on_interrupt_)(int);
  void (*on_end_)(int);
};

/// From now on a file that reaches the limit of its size is an error of the write, as a full disk is,
/// instead of the end of the program.
void let_writes_fail();

/// The signal that came, 0 if none.
int interrupt_signal();

}  // namespace sbeh::studies
