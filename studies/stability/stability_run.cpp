#include "studies/stability/stability_run.h"

#include "meshing/measures.h"
#include "meshing/revolution.h"
#include "studies/evolution/run_start.h"
#include "studies/io/interrupt.h"
#include "studies/io/stopwatch.h"
#include "studies/witnesses/state.h"
#include "surface3d/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace sbeh::studies {

using surface3d::FlowStop;
using surface3d::Triangulation;

namespace {

constexpr double area = 4 * std::numbers::pi;

constexpr double most_settling = 0.1;
// A perturbation that has grown has come to rest when nothing moves faster than this share of the fastest motion
// since then.
constexpr double rest_share = 0.01;
// Energies that differ by less than this share of the sphere's bending energy 8πκ are one.
constexpr double same_energy = 0.01;

// Sees every step; ends the run when the fate of the perturbation is clear.
class Observer {
 public:
  Observer(const StabilityKey& key, double settling_time, double gone_at)
      : key_(key), settling_time_(settling_time), gone_at_(gone_at) {}

  bool operator()(const surface3d::FlowRecord& record, const surface3d::State& state,
                  const surface3d::StepView& view) {
    const double amplitude = mode_amplitude(*view.mesh, state.X, key_.l, key_.m);
    history.push_back({record.time, record.time_step, record.energy.total(), amplitude,
                       record.normal_speed, record.order_speed});
    if (!unresolved_from && !resolved(view.indicators)) unresolved_from = record.time;
    if (record.time >= settling_time_) follow(record.time, amplitude);
    if (has_grown) {
      const double speed = record.speed();
      fastest_ = std::max(fastest_, speed);
      settled = speed < rest_share * fastest_;
    }
    return !has_gone && !settled && interrupt_signal() == 0;
  }

  std::vector<PerturbedAt> history;
  std::vector<AmplitudeAt> amplitudes;  // from the settling time on
  std::optional<double> unresolved_from;
  bool decayed = false, has_grown = false, settled = false;
  /// Decayed, at a rate that is known or so long that nothing is left: otherwise the amplitude may go through 0 and
  /// rise again.
  bool has_gone = false;
  /// Before anything was measured: what is left has no rate.
  bool has_gone_early() const { return gone_at_ < settling_time_; }

 private:
  void follow(double time, double amplitude) {
    amplitudes.push_back({time, amplitude});
    // It may just be going through 0 at that time.
    const double reference =
        std::max(amplitudes.front().amplitude, most_settling * history.front().amplitude);
    decayed = amplitude < most_decay * reference;
    const auto growth = decayed ? fit_growth(amplitudes) : std::nullopt;
    has_gone = decayed && (time >= gone_at_ || (growth && growth->rate < -growth->error));
    has_grown = amplitude > grown * reference;
  }

