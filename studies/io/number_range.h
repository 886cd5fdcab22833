// Ranges of numbers: what an input allows, and values spread over one.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace sbeh::studies {

/// The finite numbers that a key of an input allows.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;  ///< low itself is not allowed

  bool contains(double value) const;
  /// As in "must be > 0 and <= 1".
  std::string text() const;
};
constexpr Interval above(double low) { return {.low = low, .low_open = true}; }
constexpr Interval at_least(double low) { return {.low = low}; }
constexpr Interval between(double low, double high) { return {.low = low, .high = high}; }
constexpr Interval reduced_volumes{.low = 0, .high = 1, .low_open = true};

enum class Spacing { linear, logarithmic };

/// `count` >= 1 values from `low` to `high`: the ends exact, those between rounded to 12 digits.
/// Logarithmic: equal ratios, `low` > 0. count = 1: just `low`.
std::vector<double> evenly_spaced(double low, double high, int count, Spacing spacing);

}  // namespace sbeh::studies
