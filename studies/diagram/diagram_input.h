// Which of the classical phase diagrams is asked for, and how finely.
#pragma once

#include "axisym/options.h"
#include "axisym/stationary/line.h"
#include "model/names.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// What is given on the second axis, beside V_r: H₀ (Seifert, Berndl, Lipowsky, Phys. Rev. A 44, 1182, 1991); W₂ = ∫H dS,
/// the same, "bilayer coupling"; or W₂⁰ of an area difference with a finite stiffness (Miao, Seifert, Wortis,
/// Döbereiner, Phys. Rev. E 49, 5389, 1994).
enum class DiagramKind { spontaneous_curvature, bilayer_coupling, area_difference };
constexpr auto names(DiagramKind) {
  return std::array{"spontaneous-curvature", "bilayer-coupling", "area-difference"};
}

/// Table [diagram], all keys as the members. SSH, κ = 1, lengths in radii of the sphere of equal area.
struct DiagramInput {
  DiagramKind kind = DiagramKind::spontaneous_curvature;
  /// On the second axis, ascending: the reduced c₀ = −H₀, or Δa = −W₂/8π, or Δa₀ = −W₂⁰/8π; of the sphere Δa = 1.
  std::vector<double> values;
  double stiffness_ratio = 1.4;  ///< α = k_ad/κ > 0, of area-difference alone
  double least_volume = 0.3;     ///< branches are followed down to this V_r
  int modes = 4;                 ///< m up to which modes are looked at, 0 … 6
  int elements = 48;

  axisym::Numerics numerics() const;
  /// Of one value: with κ = 1, without a potential.
  model::Material material(double value) const;
  /// From V_r = 0.99 down to least_volume.
  axisym::Line line(double value) const;

  bool operator==(const DiagramInput&) const = default;
};

/// Those of the whole diagram: so many from end to end of what is usually drawn.
std::vector<double> usual_values(DiagramKind kind, int count = 51);

/// Throws InputError.
DiagramInput read_diagram(const std::filesystem::path& path);

/// The whole input, as that of a scan (scan_input.h).
std::string describe(const DiagramInput& input, std::string_view version);

}  // namespace sbeh::studies
