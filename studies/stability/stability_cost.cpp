#include "studies/stability/stability_cost.h"

#include "studies/evolution/run_start.h"
#include "studies/stability/stability_run.h"
#include "studies/witnesses/state.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::studies {

namespace {

constexpr std::size_t most_looked_at = 16;
constexpr double first_steps = 30;  // until a step is as long as it may be
constexpr double large = 0.4;       // the amplitude with which a mode grows no more
constexpr double to_rest = 3;       // in units of 1/κ: other modes are slow

// Of the states of Newton's method with their modes; of SSH by spherical harmonics too.
double seconds_of_states(model::Model model) { return model == model::Model::SSH ? 1.5 : 0.6; }

// How long a run follows the perturbation, if it ends by itself.
double time_of(const LinearMode& mode, double amplitude, double kappa, double step,
               double settling) {
  if (mode.rate > 0)
    return settling
         + std::max(std::log(std::max(large / amplitude, grown)) / mode.rate, to_rest / kappa);
  const double decay = std::log(most_decay) / mode.rate;
  const bool leaves_a_rate = decay > 3 * double(fewest_amplitudes) * step;
  return leaves_a_rate ? settling + decay : std::max(settling, mode.gone_at());
}

// 0: there is no state to perturb.
double steps_of(const StabilityInput& input, const StabilityKey& key) {
  const axisym::StationaryCase of = case_of(input, key);
  const WitnessState state = newton_state(of);
  if (!state.profile) return 0;
  const double kappa = of.material.kappa(model::full_order);
  const auto mode = linear_mode(of, *state.profile, key.l, key.m);
  const double step = largest_step(input, mode);
  double time = input.end_time / kappa;
  if (mode)
    time = std::min(time, time_of(*mode, perturbation_of(input, key).amplitude, kappa, step,
                                  settling_time(input, kappa)));
  return first_steps + time / step;
}

// `count` of them, not in step with the list, in which the perturbations of each state follow each other.
std::vector<StabilityKey> some_of(const std::vector<StabilityKey>& keys, std::size_t count) {
  if (keys.size() <= count) return keys;
  std::vector<StabilityKey> some(count);
  for (std::size_t i = 0; i < count; ++i)
    some[i] = keys[std::size_t(std::fmod(double(i) / std::numbers::phi, 1) * double(keys.size()))];
  return some;
}

}  // namespace

StabilityCost cost_of(const StabilityInput& input) {
  const std::vector<StabilityKey> keys = keys_of(input), looked_at = some_of(keys, most_looked_at);
  const double share = double(keys.size()) / double(looked_at.size());
  StabilityCost cost{.runs = int(keys.size())};
  for (const StabilityKey& key : looked_at) {
    RunInput run;
    run.model = key.model;
    run.material = input.material.with_L1(key.L);
    run.numerics = input.numerics_3d;
    const double steps = steps_of(input, key);
    cost.steps += share * steps;
    double seconds_per_step = cost_of(run, input.triangles).seconds_per_step;
    if (input.coarser > 0) seconds_per_step += cost_of(run, input.coarser).seconds_per_step;
    cost.seconds += share * (seconds_of_states(key.model) + steps * seconds_per_step);
  }
  return cost;
}

}  // namespace sbeh::studies
