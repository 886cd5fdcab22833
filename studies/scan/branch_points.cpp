#include "studies/scan/branch_points.h"

#include "axisym/diagram/closing.h"
#include "axisym/shape_class.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/stationary.h"
#include "axisym/stationary/symmetry.h"
#include "model/order_step.h"
#include "studies/io/interrupt.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/point_outcome.h"
#include "studies/scan/traced_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace sbeh::studies {

using axisym::Branch;
using axisym::BranchState;
using axisym::PlanePoint;
using axisym::State;
using axisym::StationaryCase;
using axisym::StationaryState;
using model::Model;

namespace {

// Follows along L in stages, so that a fold at a small L is no tiny piece of the way.
axisym::FollowResult follow_up(const StationaryCase& of, BranchState from, double L) {
  constexpr double stage = 4;
  const double v = from.at.reduced_volume;
  while (true) {
    const double next = from.at.L > 0 && stage * from.at.L < L ? stage * from.at.L : L;
    auto result = axisym::follow(of.material, of.model, from, {v, next}, of.numerics);
    if (next == L || result.arrival != axisym::Arrival::reached) return result;
    from = result.state;
  }
}

// As it is on the way to its L: what is given of κ, κ_G, f goes along with L, so that the shape of a uniform order stays the same.
StationaryCase scaled(const StationaryCase& of, double share) {
  StationaryCase there = of;
  if (share != 1) there.material = of.material.with_given_scaled(share);
  return there;
}

PointOutcome order_up(const StationaryCase& of, BranchState from) {
  if (!of.material.has_given()) return outcome_of(of, follow_up(of, from, of.L()));
  constexpr double stage = 4;
  while (true) {
    const double next = std::min(of.L(), stage * from.at.L), share = next / of.L();
    const auto result = axisym::follow(axisym::Line{.material = scaled(of, share).material,
                                                    .model = of.model,
                                                    .from = from.at,
                                                    .to = {of.reduced_volume, next},
                                                    .first_scale = from.at.L / next,
                                                    .symmetric = axisym::is_symmetric(from.X)},
                                       from, of.numerics);
    if (next == of.L() || result.arrival != axisym::Arrival::reached)
      return outcome_of(of, result, share);
    from = result.state;
  }
}

}  // namespace

std::optional<BranchState> settled(const StationaryCase& of, const State& state, double tolerance) {
  return axisym::solve_at(of.material, of.model, of.at(),
                          axisym::guess_from(of.material, of.model, state),
                          {.tolerance = tolerance, .symmetric = axisym::is_symmetric(state.X)});
}

bool has_state_here(const PointOutcome& point) {
  return point.state && point.row.status != PointStatus::failed && point.row.fold_side == "before";
}

void add_modes(const StationaryCase& of, int largest_m, PointOutcome& point) {
  const bool is_at_rest = has_state_here(point) && point.state->Lambda.size() > 0;
  if (!is_at_rest) return;  // the sphere as well, whose tension may be any
  const Stopwatch watch;
  if (const auto modes = axisym::stability_3d(of.material, of.model, *point.state, largest_m))
    point.row.modes = *modes;
  point.row.wall_seconds += watch.seconds();
}

constexpr double largest_fold = 2;  // of L

std::optional<axisym::ResolvedState> fold_above(const StationaryCase& of, const State& state) {
  const auto start = of.L() < largest_fold ? settled(of, state) : std::nullopt;
  if (!start) return {};
  const auto result = follow_up(of, *start, largest_fold);
  if (result.arrival != axisym::Arrival::fold) return {};
  return axisym::resolved_fold(result, of.numerics);
}

