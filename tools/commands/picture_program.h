// The program that draws, beside this one.
#pragma once

#include <string>
#include <vector>

namespace sbeh::tools {

/// Runs sbeh-picture with these arguments; its exit code, 127 when it cannot be started.
int draw(const std::vector<std::string>& arguments);

}  // namespace sbeh::tools
