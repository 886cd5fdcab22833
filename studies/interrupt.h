// Ctrl-C and SIGTERM: finish what is at hand, then stop.
#pragma once

namespace sbeh::studies {

/// From now on SIGINT and SIGTERM are remembered instead of ending the program at once.
void catch_interrupts();

/// The signal that came, 0 if none.
int interrupt_signal();

}  // namespace sbeh::studies
