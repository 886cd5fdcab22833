// One perturbed state in 3D: what becomes of it.
#pragma once

#include "model/names.h"
#include "studies/io/growing_table.h"
#include "studies/stability/linear_mode.h"
#include "studies/stability/mode_amplitude.h"
#include "studies/stability/stability_input.h"

namespace sbeh::studies {

enum class Verdict {
  stays,      ///< the perturbation decays
  leaves,     ///< it grows
  undecided,  ///< neither can be said before the end time
  failed      ///< there is no state, or the run broke off before anything could be said
};
constexpr auto names(Verdict) { return std::array{"stays", "leaves", "undecided", "failed"}; }

/// In units of 1/κ: a displacement is no pure mode, and its fastest parts are gone by then. What grows and
/// decays is told by the amplitude from here on.
inline constexpr double settling_share = 0.1;
/// Of a run that starts from a mode the longest step, times its rate.
inline constexpr double step_share = 0.02;
/// A perturbation has grown when it is so many times as large.
inline constexpr double grown = 10;

/// How long a run waits before it measures; a mode alone has no fastest parts.
double settling_time(const StabilityInput& input, double kappa);
/// No longer than the input's; of a mode alone on the coarser mesh twice what it is on the other.
double largest_step(const StabilityInput& input, const std::optional<LinearMode>& mode,
                    bool is_coarser = false);

/// One time of a run.
struct PerturbedAt {
  double time, time_step, energy;
  double amplitude;  ///< see mode_amplitude.h
  double normal_speed, order_speed;
};
const Columns<PerturbedAt>& perturbed_columns();

/// What is known of a run in the end, a row of stability.csv; `not_known` where it is not.
struct StabilityResult {
  StabilityKey key{};
  /// By the modes of the state; by the run, where they are not resolved.
  Verdict verdict = Verdict::failed;
  Verdict witness = Verdict::failed;   ///< by the run
  double eigenvalue = not_known;       ///< of the least stable mode of this m and parity
  double mode_rate = not_known;        ///< its rate in the linearised flow
  double rate_difference = not_known;  ///< of the run's rate from that
  /// Where it went: the class of the surface; "triaxial" also for the moments of an oblate or prolate with
  /// an energy that is not that of the axisymmetric one. Empty unless it is at rest again.
  std::string end_state{};
  /// Its error is no less than the difference from a coarser run, where there is one.
  std::optional<GrowthRate> growth{};
  double coarser_rate = not_known;  ///< the rate of that
  double reduced_rate = not_known;  ///< rate/κ(2/3)
  double amplitude_start = not_known, amplitude_end = not_known;
  double energy_axisymmetric = not_known;  ///< of the unperturbed state, by the axisymmetric solver
  double energy_oblate = not_known,
         energy_prolate = not_known;  ///< of the axisymmetric shapes of the same V_r, L
  double energy_end = not_known;
  double end_time = 0;
  int triangles = 0, steps = 0;
  std::optional<double> unresolved_from{};  ///< time from which the mesh was too coarse
  /// Of the classical minimiser over spherical harmonics, for SSH without spontaneous curvature from V_r =
  /// 0.65 on: directions in which the energy falls, and its least second variation.
  std::optional<int> negative_directions{};
  double stiffness = not_known;
  std::string stop_reason{};
  double wall_seconds = 0;
};
const Columns<StabilityResult>& stability_columns();

/// A result with its history.
struct StabilityOutcome {
  StabilityResult result;
  std::vector<PerturbedAt> history;
};

/// The axisymmetric state of the key by Newton's method, revolved, perturbed, and followed in 3D until the
/// perturbation has decayed to a fifth of what it is at the time 0.1/κ(2/3), at a rate that can be told or so long
/// that by its modes nothing is left, or has grown tenfold and all is at rest again, or the end time comes. Empty when interrupted.
std::optional<StabilityOutcome> run_perturbed(const StabilityInput& input, const StabilityKey& key);

}  // namespace sbeh::studies
