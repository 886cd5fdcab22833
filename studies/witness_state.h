// What one method of a comparison finds: a stationary state, measured in the terms of all of them.
#pragma once

#include "studies/compare_input.h"
#include "studies/meridian.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// The numbers that are compared; `not_known` where the method does not tell. Lengths in radii of the
/// sphere of equal area.
struct Measures {
  double energy = not_known;  ///< U
  double energy_distortion = not_known, energy_bending = not_known,
         energy_thermotropic = not_known;  ///< of model::Energy: the Gaussian part in the bending
  double pressure = not_known;             ///< P = ∂U/∂V at fixed area; −λ of the flow
  double tension = not_known;  ///< Σ = −∂U/∂A at fixed volume; of surface3d: from the pressure, as
      ///< scaling wants it, 2ΣA = 3PV − 2(thermotropic energy), if H₀ = 0
  double order_min = not_known, order_mean = not_known, order_max = not_known;
  double H_pole = not_known;  ///< trace H at the pole where it is larger
};

struct Quantity {
  const char* name;
  double Measures::*value;
  bool is_energy;  ///< differences are taken relative to the total energy
};
const std::vector<Quantity>& quantities();

struct WitnessState {
  Witness witness{};
  std::string failure{};  ///< why there is no state; empty where there is one
  std::string remark{};   ///< what else is to be known
  double seconds = 0;
  Measures measures{};
  Eigen::Matrix2Xd points{};           // 2 x n: r, z; along the meridian, or all nodes of surface3d
  Eigen::VectorXd order{};             // n
  std::optional<Meridian> meridian{};  ///< through the points, from the pole of H_pole on, z = 0
                                       ///< halfway between the poles; none of surface3d
};

/// Newton's method from the branch's entry on; the state, or the reason why there is none.
struct NewtonState {
  std::optional<axisym::State> state;
  WitnessState found;
};
NewtonState newton_state(const CompareInput& input);

/// Boost.Odeint on the shape equations. SSH without spontaneous curvature.
WitnessState shooting_state(const CompareInput& input);

/// Spectral minimisation; of SSH without spontaneous curvature.
WitnessState minimiser_state(const CompareInput& input);

/// The 3D solver's flow to rest, or the last frame of a run. `start` is revolved where the input asks
/// for it. The surface is turned with its axis upright, its centre in the origin. `keep`, unless empty,
/// is where the state goes as a frame. Throws InputError (a run that is none, or is one of another
/// case), OutputError, and Interrupted.
WitnessState surface_state(const CompareInput& input, const std::optional<axisym::State>& start,
                           const std::filesystem::path& keep);

/// A signal came while a method was at work.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace sbeh::studies
