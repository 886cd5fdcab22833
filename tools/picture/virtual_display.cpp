#include "tools/picture/virtual_display.h"

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

}  // namespace

void ensure_display(char** arguments) {
  const char* display = std::getenv("DISPLAY");
  if (display && *display) return;
  const std::runtime_error missing(
      "There is no display and no virtual one can be started: install the Debian packages xvfb and "
      "xauth, or set DISPLAY.");
  if (!is_installed("xvfb-run") || !is_installed("xauth")) throw missing;

  std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  std::vector<std::string> words{"xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", self};
  std::vector<char*> command;
  for (auto& word : words) command.push_back(word.data());
  for (char** argument = arguments + 1; *argument; ++argument) command.push_back(*argument);
  command.push_back(nullptr);
  execvp("xvfb-run", command.data());
  throw missing;
}

}  // namespace sbeh::picture