  StabilityKey key_;
  double settling_time_, gone_at_, fastest_ = 0;
};

Verdict verdict_of(const Observer& seen, const std::optional<GrowthRate>& growth) {
  if (seen.has_grown) return Verdict::leaves;
  if (seen.decayed) return Verdict::stays;
  if (!growth || std::abs(growth->rate) <= growth->error) return Verdict::undecided;
  return growth->rate > 0 ? Verdict::leaves : Verdict::stays;
}

std::string reason_of(const Observer& seen, const surface3d::FlowResult& run) {
  if (seen.has_gone) return "the perturbation has decayed to a fifth";
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

// What the modes say, before any run.
void take_mode(const LinearMode& mode, StabilityResult& result) {
  result.eigenvalue = mode.eigenvalue;
  result.mode_rate = mode.rate;
  if (mode.is_resolved) result.verdict = mode.rate > 0 ? Verdict::leaves : Verdict::stays;
}

std::optional<GrowthRate> growth_of(const Observer& seen, std::optional<double> settled) {
  return seen.has_gone_early() ? std::nullopt : fit_growth(seen.amplitudes, settled);
}

// What the run says beside it.
void take_run(const Observer& seen, const std::optional<GrowthRate>& growth,
              const std::optional<LinearMode>& mode, double kappa, StabilityResult& result) {
  result.growth = growth;
  result.witness = verdict_of(seen, growth);
  if (!mode || !mode->is_resolved) result.verdict = result.witness;
  if (!growth) return;
  result.reduced_rate = growth->rate / kappa;
  if (mode) result.rate_difference = growth->rate - mode->rate;
}

// Throws std::invalid_argument where the perturbation is too large.
meshing::RevolvedMesh perturbed(const axisym::State& profile, const StabilityInput& input,
                                const StabilityKey& key, const std::optional<LinearMode>& mode,
                                int triangles) {
  const meshing::Harmonic displacement = perturbation_of(input, key);
  meshing::RevolvedMesh revolved;
  try {
    if (input.start == StabilityStart::mode) {
      if (!mode) throw std::invalid_argument("has no mode that is found");
      revolved = displaced({{key.model, input.material.with_L1(key.L)},
                            profile,
                            {key.m, mode->parity},
                            mode->eigenvalue,
                            mode->rate,
                            mode->u,
                            mode->b},
                           displacement.amplitude, {.triangles = triangles});
    } else {
      revolved = meshing::revolved(profile, {.triangles = triangles});
      perturb(revolved.mesh, {displacement});
    }
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("the perturbation {}", error.what()));
  }
  meshing::scale_to_area(revolved.mesh, area);
  return revolved;
}

// A run, and what was seen of it.
struct Followed {
  std::shared_ptr<const Triangulation> mesh;
  Observer seen;
  surface3d::FlowResult run;
};

// Throws std::invalid_argument where the perturbation is too large.
Followed follow(const axisym::State& profile, const StabilityInput& input, const StabilityKey& key,
                const std::optional<LinearMode>& mode, bool is_coarser = false) {
  const int triangles = is_coarser ? input.coarser : input.triangles;
  const model::Material material = input.material.with_L1(key.L);
  const double kappa = material.kappa(model::full_order);
  const meshing::RevolvedMesh start = perturbed(profile, input, key, mode, triangles);
  const auto mesh = std::make_shared<const Triangulation>(start.mesh);
  surface3d::Numerics numerics = input.numerics_3d;
  numerics.largest_step = largest_step(input, mode, is_coarser);
  Observer seen(key, settling_time(input, kappa),
                mode ? mode->gone_at() : std::numeric_limits<double>::infinity());
  const surface3d::FlowResult run = surface3d::run_flow(
      material, key.model,
      {.mesh = mesh,
       .state = {start.mesh.nodes, start.beta},
       .target = {area, key.reduced_volume * area / 3}},
      numerics, {.end_time = input.end_time / kappa, .output_times = {}, .stop_at_rest = false},
      [&](const auto& record, const auto& state, const auto& view, bool) {
        return seen(record, state, view);
      });
  return {mesh, std::move(seen), run};
}

// From when on a run's amplitude is that of the mode alone.
std::optional<double> settled_at(const StabilityInput& input,
                                 const std::optional<LinearMode>& mode) {
  if (!mode) return {};
  return input.start == StabilityStart::mode ? 0 : mode->settled_at();
}

// The run, and where it is asked for one on a coarser mesh. Empty when interrupted.
std::optional<Followed> run_on_meshes(const axisym::State& profile, const StabilityInput& input,
                                      const StabilityKey& key,
                                      const std::optional<LinearMode>& mode,
                                      StabilityResult& result) {
  const double kappa = input.material.with_L1(key.L).kappa(model::full_order);
  std::optional<Followed> fine = follow(profile, input, key, mode);
  const std::optional<double> settled = settled_at(input, mode);
  std::optional<GrowthRate> growth = growth_of(fine->seen, settled);
  if (growth && input.coarser > 0 && interrupt_signal() == 0)
    if (const auto coarse = growth_of(follow(profile, input, key, mode, true).seen, settled)) {
      result.coarser_rate = coarse->rate;
      growth->error = std::max(growth->error, std::abs(coarse->rate - growth->rate));
    }
  if (interrupt_signal() != 0) return {};
  take_run(fine->seen, growth, mode, kappa, result);
  return fine;
}

// The energies of the axisymmetric shapes, and what is known of the perturbation without a run. Empty where there is no
// state, which the result's stop_reason says.
std::optional<axisym::State> take_states(const StabilityInput& input, const StabilityKey& key,
                                         StabilityResult& result) {
  const auto state_of = [&](axisym::Branch branch) {
    return newton_state(case_of(input, {key.reduced_volume, key.L, key.model, branch}));
  };
  const WitnessState oblate = state_of(axisym::Branch::oblate),
                     prolate = state_of(axisym::Branch::prolate);
  result.energy_oblate = oblate.measures.energy;
  result.energy_prolate = prolate.measures.energy;
  const WitnessState& axisymmetric = key.branch == axisym::Branch::oblate ? oblate : prolate;
  if (!axisymmetric.profile) {
    result.stop_reason = axisymmetric.failure;
    return {};
  }
  result.energy_axisymmetric = axisymmetric.measures.energy;
  if (const auto saddle = classical_saddle(case_of(input, key))) {
    result.negative_directions = saddle->negative_directions;
    result.stiffness = saddle->stiffness;
  }
  return axisymmetric.profile;
}

}  // namespace

