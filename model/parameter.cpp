#include "model/parameter.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sbeh::model {

bool Interval::contains(double value) const {
  return (low_open ? value > low : value >= low) && value <= high;
}

std::string Interval::text() const {
  std::string below = std::isfinite(high) ? fmt::format("<= {}", high) : "";
  if (!std::isfinite(low)) return below;
  return fmt::format("{} {}{}{}", low_open ? ">" : ">=", low, below.empty() ? "" : " and ", below);
}

void check(const Parameter& parameter, double value) {
  const Interval& allowed = parameter.allowed;
  if (std::isfinite(value) && allowed.contains(value)) return;
  const bool low = std::isfinite(allowed.low), high = std::isfinite(allowed.high);
  throw std::invalid_argument(fmt::format(
      "{} = {}: must be {}", parameter.name, value,
      low && high && !allowed.low_open ? fmt::format("in {} ... {}", allowed.low, allowed.high)
      : low || high                    ? allowed.text()
                                       : "finite"));
}

}  // namespace sbeh::model
