// How fast a small perturbation grows or decays, from its amplitude over time.
#pragma once

#include <optional>
#include <vector>

namespace sbeh::studies {

struct AmplitudeAt {
  double time, amplitude;  ///< amplitude >= 0
};

/// d(ln amplitude)/dt by least squares over a window.
struct GrowthRate {
  double rate = 0;
  double error = 0;         ///< half the range of the rates over the thirds of the window
  double from = 0, to = 0;  ///< the window
};

/// Amplitudes that are still small enough for the linear regime, and large enough to be more than noise:
/// both as multiples of the first one.
inline constexpr double most_growth = 3, most_decay = 0.2;

/// The window ends where the amplitude leaves the linear regime, or with the history, and begins at 0,
/// 1/16, 1/8, 1/4 or 1/2 of that time, wherever the rates over the thirds of the window agree best: what is
/// left of faster modes decays first. Times ascending. Empty where fewer than four amplitudes would be in a
/// third, or the first is 0.
std::optional<GrowthRate> fit_growth(const std::vector<AmplitudeAt>& history);

}  // namespace sbeh::studies
