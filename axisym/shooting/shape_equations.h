// The shape equations of axisymmetric vesicles as initial value problems from a pole.
//
// Seifert, Berndl and Lipowsky, Phys. Rev. A 44 (1991) 1182, with a spontaneous curvature H₀, by arc
// length s: tangent angle ψ (0 at the pole), H = −(ψ' + sin ψ/X), distance X from the axis, depth Z
// below the pole. F/κ + ΣA − PV is 2π ∫ 𝓛 ds, with a multiplier γ for X' = cos ψ,
//   𝓛 = (X/2) (H − H₀)² + Σ X − (P/2) X² sin ψ + γ (X' − cos ψ),
// and stationary where, with c = sin ψ/X,
//   ψ' = −H − c                            H' = −γ c + (P/2) X cos ψ
//   γ' = (H − H₀)²/2 + (H − H₀) c + Σ − P X sin ψ        X' = cos ψ
// H in place of the paper's U = ψ' leaves c as the only term that is singular at the pole, where a
// power series starts the solution. 𝓛 does not contain s, and the length of the curve is free, so
//   h = (X/2) (H² − H₀²) + (H − H₀) sin ψ − Σ X + (P/2) X² sin ψ + γ cos ψ
// is 0 all along.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace sbeh::axisym::shooting {

struct Options {
  double tolerance = 1e-13;  ///< of an integration step, absolute and relative; [1e-15, 1e-8]
  double series_start =
      1e-3;       ///< arc length that the series covers, with an error O(s⁶); (0, 0.01]
  double H0 = 0;  ///< spontaneous curvature of the shapes, R = 1
};
/// Throws std::invalid_argument with name, value and range.
void validate(const Options& options);

/// What determines the solution that is regular at a pole.
struct Pole {
  double H;         ///< trace H at the pole, −2 on the unit sphere
  double tension;   ///< Σ R²/κ
  double pressure;  ///< P R³/κ
};

/// Rows of a state. Area, volume and energy F/(8πκ) are of the part between the pole and here.
struct Row {
  enum : int { psi, H, X, gamma, Z, area, volume, energy, count };
};
using State = Eigen::Matrix<double, Row::count, 1>;

struct End {
  State state;
  Eigen::Matrix<double, Row::count, 4> rates;  // by H, tension, pressure of the pole and arc length
};

/// The equations and their variational equations by Runge-Kutta-Fehlberg 7(8) with error control;
/// nothing if the solution becomes singular before.
std::optional<End> integrate(const Pole& pole, double arc_length, const Options& options = {});

/// States at intervals + 1 equal distances from the pole to the arc length, which `integrate` reaches.
Eigen::Matrix<double, Row::count, Eigen::Dynamic> sample(const Pole& pole, double arc_length,
                                                         int intervals,
                                                         const Options& options = {});

}  // namespace sbeh::axisym::shooting
