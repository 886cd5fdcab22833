// A small chart of lines over the time t as inline SVG, in the colours of the page it stands in.
#pragma once

#include <string>
#include <vector>

namespace sbeh::studies {

struct ChartLine {
  std::string name;
  std::vector<double> x{}, y{};  ///< of equal size
};

enum class AxisScale { linear, logarithmic };

struct ChartFrame {
  std::string title;
  AxisScale x = AxisScale::linear, y = AxisScale::linear;
  std::string y_name{};      ///< beside the axis
  std::string x_name = "t";  ///< the time
};

/// A <figure> with the chart, at most four lines. Points that an axis cannot show (not finite, not
/// positive on a logarithmic one) are left out, on a logarithmic y axis also those 16 decades below
/// the largest value, which are rounding; empty when fewer than two are left in every line.
std::string svg_chart(const ChartFrame& frame, const std::vector<ChartLine>& lines);

struct Chart {
  ChartFrame frame;
  std::vector<ChartLine> lines;
};
/// The charts one after the other, each as svg_chart has it; those whose axes have the same names and scales have the same axes, so that they
/// are compared at a glance.
std::string svg_charts(const std::vector<Chart>& charts);

}  // namespace sbeh::studies
