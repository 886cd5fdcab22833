// The values of one parameter as cells along an axis: as a table, or at their own distances.
#pragma once

#include "tools/picture/chart/axis.h"

#include <string>
#include <vector>

namespace sbeh::picture {

struct GridAxis {
  std::vector<double> centres;  ///< in the coordinate of the axis
  std::vector<double> edges;    ///< one more than centres
  Axis axis;                    ///< from the first edge to the last
  std::vector<double> values;   ///< of the parameter at the centres
};

/// One cell of equal size per value, labelled by the value.
GridAxis table_axis(const std::vector<double>& values, const std::string& title);

/// Edges midway between the values; logarithmic if the values are more evenly spaced that way.
GridAxis distance_axis(const std::vector<double>& values, const std::string& title, double length,
                       double spacing);

/// Where a value of the parameter lies between the ends of the axis, 0 to 1: interpolated between the centres
/// and beyond them.
double share_of(const GridAxis& grid, double value);

}  // namespace sbeh::picture
