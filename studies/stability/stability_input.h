// What a study of stability in 3D is asked for: which axisymmetric states, how they are perturbed, how long
// they are followed.
#pragma once

#include "meshing/spherical_harmonics.h"
#include "studies/parameters/units.h"
#include "studies/scan/scan_input.h"
#include "surface3d/options.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// How a state is displaced.
enum class StabilityStart {
  harmonic,  ///< along the normal by a Y_lm
  mode  ///< by a times the fastest mode of the flow with this m and the parity of l − m, the order with it
};
constexpr auto names(StabilityStart) { return std::array{"harmonic", "mode"}; }

/// Table [stability]: the grid, V_r < 1, of oblates or prolates, perturbations and start; optional [surface3d]
/// (triangles, coarser, end, largest_step, tolerance), [material] (without L) and [numerics] (of the axisymmetric
/// states).
struct StabilityInput : StateGrid {
  /// a Y_lm, 1 <= m <= l, one run for each; with m = 1 of odd l >= 3, since the others mostly shift or turn the
  /// surface.
  std::vector<meshing::Harmonic> perturbations{{2, 2, 0.01}, {3, 3, 0.01}};
  StabilityStart start = StabilityStart::harmonic;
  int triangles = 320;  ///< about so many
  int coarser =
      0;  ///< about so many for a second run, which tells the error that the mesh makes; 0: none
  double end_time = 20;  ///< key `end`, > 0: a run ends here; in units of 1/κ(2/3), which is 1/(2L)
  surface3d::Numerics
      numerics_3d;  ///< keys `largest_step` (0.1) and `tolerance` (1e-3), in plain units
  StabilityInput();
  std::optional<Units> units{};  ///< for people: no number depends on them

  bool operator==(const StabilityInput&) const = default;
};

/// One run: a state and its perturbation. Ordered as the finished table is.
struct StabilityKey : PointKey {
  int l = 0, m = 0;
  auto operator<=>(const StabilityKey&) const =
      default;  // NOLINT(modernize-use-nullptr): false alarm
};
/// Name of the run's files without ending, such as SBEH_oblate_v0.8_L0.05_Y22.
std::string stem(const StabilityKey& key);

/// All runs, in order. Of SSH only those with the largest L: the shapes do not depend on it, and rates are
/// proportional to it; with residual_stiffness > 0 or κ, κ_G, f that are given that is not so, and all are there.
std::vector<StabilityKey> keys_of(const StabilityInput& input);

/// Of one of these.
meshing::Harmonic perturbation_of(const StabilityInput& input, const StabilityKey& key);

/// Throws InputError.
StabilityInput read_stability(const std::filesystem::path& path);

/// The whole input, as that of a scan (scan_input.h).
std::string describe(const StabilityInput& input, std::string_view version);

}  // namespace sbeh::studies
