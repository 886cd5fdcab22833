#include "studies/scan/mode_columns.h"

#include <fmt/ranges.h>

#include <sstream>

namespace sbeh::studies {

using axisym::Stability3d;

std::string text_of_modes(const Stability3d& modes) {
  if (!modes.negative_directions) return "";
  return modes.unstable.empty() ? "none" : fmt::format("{}", fmt::join(modes.unstable, " "));
}

bool read_unstable_modes(const std::string& field, Stability3d& modes) {
  modes.unstable.clear();
  if (field == "none") return true;
  std::istringstream numbers(field);
  for (int m = 0; numbers >> m;) modes.unstable.push_back(m);
  return numbers.eof();
}

}  // namespace sbeh::studies
