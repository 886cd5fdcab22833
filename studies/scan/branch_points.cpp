#include "studies/scan/branch_points.h"

#include "axisym/shape_class.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/stability.h"
#include "axisym/stationary/stationary.h"
#include "model/rest_order.h"
#include "studies/io/interrupt.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numbers>

namespace sbeh::studies {

using axisym::BranchState;
using axisym::PlanePoint;
using axisym::State;
using model::Model;

namespace {

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// What a state is, apart from the branch that led to it.
PointOutcome stationary(const model::Material& material, const PointKey& key, const State& state) {
  PointOutcome point{{.key = key,
                      .status = PointStatus::stationary,
                      .diagnostics = axisym::diagnose(material, state),
                      .stop_reason = "stationary"},
                     state};
  PointResult& row = point.row;
  const axisym::Diagnostics& d = *row.diagnostics;
  const axisym::ShapeClass shape = axisym::classify(state.X);
  row.shape = axisym::name(shape);
  row.self_contact = axisym::crosses_itself(state.X);
  if (d.resolution > axisym::resolution_limit) {
    row.status = PointStatus::unresolved;
    row.stop_reason =
        fmt::format("|H| times node spacing is {:.2f} at the rim, more than {}: use more elements",
                    d.resolution, axisym::resolution_limit);
  } else if (row.self_contact) {
    row.status = PointStatus::unresolved;
    row.stop_reason = "the surface passes through itself: contact is not in the model";
  } else if (row.shape != name(key.branch)) {
    row.status = PointStatus::failed;
    row.stop_reason = fmt::format("the state found is of class {}: the branch was left", row.shape);
  }
  return point;
}

// At a fold one eigenvalue is zero, and rounding says whether it counts. Before it, the number of negative
// directions is that of the start, up to pairs.
int before_fold(int at_fold, int at_start) {
  return at_fold == 0 || (at_fold - at_start) % 2 == 0 ? at_fold : at_fold - 1;
}

PointOutcome outcome_of(const ScanInput& input, const PointKey& key, const BranchState& start,
                        const axisym::FollowResult& result) {
  const PlanePoint at = result.state.at;
  const model::Material material = input.material.with_L(at.L);
  if (result.arrival == axisym::Arrival::lost)
    return failed_point(key,
                        fmt::format("Newton's method lost the branch near V_r = {:.4g}, L = {:.4g}",
                                    at.reduced_volume, at.L));
  PointOutcome point = stationary(material, key, result.state.solution.state);
  point.row.residual = axisym::residual_of(material, key.model, result.state.solution);
  point.row.steps = result.state.iterations;
  point.row.negative_directions =
      axisym::negative_directions(material, key.model, result.state.solution);
  point.row.fold_side = "before";
  if (result.arrival == axisym::Arrival::fold && point.row.status != PointStatus::failed) {
    point.row.status = PointStatus::unresolved;
    point.row.fold_side = "at";
    if (key.model == Model::SBEH) point.row.fold_L = at.L;
    point.row.negative_directions = before_fold(
        *point.row.negative_directions,
        axisym::negative_directions(input.material.with_L(start.at.L), key.model, start.solution));
    point.row.stop_reason = fmt::format(
        "the smooth {} branch ends in a fold at V_r = {:.6g}, L = {:.6g}{}; the values are those "
        "at "
        "the fold",
        name(key.branch), at.reduced_volume, at.L,
        key.model == Model::SBEH && key.branch == axisym::Branch::oblate
            ? "; beyond it the rim is sharp"
            : "");
  }
  return point;
}

// Follows along L in stages, so that a fold at a small L is no tiny piece of the way.
axisym::FollowResult follow_up(const ScanInput& input, Model model, BranchState from, double L) {
  constexpr double stage = 4;
  const double v = from.at.reduced_volume;
  while (true) {
    const int before = from.iterations;
    const double next = from.at.L > 0 && stage * from.at.L < L ? stage * from.at.L : L;
    auto result = axisym::follow(input.material, model, from, {v, next}, input.numerics);
    result.state.iterations += before;
    if (next == L || result.arrival != axisym::Arrival::reached) return result;
    from = result.state;
  }
}

// The point of the key, along the branch from a settled state.
PointOutcome followed(const ScanInput& input, const PointKey& key, const BranchState& start,
                      const Clock& clock) {
  PointOutcome point = outcome_of(input, key, start,
                                  axisym::follow(input.material, key.model, start,
                                                 {key.reduced_volume, key.L}, input.numerics));
  point.row.steps += start.iterations;
  point.row.wall_seconds = clock.seconds();
  return point;
}

}  // namespace

PointOutcome failed_point(const PointKey& key, std::string reason) {
  return {{.key = key,
           .status = PointStatus::failed,
           .diagnostics = {},
           .stop_reason = std::move(reason)},
          {}};
}

std::optional<BranchState> settled(const model::Material& material, Model model,
                                   const Neighbour& at) {
  const auto r = axisym::solve_stationary(material, model, axisym::target_of(at.at.reduced_volume),
                                          axisym::guess_from(material, at.state));
  if (r.status != axisym::NewtonStatus::converged) return {};
  return BranchState{.at = at.at,
                     .solution = r.solution,
                     .determinant_sign = r.determinant_sign,
                     .iterations = r.iterations};
}

std::optional<Neighbour> enter_branch(const ScanInput& input, axisym::Branch branch, double L) {
  const auto entry = axisym::enter_branch(branch, input.material.with_L(L), input.numerics);
  if (!entry) return {};
  return Neighbour{entry->state.at, entry->state.solution.state};
}

constexpr double largest_fold = 2;  // of L

std::optional<BranchState> fold_above(const ScanInput& input, const Neighbour& from) {
  const auto start = settled(input.material.with_L(from.at.L), Model::SBEH, from);
  if (!start) return {};
  const auto result = follow_up(input, Model::SBEH, *start, largest_fold);
  if (result.arrival != axisym::Arrival::fold) return {};
  return result.state;
}

PointOutcome follow_to(const ScanInput& input, const PointKey& key, const Neighbour& from) {
  const Clock clock;
  const auto start = settled(input.material.with_L(from.at.L), key.model, from);
  if (!start) return failed_point(key, "Newton's method failed at the neighbouring point");
  return followed(input, key, *start, clock);
}

PointOutcome rescale_to(const ScanInput& input, const PointKey& key, const Neighbour& from) {
  const Clock clock;
  const PlanePoint at{key.reduced_volume, key.L};
  const auto state = settled(input.material.with_L(key.L), key.model, {at, from.state});
  if (!state) return follow_to(input, key, from);
  PointOutcome point = outcome_of(input, key, *state, {axisym::Arrival::reached, *state});
  point.row.wall_seconds = clock.seconds();
  return point;
}

PointOutcome order_from(const ScanInput& input, const PointKey& key, const Neighbour& ssh) {
  const Clock clock;
  // As L → 0 the shape is SSH's and the order full: at some small L Newton gets there directly. It must be
  // well below any fold: beyond one, Newton may find a state of another branch.
  const double first_L = std::min(key.L, small_L);
  for (double L = first_L; L > first_L / 1000; L /= 2) {
    const auto first =
        settled(input.material.with_L(L), key.model, {{key.reduced_volume, L}, ssh.state});
    if (!first) continue;
    PointOutcome point = outcome_of(input, key, *first, follow_up(input, key.model, *first, key.L));
    point.row.wall_seconds = clock.seconds();
    return point;
  }
  return failed_point(key,
                      "Newton's method found no ordered state near the SSH shape, even at small L");
}

PointOutcome beyond_fold(const PointKey& key, const PointOutcome& fold) {
  PointOutcome point = fold;
  point.row.key = key;
  point.row.steps = 0;
  point.row.wall_seconds = 0;
  return point;
}

PointOutcome sphere_point(const ScanInput& input, const PointKey& key) {
  const Clock clock;
  const model::Material material = input.material.with_L(key.L);
  const std::optional<double> order =
      has_free_order(key.model) ? model::sphere_rest_order(material) : model::full_order;
  if (!order) return failed_point(key, "no ordered state at rest on the sphere at this L");
  const int elements = input.numerics.elements;
  const State state{axisym::spheroid(1., 1., elements, 0),
                    axisym::Field::Constant(3 * elements + 1, *order)};
  PointOutcome point{{.key = key,
                      .status = PointStatus::stationary,
                      .diagnostics = axisym::diagnose(material, state),
                      .shape = "sphere",
                      .stop_reason = "the sphere"},
                     state};
  point.row.wall_seconds = clock.seconds();
  return point;
}

std::optional<PointOutcome> flow_to_rest(const ScanInput& input, const PointKey& key,
                                         std::vector<SeriesRow>& history) {
  const Clock clock;
  const model::Material material = input.material.with_L(key.L);
  const axisym::Numerics& n = input.numerics;
  const State start{axisym::spheroid(key.reduced_volume, key.branch == axisym::Branch::prolate,
                                     n.elements, n.grading),
                    axisym::Field::Constant(3 * n.elements + 1, model::full_order)};
  const axisym::FlowSchedule schedule{.end_time = input.flow_end_time, .output_times = {}};
  const axisym::FlowResult run =
      axisym::run_flow(material, key.model, start, axisym::target_of(key.reduced_volume), n,
                       schedule, [&](const axisym::FlowRecord& record, const State& state, bool) {
                         history.push_back({record, axisym::diagnose(material, state)});
                         return interrupt_signal() == 0;
                       });
  if (run.stop == axisym::FlowStop::interrupted) return {};

  const Neighbour end{{key.reduced_volume, key.L}, run.state};
  PointOutcome point = stationary(material, key, run.state);
  point.row.residual = std::max(run.last.normal_speed, run.last.order_speed);
  if (run.stop == axisym::FlowStop::at_rest) {
    if (const auto polished = settled(material, key.model, end)) {
      point = outcome_of(input, key, *polished, {axisym::Arrival::reached, *polished});
      const std::string rest = fmt::format("at rest at t = {:.4g}", run.last.time);
      point.row.stop_reason =
          point.row.status == PointStatus::stationary ? rest : rest + "; " + point.row.stop_reason;
    }
  } else {
    point.row.status = run.stop == axisym::FlowStop::step_too_small ? PointStatus::failed
                                                                    : PointStatus::unresolved;
    point.row.stop_reason =
        fmt::format("{} at t = {:.4g}", axisym::describe(run.stop), run.last.time);
  }
  point.row.steps = run.steps;
  point.row.wall_seconds = clock.seconds();
  return point;
}

}  // namespace sbeh::studies
