// VTK needs an X server even to render into memory: without one the program starts itself again
// under a virtual one.
#pragma once

namespace sbeh::picture {

/// Returns if the display that DISPLAY names can be reached. Otherwise replaces this process by itself under xvfb-run, or throws
/// std::runtime_error that says what to install.
void ensure_display(char** arguments);

}  // namespace sbeh::picture
