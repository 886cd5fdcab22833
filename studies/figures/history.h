// A quantity over time, as the findings look at it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sbeh::studies::figures {

struct History {
  std::vector<double> time, value;    // ascending times
  bool ended = true, at_rest = true;  ///< what it is at its end

  bool empty() const { return time.empty(); }
  double last() const { return value.back(); }
  double end() const { return time.back(); }

  /// Linear between the times, constant beyond them.
  double at(double t) const {
    const auto after = std::lower_bound(time.begin(), time.end(), t);
    if (after == time.begin()) return value.front();
    if (after == time.end()) return value.back();
    const auto i = std::size_t(after - time.begin());
    const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
    return value[i - 1] + share * (value[i] - value[i - 1]);
  }

  /// From one time to the next; <= 0 where the quantity only falls.
  double largest_rise() const {
    double largest = -HUGE_VAL;
    for (std::size_t i = 1; i < value.size(); ++i)
      largest = std::max(largest, value[i] - value[i - 1]);
    return largest;
  }

  /// Index of the largest (smallest) value in this span of time; size() when it is empty.
  std::size_t largest(double from, double to) const { return extreme(from, to, 1); }
  std::size_t smallest(double from, double to) const { return extreme(from, to, -1); }
  std::size_t size() const { return time.size(); }

 private:
  std::size_t extreme(double from, double to, double sign) const {
    std::size_t best = size();
    for (std::size_t i = 0; i < size(); ++i)
      if (time[i] >= from && time[i] <= to
          && (best == size() || sign * value[i] > sign * value[best]))
        best = i;
    return best;
  }
};

}  // namespace sbeh::studies::figures