PointOutcome without_ssh(const StationaryCase& of, const PointOutcome& ssh, double computed_at) {
  if (of.model == Model::SSH && ssh.row.status == PointStatus::limit) {
    PointOutcome same = ssh;  // no shape of SSH depends on L
    same.row.wall_seconds = 0;
    double v = of.reduced_volume;
    const bool has_values = ssh.row.diagnostics.has_value();
    if ((is_symmetric(of.branch) && !has_values) || (has_values && of.L() == computed_at))
      return same;
    if (is_symmetric(of.branch)) v = ssh.row.diagnostics->volume / axisym::target_of(1).volume;
    std::optional<axisym::TouchingSpheres>
        spheres;  // with an area difference the shapes of two L differ
    if (!of.material.area_difference.is_there()) {
      spheres = limit_of(of.branch, v, int(std::lround(1 / (v * v))));
      if (!spheres && has_values)
        spheres = axisym::closing_shape(of.material, *same.row.diagnostics);
    }
    same.row.diagnostics.reset();
    same.row.error.reset();
    if (spheres) put_limit(of, *spheres, same.row);
    return same;
  }
  if (of.model == Model::SSH && ssh.row.fold_side == "at" && ssh.state) {
    PointOutcome same = ssh;
    same.row.diagnostics = axisym::diagnose(of.material, *ssh.state);
    if (same.row.error) same.row.error->energy *= of.L() / computed_at;
    same.row.wall_seconds = 0;
    return same;
  }
  PointOutcome outcome = failed_point("no SSH shape to start from: " + ssh.row.stop_reason);
  outcome.row.status = ssh.row.status;
  return outcome;
}

PointOutcome ssh_point(const StationaryCase& of, axisym::SshBranch& branch) {
  const Stopwatch watch;
  const auto found = branch.at(of.reduced_volume);
  if (!found) return failed_point("Newton's method failed at the entry of the branch");
  PointOutcome point = outcome_of(of, *found);
  point.row.wall_seconds = watch.seconds();
  return point;
}

PointOutcome follow_to(const StationaryCase& of, const Neighbour& from) {
  const Stopwatch watch;
  constexpr double near = 1e-4;  // the branch is not left from there
  const auto start = settled(moved_to(from.at, of), from.state, near);
  if (!start) return failed_point("Newton's method failed at the neighbouring point");
  PointOutcome point =
      outcome_of(of, from.at.reduced_volume == of.reduced_volume
                         ? follow_up(of, *start, of.L())
                         : axisym::follow(of.material, of.model, *start, of.at(), of.numerics));
  point.row.wall_seconds = watch.seconds();
  return point;
}

PointOutcome rescale_to(const StationaryCase& of, const Neighbour& from) {
  const Stopwatch watch;
  // With an area difference the shapes of two L differ, and may do so by more than Newton's method bridges.
  const auto state =
      of.material.area_difference.is_there() ? std::nullopt : settled(of, from.state);
  if (!state) return follow_to(of, from);
  PointOutcome point = resolved_point(of, *state);
  point.row.wall_seconds = watch.seconds();
  return point;
}

namespace {

// The end of a branch in a fold at so small an L that the tension of full order drowns it in rounding, as that of a narrow neck is:
// with a potential from which the value at full order is taken, which makes no difference where the area is kept. Empty where it is
// not found.
std::optional<PointOutcome> end_at_tiny_L(const StationaryCase& of, const State& ssh) {
  constexpr double tiny_L = 1e-8, least_L = 1e-13, factor = 4;
  std::vector<double> powers = of.material.potential.coefficients();
  if (of.material.has_lipid_density() || powers.empty()) return {};
  StationaryCase from_full = of;
  powers[0] -= of.material.potential.value(model::full_order);
  from_full.material.potential = model::Potential(powers);
  for (double L = tiny_L; L > least_L; L /= factor) {
    const auto first =
        settled(moved_to({of.reduced_volume, L}, scaled(from_full, L / of.L())), ssh);
    if (!first) continue;
    PointOutcome point = order_up(from_full, *first);
    if (point.row.status == PointStatus::failed) return {};
    if (point.state)
      point.row.diagnostics =
          axisym::diagnose(of.material.with_L1(point.row.fold_L.value_or(of.L())), *point.state);
    return point;
  }
  return {};
}

}  // namespace

