// The axes of a chart: their ranges, ticks and labels.
#pragma once

#include <string>
#include <vector>

namespace sbeh::picture {

/// The range is shown exactly as it is; an axis without title and ticks is not drawn.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::string title;
  std::vector<double> ticks;
  std::vector<std::string> labels;  ///< one per tick, may be empty texts
};

/// Round numbers for ticks about `spacing` pixels apart on an axis of `length` pixels; the range is
/// widened to the next ticks.
Axis linear_axis(double low, double high, double length, double spacing, std::string title = {});

/// The same axis from `low` to `high`, with the ticks that lie there.
Axis cropped(const Axis& axis, double low, double high);

/// For data given as log₁₀: a labelled tick per decade, on shorter axes also at 2 and 5, or at all
/// digits; the ticks between are unlabelled.
Axis decade_axis(double log_low, double log_high, std::string title);

/// A parameter as it is written in a picture: at most four digits.
std::string short_number(double value);
std::string volume_title(double reduced_volume);
std::string length_title(double length);

}  // namespace sbeh::picture
