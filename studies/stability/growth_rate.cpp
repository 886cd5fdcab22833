#include "studies/stability/growth_rate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace sbeh::studies {

namespace {

constexpr std::size_t fewest = 4;  // amplitudes in a third of the window

using History = std::span<const AmplitudeAt>;

History between(History history, double from, double to) {
  const auto earlier = [](const AmplitudeAt& at, double time) { return at.time < time; };
  const auto first = std::lower_bound(history.begin(), history.end(), from, earlier);
  const auto last =
      std::upper_bound(history.begin(), history.end(), to,
                       [](double time, const AmplitudeAt& at) { return time < at.time; });
  return {first, last};
}

// Slope of ln amplitude; each point stands for the time to its neighbours, so that many small steps do not
// outweigh few large ones.
double slope(History history) {
  const auto weight = [&](std::size_t i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, history.size() - 1);
    return history[after].time - history[before].time;
  };
  double total = 0, time = 0, value = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    total += weight(i);
    time += weight(i) * history[i].time;
    value += weight(i) * std::log(history[i].amplitude);
  }
  time /= total;
  value /= total;
  double covariance = 0, variance = 0;
  for (std::size_t i = 0; i < history.size(); ++i) {
    const double t = history[i].time - time;
    covariance += weight(i) * t * (std::log(history[i].amplitude) - value);
    variance += weight(i) * t * t;
  }
  return covariance / variance;
}

// Of the window [from, to]; empty where there are too few amplitudes.
std::optional<GrowthRate> fit(History history, double from, double to) {
  std::array<double, 3> thirds{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double third = (to - from) / 3;
    const History part = between(history, from + double(k) * third, from + double(k + 1) * third);
    if (part.size() < fewest) return {};
    thirds[k] = slope(part);
  }
  const auto [least, largest] = std::minmax_element(thirds.begin(), thirds.end());
  return GrowthRate{.rate = slope(between(history, from, to)),
                    .error = (*largest - *least) / 2,
                    .from = from,
                    .to = to};
}

}  // namespace

std::optional<GrowthRate> fit_growth(const std::vector<AmplitudeAt>& history) {
  if (history.empty() || !(history.front().amplitude > 0)) return {};
  const double start = history.front().amplitude;
  const auto beyond = std::find_if(history.begin(), history.end(), [&](const AmplitudeAt& at) {
    return at.amplitude > most_growth * start || !(at.amplitude > most_decay * start);
  });
  const History linear(history.begin(), beyond);
  const double begin = linear.front().time, end = linear.back().time;
  std::optional<GrowthRate> best;
  for (const double share : {0., 1. / 16, 1. / 8, 1. / 4, 1. / 2}) {
    const auto rate = fit(linear, begin + share * (end - begin), end);
    if (rate && (!best || rate->error < best->error)) best = rate;
  }
  return best;
}

}  // namespace sbeh::studies