PointOutcome order_from(const StationaryCase& of, const State& ssh) {
  const Stopwatch watch;
  constexpr double narrow = 0.02;
  // As L → 0 the shape is SSH's and the order full: at some small L Newton gets there directly. It must be
  // well below any fold: beyond one, Newton may find a state of another branch.
  const double first_L = std::min(of.L(), small_L);
  for (double L = first_L; L > first_L / 1000; L /= 2) {
    const auto first = settled(moved_to({of.reduced_volume, L}, scaled(of, L / of.L())), ssh);
    if (!first) continue;
    PointOutcome point = order_up(of, *first);
    point.row.wall_seconds = watch.seconds();
    return point;
  }
  if (auto fold = end_at_tiny_L(of, ssh)) {
    fold->row.wall_seconds = watch.seconds();
    return *fold;
  }
  const double neck = axisym::thinnest_neck(ssh.X);
  PointOutcome none = failed_point(fmt::format(
      "Newton's method found no ordered state near the SSH shape, even at small L{}",
      neck < narrow ? fmt::format(": its neck, of radius {:.2g}, is so narrow that it loses its "
                                  "order at an L at which rounding outweighs all elastic energy",
                                  neck)
                    : ""));
  if (neck < narrow) none.row.status = PointStatus::unresolved;
  none.row.wall_seconds = watch.seconds();
  return none;
}

namespace {
PointOutcome first_of_branch(const StationaryCase& of) {
  if (of.branch == Branch::pear) return TracedStates(of.material, of.numerics).point(of);
  axisym::SshBranch branch(of.branch, of.material, of.numerics);
  return ssh_point(of, branch);
}
}  // namespace

PointOutcome branch_point(const StationaryCase& of) {
  StationaryCase classical = of;
  classical.model = Model::SSH;
  PointOutcome ssh = first_of_branch(classical);
  if (of.model == Model::SSH) return ssh;
  return has_state_here(ssh) ? order_from(of, *ssh.state) : without_ssh(of, ssh, of.L());
}

PointOutcome sphere_point(const StationaryCase& of) {
  const Stopwatch watch;
  // Of full order where that keeps the number of lipids, too.
  const std::optional<double> order =
      !has_free_order(of.model) || of.material.has_lipid_density() ? model::full_order
      : of.material.conserves_order()                              ? of.material.mean_order
                                      : model::sphere_rest_order(of.material);
  if (!order) return failed_point("no ordered state at rest on the sphere at this L");
  const int elements = of.numerics.elements;
  const State state{axisym::spheroid(1., 1., elements, 0),
                    axisym::Field::Constant(3 * elements + 1, *order)};
  PointOutcome point{{.status = PointStatus::stationary,
                      .diagnostics = axisym::diagnose(of.material, state),
                      .shape = "sphere",
                      .stop_reason = "the sphere"},
                     StationaryState{state}};
  point.row.wall_seconds = watch.seconds();
  return point;
}

axisym::FlowResult flow_from_spheroid(const StationaryCase& of,
                                      const axisym::FlowSchedule& schedule,
                                      const axisym::FlowObserver& observe) {
  const axisym::Numerics& n = of.numerics;
  const double order = has_free_order(of.model) ? of.material.mean_order.value_or(model::full_order)
                                                : model::full_order;
  const State start{
      axisym::spheroid(of.reduced_volume, of.branch == Branch::prolate, n.elements, n.grading),
      axisym::Field::Constant(3 * n.elements + 1, order)};
  return axisym::run_flow(of.material, of.model, start, axisym::target_of(of.reduced_volume), n,
                          schedule, observe);
}

std::optional<PointOutcome> flow_to_rest(const StationaryCase& of, double end_time,
                                         std::vector<SeriesRow>& history) {
  const Stopwatch watch;
  const axisym::FlowResult run = flow_from_spheroid(
      of, {.end_time = end_time}, [&](const axisym::FlowRecord& record, const State& state, bool) {
        history.push_back(series_row(record, axisym::diagnose(of.material, state)));
        return interrupt_signal() == 0;
      });
  if (run.stop == axisym::FlowStop::interrupted) return {};

  PointOutcome point =
      outcome_of(of, StationaryState{run.state}, axisym::diagnose(of.material, run.state));
  point.row.residual = run.last.speed();
  if (run.stop == axisym::FlowStop::at_rest) {
    if (const auto polished = settled(of, run.state)) {
      point = resolved_point(of, *polished);
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
  point.row.wall_seconds = watch.seconds();
  return point;
}

}  // namespace sbeh::studies
