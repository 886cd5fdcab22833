#include "studies/stability/stability_run.h"

#include "meshing/measures.h"
#include "meshing/revolution.h"
#include "studies/evolution/run_start.h"
#include "studies/io/interrupt.h"
#include "studies/io/stopwatch.h"
#include "studies/stability/classical_saddle.h"
#include "studies/witnesses/state.h"
#include "surface3d/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace sbeh::studies {

using surface3d::FlowStop;
using surface3d::Triangulation;

namespace {

constexpr double area = 4 * std::numbers::pi;

// In units of 1/κ: a displacement is no pure mode, and its fastest parts are gone by then. What grows and
// decays is told by the amplitude from here on.
constexpr double settling_share = 0.1, most_settling = 0.1;
// A perturbation has grown when it is so many times as large, and has come to rest when nothing moves
// faster than this share of the fastest motion since then.
constexpr double grown = 10, rest_share = 0.01;
// Energies that differ by less than this share of the sphere's bending energy 8πκ are one.
constexpr double same_energy = 0.01;

meshing::Harmonic perturbation_of(const StabilityInput& input, const StabilityKey& key) {
  return *std::find_if(input.perturbations.begin(), input.perturbations.end(),
                       [&](const auto& mode) { return mode.l == key.l && mode.m == key.m; });
}

bool decays(const std::optional<GrowthRate>& growth) {
  return growth && growth->rate < -growth->error;
}

// Sees every step; ends the run when the fate of the perturbation is clear.
class Observer {
 public:
  Observer(const StabilityKey& key, double settling_time)
      : key_(key), settling_time_(settling_time) {}

  bool operator()(const surface3d::FlowRecord& record, const surface3d::State& state,
                  const surface3d::StepView& view) {
    const double amplitude = mode_amplitude(*view.mesh, state.X, key_.l, key_.m);
    history.push_back({record.time, record.time_step, record.energy.total(), amplitude,
                       record.normal_speed, record.order_speed});
    if (!unresolved_from && !resolved(view.resolution)) unresolved_from = record.time;
    if (record.time >= settling_time_) {
      amplitudes.push_back({record.time, amplitude});
      // It may just be going through 0 at that time.
      const double reference =
          std::max(amplitudes.front().amplitude, most_settling * history.front().amplitude);
      decayed = amplitude < most_decay * reference;
      steadily = decayed && decays(fit_growth(amplitudes));
      has_grown = amplitude > grown * reference;
    }
    if (has_grown) {
      const double speed = std::max(record.normal_speed, record.order_speed);
      fastest_ = std::max(fastest_, speed);
      settled = speed < rest_share * fastest_;
    }
    return !steadily && !settled && interrupt_signal() == 0;
  }

  std::vector<PerturbedAt> history;
  std::vector<AmplitudeAt> amplitudes;  // from the settling time on
  std::optional<double> unresolved_from;
  bool decayed = false, has_grown = false, settled = false;
  /// Decayed at a rate that is known: otherwise the amplitude may go through 0 and rise again.
  bool steadily = false;

 private:
  StabilityKey key_;
  double settling_time_, fastest_ = 0;
};

Verdict verdict_of(const Observer& seen, const std::optional<GrowthRate>& growth) {
  if (seen.has_grown) return Verdict::leaves;
  if (seen.decayed) return Verdict::stays;
  if (!growth || std::abs(growth->rate) <= growth->error) return Verdict::undecided;
  return growth->rate > 0 ? Verdict::leaves : Verdict::stays;
}

std::string reason_of(const Observer& seen, const surface3d::FlowResult& run) {
  if (seen.steadily) return "the perturbation has decayed to a fifth";
  if (seen.settled) return "at rest in another state";
  std::string reason = describe(run.stop);
  if (run.stop == FlowStop::step_too_small) reason += ": " + model::describe(run.fault);
  return reason;
}

// The class of a surface at rest.
std::string class_of(const Triangulation& mesh, const surface3d::Nodes& X,
                     const StabilityResult& result, double kappa) {
  const Roundness roundness = roundness_of(mesh, X);
  const double of_class =
      roundness == Roundness::oblate ? result.energy_oblate : result.energy_prolate;
  const bool other = std::abs(result.energy_end - of_class) > same_energy * 2 * area * kappa;
  return name(other ? Roundness::triaxial : roundness);
}

struct Start {
  meshing::CurvedMesh mesh;
  surface3d::Field beta;
};

Start perturbed(const axisym::State& profile, const StabilityInput& input,
                const StabilityKey& key) {
  meshing::RevolvedMesh revolved = meshing::revolved(profile, {.triangles = input.triangles});
  try {
    perturb(revolved.mesh, {perturbation_of(input, key)});
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the perturbation {}", error.what()));
  }
  meshing::scale_to_area(revolved.mesh, area);
  return {std::move(revolved.mesh), std::move(revolved.beta)};
}

}  // namespace

std::optional<StabilityOutcome> run_perturbed(const StabilityInput& input,
                                              const StabilityKey& key) {
  const Stopwatch watch;
  StabilityOutcome outcome;
  StabilityResult& result = outcome.result;
  result.key = key;
  const NewtonState oblate = newton_state(case_of(input, key, axisym::Branch::oblate)),
                    prolate = newton_state(case_of(input, key, axisym::Branch::prolate));
  result.energy_oblate = oblate.found.measures.energy;
  result.energy_prolate = prolate.found.measures.energy;
  const NewtonState& axisymmetric = key.branch == axisym::Branch::oblate ? oblate : prolate;
  if (!axisymmetric.state) {
    result.stop_reason = axisymmetric.found.failure;
    return outcome;
  }
  result.energy_axisymmetric = axisymmetric.found.measures.energy;
  if (const auto saddle = classical_saddle(case_of(input, key, key.branch))) {
    result.negative_directions = saddle->negative_directions;
    result.stiffness = saddle->stiffness;
  }

  const model::Material material = input.material.with_L(key.L);
  const double kappa = material.kappa(model::full_order);
  Start start;
  try {
    start = perturbed(axisymmetric.state->state, input, key);
  } catch (const std::invalid_argument& error) {
    result.stop_reason = error.what();
    return outcome;
  }
  const auto mesh = std::make_shared<const Triangulation>(start.mesh);
  Observer seen(key, settling_share / kappa);
  const surface3d::FlowResult run = surface3d::run_flow(
      mesh, material, key.model, {.state = {start.mesh.nodes, start.beta}},
      {area, key.reduced_volume * area / 3}, input.numerics_3d,
      {.end_time = input.end_time / kappa, .output_times = {}, .stop_at_rest = false},
      [&](const auto& record, const auto& state, const auto& view, bool) {
        return seen(record, state, view);
      });
  if (interrupt_signal() != 0) return {};

  result.growth = fit_growth(seen.amplitudes);
  if (result.growth) result.reduced_rate = result.growth->rate / kappa;
  result.verdict = verdict_of(seen, result.growth);
  result.amplitude_start = seen.history.front().amplitude;
  result.amplitude_end = seen.history.back().amplitude;
  result.energy_end = run.last.energy.total();
  result.end_time = run.last.time;
  result.triangles = mesh->count();
  result.steps = run.steps;
  result.unresolved_from = seen.unresolved_from;
  result.stop_reason = reason_of(seen, run);
  if (seen.steadily || seen.settled) result.end_state = class_of(*mesh, run.state.X, result, kappa);
  outcome.history = std::move(seen.history);
  result.wall_seconds = watch.seconds();
  return outcome;
}

}  // namespace sbeh::studies
