// How far a surface is from one of revolution about z, mode by mode, and how fast a small perturbation grows or
// decays.
#pragma once

#include "model/names.h"
#include "surface3d/surface.h"

#include <optional>
#include <vector>

namespace sbeh::studies {

/// √(q_lm² + q_l−m²) with q_lm = ∫ r^l Y_lm dS / ∫ r^l dS, r and Y_lm about the centre of area, m >= 1: 0 for a
/// surface of revolution about z, and the same when the surface is turned about z. A small normal
/// displacement of order m changes it to first order; others, to second. With m = 1 and odd l >= 3 a small turn
/// of a surface that is symmetric top to bottom does not change it.
double mode_amplitude(const surface3d::Triangulation& mesh, const surface3d::Nodes& X, int l,
                      int m);

/// What kind of body the principal second moments of the surface make it.
enum class Roundness {
  oblate,   ///< two large ones are equal
  prolate,  ///< two small ones are equal
  triaxial  ///< no two
};
constexpr auto names(Roundness) { return std::array{"oblate", "prolate", "triaxial"}; }
/// Two moments count as equal when they differ by less than 5 % of the range of all three.
Roundness roundness_of(const surface3d::Triangulation& mesh, const surface3d::Nodes& X);

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
/// In each third of a window.
inline constexpr std::size_t fewest_amplitudes = 4;

/// The window ends where the amplitude leaves the linear regime, or with the history, and begins when other modes have
/// decayed, at `settled`. Where that is not known, or too late, it begins at 0, 1/16, 1/8, 1/4 or 1/2 of its end,
/// wherever the rates over the thirds of the window agree best. Times ascending. Empty where fewer
/// amplitudes would be in a third, or the first is 0.
std::optional<GrowthRate> fit_growth(const std::vector<AmplitudeAt>& history,
                                     std::optional<double> settled = {});

}  // namespace sbeh::studies
