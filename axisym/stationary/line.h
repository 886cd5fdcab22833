// Lines in the parameters of stationary states.
#pragma once

#include "axisym/stationary/stationary_case.h"
#include "axisym/time_step.h"
#include "model/numerics/continuation.h"

namespace sbeh::axisym {

/// The target of a stationary state: A = 4π and the volume of this reduced volume.
Target target_of(double reduced_volume);

/// A state on a line.
struct LineState : StationaryState {
  double mu = 0;
};

struct PathState;

/// A straight line in V_r, L, H₀, W₂⁰ and f, μ = 0 at `from`, 1 at `to`, and beyond both.
struct Line {
  using Solution = LineState;
  using Point = PathState;
  static constexpr model::ContinuationLimits limits{
      .most_iterations = 9, .tolerance = 1e-6, .far = 0.3, .fold = 1e-8};

  model::Material material;  ///< but for L, and for H₀, W₂⁰ and f that at `to`
  model::Model model;
  PlanePoint from, to;
  double first_H0 = material.spontaneous_curvature;  ///< at `from`
  double first_W2 = material.area_difference.W2;     ///< W₂⁰, likewise
  double first_coupling = 1;                         ///< f at `from`, as a share of that at `to`
  double first_scale = 1;  ///< all of f, κ, κ_G that are given, likewise
  /// Whether only states are looked for that are symmetric top to bottom: branches that break the symmetry
  /// cross theirs and are not seen.
  bool symmetric = false;

  PlanePoint at(double mu) const;
  Target target(double mu) const { return target_of(at(mu).reduced_volume); }
  model::Material material_at(double mu) const;
  /// The shares at mu of f, and of all that are given.
  double coupling(double mu) const { return first_coupling + mu * (1 - first_coupling); }
  double scale(double mu) const { return first_scale + mu * (1 - first_scale); }
  /// Whether there are states to look for: V_r <= 1, L > 0.
  bool contains(double mu) const { return at(mu).L > 0 && at(mu).reduced_volume <= 1; }

  double volume_rate() const { return target(1).volume - target(0).volume; }
  /// ∂(W₂⁰ + Ac/(π k_ad))/∂μ of what the moment's equation has, the state held.
  double W2_rate(const LineState& state) const;
  Eigen::VectorXd gradient_rate(const LineState& state) const;
};

}  // namespace sbeh::axisym
