// Ranges of numbers: what an input allows, and values spread over one.
#pragma once

#include "model/parameter.h"

#include <vector>

namespace sbeh::studies {

using model::above;
using model::at_least;
using model::between;
using model::Interval;
inline constexpr Interval reduced_volumes{.low = 0, .high = 1, .low_open = true};

enum class Spacing { linear, logarithmic };

/// `count` >= 1 values from `low` to `high`: the ends exact, those between rounded to 12 digits.
/// Logarithmic: equal ratios, `low` > 0. count = 1: just `low`.
std::vector<double> evenly_spaced(double low, double high, int count, Spacing spacing);

}  // namespace sbeh::studies
