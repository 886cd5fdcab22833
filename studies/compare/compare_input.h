// What a comparison is asked for: one case, the methods that compute it, and how well they must agree.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/options.h"
#include "model/material.h"
#include "surface3d/options.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// A way to a stationary state.
enum class Witness {
  newton,     ///< Newton's method on finite elements of the generating curve
  shooting,   ///< shape equations by Boost.Odeint; SSH without spontaneous curvature
  minimiser,  ///< spectral curves, Ceres and Newton; SBEH, or SSH without spontaneous curvature
  flow,       ///< the axisymmetric solver, in time from an ellipsoid to rest
  surface3d,  ///< the 3D solver, in time, to rest
  harmonics   ///< spherical harmonics without an axis, Ceres and Newton; SSH, V_r >= 0.65
};
constexpr auto values_of(Witness) {
  return std::array{Witness::newton, Witness::shooting,  Witness::minimiser,
                    Witness::flow,   Witness::surface3d, Witness::harmonics};
}
/// "newton", "shooting", "minimiser", "flow", "surface3d" or "harmonics".
const char* name(Witness witness);

/// The 3D method: table [surface3d].
struct SurfaceMethod {
  std::string run;        ///< folder of a run (sbeh run), whose last frame is taken; or empty
  bool revolved = false;  ///< key `start`: "ellipsoid" of full order, or "revolved": Newton's state
  int triangles = 320;    ///< about so many
  double end_time = 20;   ///< key `end`, > 0: a flow that is not at rest ends here
  surface3d::Numerics numerics;  ///< keys `tolerance` (1e-3) and `rest_speed` (1e-5)
  SurfaceMethod();

  bool operator==(const SurfaceMethod&) const = default;
};

/// The 3D minimiser: table [harmonics].
struct HarmonicMethod {
  int degree = 16;  ///< largest l, 8 <= degree <= 24

  bool operator==(const HarmonicMethod&) const = default;
};

/// Largest differences allowed, by the names of tolerated_quantities(). Energies are relative to the
/// total energy, all others as they are.
using Tolerances = std::map<std::string, double>;
/// The quantities that are compared: those of witness_state.h, "distance" of the profiles, and "history"
/// of the energy, which flow and surface3d have.
std::vector<std::string> tolerated_quantities();

/// Table [compare]: model, branch, reduced_volume, L, methods; optional [material] (without L),
/// [numerics] (of newton), [surface3d], [harmonics], [tolerance] (pairs of axisymmetric methods) and
/// [tolerance_3d] (pairs with surface3d or harmonics).
struct CompareInput {
  model::Model model = model::Model::SBEH;  ///< SBEH or SSH
  axisym::Branch branch = axisym::Branch::oblate;
  double reduced_volume = 0;     ///< 0 < V_r < 1
  double L = 0;                  ///< > 0, one-constant elastic constant
  std::vector<Witness> methods;  ///< two at least; the first is the reference
  model::Material material;      ///< with this L
  axisym::Numerics numerics;
  SurfaceMethod surface3d;
  HarmonicMethod harmonics;
  Tolerances tolerance, tolerance_3d;

  bool has(Witness witness) const;

  bool operator==(const CompareInput&) const = default;
};

/// Throws InputError.
CompareInput read_compare(const std::filesystem::path& path);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const CompareInput& input, std::string_view version);

}  // namespace sbeh::studies
