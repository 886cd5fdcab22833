// What one method of a comparison finds: a stationary state, measured in the terms of all of them.
#pragma once

#include "axisym/stationary/stationary_case.h"
#include "meshing/curved_mesh.h"
#include "studies/io/csv.h"
#include "studies/io/errors.h"
#include "studies/states/meridian.h"
#include "studies/witnesses/witness.h"
#include "surface3d/harmonic/minimiser.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// The numbers that are compared; `not_known` where the method does not tell. Lengths in radii of the
/// sphere of equal area.
struct Measures {
  double energy = not_known;  ///< U
  /// Of model::Energy, the Gaussian part in the bending.
  double energy_distortion = not_known, energy_bending = not_known, energy_thermotropic = not_known;
  /// P = ∂U/∂V at fixed area; of flow and surface3d: −λ.
  double pressure = not_known;
  /// Σ = −∂U/∂A at fixed volume; of flow and surface3d: if H₀ = 0, from P, as scaling wants it,
  /// 2ΣA = 3PV − 2(thermotropic energy).
  double tension = not_known;
  double order_min = not_known, order_mean = not_known, order_max = not_known;
  double H_pole = not_known;  ///< trace H at the pole where it is larger
};

struct Quantity {
  const char* name;
  double Measures::*value;
  bool is_energy;  ///< differences are taken relative to the total energy
};
const std::vector<Quantity>& quantities();

/// The energy of an evolution at a time.
struct EnergyAt {
  double time, energy;
};

struct WitnessState {
  Witness witness{};
  std::string failure{};  ///< why there is no state; empty where there is one
  std::string remark{};   ///< what else is to be known
  double seconds = 0;
  Measures measures{};
  Eigen::Matrix2Xd points{};        // 2 x n: r, z; along the meridian, or nodes of a 3D method
  Eigen::VectorXd order{};          // n
  std::vector<EnergyAt> history{};  ///< of flow and surface3d from the same ellipsoid
  std::optional<axisym::State> profile{};     ///< of newton
  std::optional<meshing::CurvedMesh> mesh{};  ///< of surface3d and states
  std::optional<Meridian> meridian{};  ///< through the points, from the pole of H_pole on, z = 0
                                       ///< halfway between the poles; none of the 3D methods
};

/// Newton's method from the branch's entry on.
WitnessState newton_state(const axisym::StationaryCase& of);

/// Boost.Odeint on the shape equations. SSH without spontaneous curvature.
WitnessState shooting_state(const axisym::StationaryCase& of);

/// Spectral minimisation; of SSH without spontaneous curvature.
WitnessState minimiser_state(const axisym::StationaryCase& of);

/// The axisymmetric solver's flow from the ellipsoid of full order to rest, with its energies at these times.
/// Throws Interrupted.
WitnessState flow_state(const axisym::StationaryCase& of, const std::vector<double>& times);

/// When flow and surface3d tell their energies: nine times from 0.001 to 10, or those of the rows of the
/// run whose frame is taken.
std::vector<double> history_times(const SurfaceMethod& method);

/// Without the tension and H_pole.
template <class Diagnostics>
Measures measures_of(const model::Energy& energy, const Diagnostics& d, double pressure) {
  return {.energy = energy.total(),
          .energy_distortion = energy.distortion,
          .energy_bending = energy.bending,
          .energy_thermotropic = energy.thermotropic,
          .pressure = pressure,
          .order_min = d.order_min,
          .order_mean = d.order_mean,
          .order_max = d.order_max};
}

/// Of a state at rest in a flow, with its volume multiplier.
template <class Diagnostics>
Measures measures_of_flow(const model::Material& material, const Diagnostics& d, double lambda) {
  Measures of = measures_of(d.energy, d, -lambda);
  if (material.spontaneous_curvature == 0 && material.flexoelectric.vanishes()
      && !material.has_lipid_density())
    of.tension = (3 * of.pressure * d.volume - 2 * d.energy.thermotropic) / (2 * d.area);
  return of;
}

/// The 3D solver's flow to rest, or the last frame of a run. Where the method asks for it a profile is
/// revolved; null: that of newton_state. The surface is turned with its axis upright, its centre in the origin. `keep`, unless empty,
/// is where the state goes as a frame. Throws InputError (a run that is none, or is one of another
/// case), OutputError, and Interrupted.
WitnessState surface_state(const axisym::StationaryCase& of, const SurfaceMethod& method,
                           const axisym::State* profile, const std::filesystem::path& keep);

/// Newton's method in 3D from a profile, revolved with about so many triangles; null: that of newton_state. Turned as surface_state.
WitnessState rest_state(const axisym::StationaryCase& of, int triangles,
                        const axisym::State* profile);

/// A classical shape in the terms of U: full order, u(2/3) everywhere, and the Gaussian part; energy is
/// F/(8πκ), pressure and tension are per κ. SSH without spontaneous curvature.
Measures classical_measures(const model::Material& material, double energy, double pressure,
                            double tension);

/// Minimisation over spherical harmonics, from the 3D solver's surface or else a spheroid; turned like it.
WitnessState harmonic_state(const axisym::StationaryCase& of, const HarmonicMethod& method,
                            const meshing::CurvedMesh* start);

/// Whether a classical shape is a saddle among all surfaces, by the same minimisation from a spheroid. Empty
/// unless the case is one of SSH without spontaneous curvature, V_r >= 0.65, where the harmonics resolve it.
std::optional<surface3d::HarmonicState> classical_saddle(const axisym::StationaryCase& of);

}  // namespace sbeh::studies
