#include "studies/io/number_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace sbeh::studies {

std::vector<double> evenly_spaced(double low, double high, int count, Spacing spacing) {
  std::vector<double> values{low};
  for (int i = 1; i < count - 1; ++i) {
    const double s = double(i) / (count - 1);
    const double exact = spacing == Spacing::logarithmic
                           ? std::exp((1 - s) * std::log(low) + s * std::log(high))
                           : (1 - s) * low + s * high;
    const double rounded = std::strtod(fmt::format("{:.11e}", exact).c_str(), nullptr);
    values.push_back(std::clamp(rounded, low, high));
  }
  if (count > 1) values.push_back(high);
  return values;
}

}  // namespace sbeh::studies
