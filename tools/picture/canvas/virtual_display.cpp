#include "tools/picture/canvas/virtual_display.h"

#include <X11/Xlib.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace sbeh::picture {
namespace {

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

// The connection stays open until the program ends: a virtual server resets itself when its last
// client leaves, and VTK's next connection could meet it in that moment.
bool is_display_usable() {
  static const Display* connection = XOpenDisplay(nullptr);
  return connection != nullptr;
}

}  // namespace

void ensure_display(char** arguments) {
  if (is_display_usable()) return;
  const std::runtime_error missing(
      "There is no display and no virtual one can be started: install the Debian packages xvfb and "
      "xauth, or set DISPLAY to one that can be reached.");
  constexpr const char* already_tried = "SBEH_PICTURE_VIRTUAL_DISPLAY";
  if (std::getenv(already_tried) || !is_installed("xvfb-run") || !is_installed("xauth"))
    throw missing;

  // A server that resets itself sends xvfb-run the signal of a new one, which then may fail while it cleans up.
  std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> words{"xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", self};
  std::vector<char*> command;
  for (auto& word : words) command.push_back(word.data());
  for (char** argument = arguments + 1; *argument; ++argument) command.push_back(*argument);
  command.push_back(nullptr);
  setenv(already_tried, "1", 1);
  execvp("xvfb-run", command.data());
  throw missing;
}

}  // namespace sbeh::picture
