#include "axisym/domains.h"

#include <cmath>
#include <numbers>

namespace sbeh::axisym {

model::Domains domains_of(const State& state) {
  model::Domains domains;
  const double low = state.beta.minCoeff(), high = state.beta.maxCoeff();
  if (high - low < model::Domains::least_contrast) return domains;
  const Field height = state.beta.array() - (low + high) / 2;
  if (height[0] > 0) ++domains.count;
  for (Eigen::Index i = 0; i + 1 < height.size(); ++i) {
    const auto from = state.X.col(i), to = state.X.col(i + 1);
    const double length = (to - from).norm();
    // Of the cone between two places, as shares of the way.
    const auto area = [&](double begin, double end) {
      const double r = from[0] + (begin + end) / 2 * (to[0] - from[0]);
      return 2 * std::numbers::pi * r * (end - begin) * length;
    };
    const bool begins = height[i] > 0, ends = height[i + 1] > 0;
    if (begins && ends) domains.area += area(0, 1);
    if (begins == ends) continue;
    const double cut = height[i] / (height[i] - height[i + 1]);
    domains.area += begins ? area(0, cut) : area(cut, 1);
    domains.boundary += 2 * std::numbers::pi * (from[0] + cut * (to[0] - from[0]));
    if (ends) ++domains.count;
  }
  return domains;
}

std::vector<Interface> interfaces(const State& state) {
  std::vector<Interface> found;
  const double low = state.beta.minCoeff(), high = state.beta.maxCoeff();
  if (high - low < model::Domains::least_contrast) return found;
  const Field height = state.beta.array() - (low + high) / 2;
  for (Eigen::Index i = 0; i + 1 < height.size(); ++i) {
    if ((height[i] > 0) == (height[i + 1] > 0)) continue;
    const double step = std::abs(height[i + 1] - height[i]),
                 length = (state.X.col(i + 1) - state.X.col(i)).norm();
    found.push_back({double(i) + std::abs(height[i]) / step, (high - low) / 2 * length / step});
  }
  return found;
}

}  // namespace sbeh::axisym
