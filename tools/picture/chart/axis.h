// The axes of a chart: their ranges, ticks and labels; the values of a parameter as cells along one.
#pragma once

#include <string>
#include <vector>

namespace sbeh::picture {

/// The range is shown exactly as it is; an axis without title and ticks is not drawn.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::string title{};
  std::vector<double> ticks{};
  std::vector<std::string> labels{};  ///< one per tick, may be empty texts

  /// Where a value lies: 0 at the lower end, 1 at the upper one.
  double share(double value) const { return (value - low) / (high - low); }
};

/// Round numbers for ticks about `spacing` pixels apart on an axis of `length` pixels; the range is
/// widened to the next ticks.
Axis linear_axis(double low, double high, double length, double spacing, std::string title = {});

/// The same axis from `low` to `high`, with the ticks that lie there.
Axis cropped(const Axis& axis, double low, double high);

/// From `low` to `high` exactly, with round ticks.
Axis exact_axis(double low, double high, double length, double spacing, std::string title = {});

/// For data given as log₁₀: a labelled tick per decade, on shorter axes also at 2 and 5, or at all
/// digits; the ticks between are unlabelled.
Axis decade_axis(double log_low, double log_high, std::string title);

/// The axis with so few of its labels that they do not run together, every second or third say: `extents` are their
/// lengths along the axis of `length` pixels, `gap` what is to be between them.
Axis without_crowd(Axis axis, const std::vector<double>& extents, double length, double gap);

/// Without the ticks that have no labels, where some are nearer to each other than `least` pixels.
Axis without_lesser_ticks(const Axis& axis, double length, double least);

/// A number with the sign of subtraction, which is as wide as a plus.
std::string with_minus(std::string number);

/// A parameter as it is written in a picture: at most four digits.
std::string short_number(double value);
std::string volume_title(double reduced_volume);
std::string length_title(double length);

struct GridAxis {
  std::vector<double> centres;  ///< in the coordinate of the axis
  std::vector<double> edges;    ///< one more than centres
  Axis axis;                    ///< from the first edge to the last
  std::vector<double> values;   ///< of the parameter at the centres
};

/// One cell of equal size per value, labelled by the value.
GridAxis table_axis(const std::vector<double>& values, const std::string& title);

/// From the first value to the last, edges midway between them; logarithmic if the values are more evenly spaced that
/// way.
GridAxis distance_axis(const std::vector<double>& values, const std::string& title, double length,
                       double spacing);

/// Where a value of the parameter lies between the ends of the axis, 0 to 1: interpolated between the centres
/// and beyond them.
double share_of(const GridAxis& grid, double value);

}  // namespace sbeh::picture