double settling_time(const StabilityInput& input, double kappa) {
  return input.start == StabilityStart::mode ? 0 : settling_share / kappa;
}

double largest_step(const StabilityInput& input, const std::optional<LinearMode>& mode,
                    bool is_coarser) {
  const double step = input.numerics_3d.largest_step;
  if (input.start != StabilityStart::mode || !mode || mode->rate == 0) return step;
  return std::min(step, (is_coarser ? 2 : 1) * step_share / std::abs(mode->rate));
}

std::optional<StabilityOutcome> run_perturbed(const StabilityInput& input,
                                              const StabilityKey& key) {
  const Stopwatch watch;
  StabilityOutcome outcome;
  StabilityResult& result = outcome.result;
  result.key = key;
  const auto profile = take_states(input, key, result);
  if (!profile) return outcome;
  const auto mode = linear_mode(case_of(input, key), *profile, key.l, key.m);
  if (mode) take_mode(*mode, result);
  std::optional<Followed> followed;
  try {
    followed = run_on_meshes(*profile, input, key, mode, result);
  } catch (const std::invalid_argument& error) {
    result.stop_reason = error.what();
    return outcome;
  }
  if (!followed) return {};

  auto& [mesh, seen, run] = *followed;
  result.amplitude_start = seen.history.front().amplitude;
  result.amplitude_end = seen.history.back().amplitude;
  result.energy_end = run.last.energy.total();
  result.end_time = run.last.time;
  result.triangles = mesh->count();
  result.steps = run.steps;
  result.unresolved_from = seen.unresolved_from;
  result.stop_reason = reason_of(seen, run);
  if (seen.has_gone || seen.settled)
    result.end_state = class_of(*mesh, run.state.X, result,
                                input.material.with_L1(key.L).kappa(model::full_order));
  outcome.history = std::move(seen.history);
  result.wall_seconds = watch.seconds();
  return outcome;
}

const Columns<StabilityResult>& stability_columns() {
  using Row = StabilityResult;
  using Key = StabilityKey;
  static const Columns<Row> columns{
      column<Row>("model", inside(&Row::key, &Key::model)),
      column<Row>("reduced_volume", inside(&Row::key, &Key::reduced_volume)),
      column<Row>("L", inside(&Row::key, &Key::L)),
      column<Row>("branch", inside(&Row::key, &Key::branch)),
      column<Row>("l", inside(&Row::key, &Key::l)),
      column<Row>("m", inside(&Row::key, &Key::m)),
      column("verdict", &Row::verdict),
      column("witness", &Row::witness),
      known_column("eigenvalue", &Row::eigenvalue),
      known_column("mode_rate", &Row::mode_rate),
      column("end_state", &Row::end_state),
      part_column("rate", &Row::growth, &GrowthRate::rate, ""),
      part_column("rate_error", &Row::growth, &GrowthRate::error, "", "{:.3g}"),
      known_column("coarser_rate", &Row::coarser_rate),
      part_column("fit_from", &Row::growth, &GrowthRate::from, ""),
      part_column("fit_to", &Row::growth, &GrowthRate::to, ""),
      known_column("rate_difference", &Row::rate_difference, "{:.3g}"),
      known_column("reduced_rate", &Row::reduced_rate),
      known_column("amplitude_start", &Row::amplitude_start),
      known_column("amplitude_end", &Row::amplitude_end),
      known_column("energy_axisymmetric", &Row::energy_axisymmetric),
      known_column("energy_end", &Row::energy_end),
      known_column("energy_oblate", &Row::energy_oblate),
      known_column("energy_prolate", &Row::energy_prolate),
      column("end_time", &Row::end_time),
      column("steps", &Row::steps),
      column("triangles", &Row::triangles),
      column("unresolved_from", &Row::unresolved_from),
      column("negative_directions", &Row::negative_directions),
      known_column("stiffness", &Row::stiffness),
      column("wall_seconds", &Row::wall_seconds, "{:.4g}"),
      column("stop_reason", &Row::stop_reason),
  };
  return columns;
}

const Columns<PerturbedAt>& perturbed_columns() {
  static const Columns<PerturbedAt> columns{
      column("time", &PerturbedAt::time),
      column("time_step", &PerturbedAt::time_step),
      column("energy", &PerturbedAt::energy),
      column("amplitude", &PerturbedAt::amplitude),
      column("normal_speed", &PerturbedAt::normal_speed),
      column("order_speed", &PerturbedAt::order_speed),
  };
  return columns;
}

}  // namespace sbeh::studies
