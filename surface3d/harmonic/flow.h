// The evolution of a membrane by spherical harmonics: Boost.Odeint on its coefficients.
#pragma once

#include "surface3d/harmonic/membrane.h"

#include <functional>
#include <vector>

namespace sbeh::surface3d {

struct HarmonicMoment {
  double time = 0;
  HarmonicMembrane membrane{};
  HarmonicMechanics::Measures measures{};
  /// U + ∫ dissipation dt: what the start's energy was, to the error of the steps.
  double energy_before = 0;
  int evaluations = 0;  ///< of the rates so far, a dense solve each
};

enum class HarmonicFlowStop {
  end,          ///< the last time has been reached
  interrupted,  ///< by goes_on
  degenerate,   ///< the surface lost its normal at a point, or no step was small enough
};

struct HarmonicSchedule {
  std::vector<double> times;  ///< > 0, ascending: when the observer is called, besides at the start
  double tolerance = 1e-8;    ///< of the error of a step, in the units of the coefficients
  std::function<bool(double time)> goes_on = [](double) {
    return true;
  };  ///< asked after each step
};

/// From a membrane on, by the steps of Dormand and Prince.
///
/// The steps are explicit: their number grows as the rate of the highest harmonics, about κ degree⁴/4μ, the time of each as degree⁶.
/// Throws std::invalid_argument unless the tolerance is in [1e-12, 1e-3] and the times ascend.
HarmonicFlowStop flow_harmonics(const HarmonicMechanics& mechanics, const HarmonicMembrane& start,
                                const HarmonicSchedule& schedule,
                                const std::function<void(const HarmonicMoment&)>& observe);

}  // namespace sbeh::surface3d
