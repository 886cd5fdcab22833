#include "studies/scan/branch_points.h"

#include "axisym/shape_class.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/fold_kind.h"
#include "axisym/stationary/limit_shape.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/stability.h"
#include "axisym/stationary/stationary.h"
#include "axisym/stationary/symmetry.h"
#include "model/order_step.h"
#include "studies/io/interrupt.h"
#include "studies/io/stopwatch.h"

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

StationaryCase moved_to(const PlanePoint& at, StationaryCase of) {
  of.reduced_volume = at.reduced_volume;
  of.material = of.material.with_L1(at.L);
  return of;
}

// What a state is, apart from the branch that led to it.
PointOutcome outcome_of(const StationaryCase& of, const StationaryState& state,
                        const axisym::Diagnostics& diagnostics) {
  PointOutcome point{
      {.status = PointStatus::stationary, .diagnostics = diagnostics, .stop_reason = "stationary"},
      state};
  PointResult& row = point.row;
  const double resolution = row.diagnostics->resolution;
  row.shape = sbeh::name(axisym::classify(state.X));
  row.self_contact = axisym::crosses_itself(state.X);
  const auto is = [&](PointStatus status, std::string reason) {
    row.status = status;
    row.stop_reason = std::move(reason);
  };
  if (resolution > axisym::largest_resolution)
    is(PointStatus::unresolved,
       fmt::format("the profile's curvature times its node spacing is {:.2f}, more than {}: use "
                   "more elements",
                   resolution, axisym::largest_resolution));
  else if (row.self_contact)
    is(PointStatus::unresolved, "the surface passes through itself: contact is not in the model");
  else if (row.shape != name(of.branch))
    is(PointStatus::failed,
       fmt::format("the state found is of class {}: the branch was left", row.shape));
  return point;
}

// As a clause; empty where the order is fixed.
std::string what_gives_way(const StationaryCase& of, const BranchState& fold) {
  const auto kind =
      of.model == Model::SBEH ? axisym::fold_kind(of.material, fold.at.L, fold) : std::nullopt;
  if (!kind) return "";
  return *kind == axisym::FoldKind::whole
           ? ", where the order of the whole surface is lost"
           : fmt::format(", where the order is lost at the {}", name(*kind));
}

// What the branch's end in a fold means for the point.
void describe_fold(const StationaryCase& of, const axisym::ResolvedState& fold, PointResult& row) {
  const PlanePoint& at = fold.state.at;
  row.status = PointStatus::unresolved;
  row.fold_side = "at";
  if (of.model == Model::SBEH) {
    row.fold_L = at.L;
    row.fold_L_error = fold.place_error;
  }
  row.stop_reason = fmt::format(
      "the smooth {} branch ends in a fold at V_r = {:.6g}{}{}; the values are those at the fold{}",
      name(of.branch), at.reduced_volume,
      of.model == Model::SBEH ? fmt::format(", L = {:.6g}", at.L) : "",
      what_gives_way(of, fold.state),
      row.self_contact ? ", where the surface passes through itself" : "");
}

// A state of the case itself, over as many elements as its errors need.
PointOutcome resolved_point(const StationaryCase& of, const BranchState& state) {
  const axisym::ResolvedState found = axisym::resolved(of.material, of.model, state, of.numerics);
  PointOutcome point = outcome_of(of, found.state, found.diagnostics);
  PointResult& row = point.row;
  const auto lagrangian = axisym::lagrangian_at(of.material, of.model, found.state);
  row.residual = axisym::residual_of(lagrangian, of.model, found.state.X);
  row.negative_directions = axisym::negative_directions(lagrangian, of.material, of.model);
  row.fold_side = "before";
  row.error = found.error;
  if (!found.is_resolved && row.status == PointStatus::stationary) {
    row.status = PointStatus::unresolved;
    row.stop_reason = fmt::format(
        "with {} elements the estimated errors are still {:.1e} of the energy and {:.1e} of W2, "
        "more than is promised",
        axisym::element_count(found.state.X), found.error.energy, found.error.W2);
  }
  return point;
}

// What SSH's stomatocytes and dumbbells of about this V_r tend to; nothing where dumbbells have unequal parts.
std::optional<axisym::TouchingSpheres> limit_of(Branch branch, double reduced_volume, int spheres) {
  if (branch == Branch::stomatocyte) return axisym::sphere_in_sphere(reduced_volume);
  const double equal = 1 / std::sqrt(spheres);
  if (std::abs(reduced_volume - equal) > 0.01) return {};
  return axisym::chain_of_spheres(spheres);
}

// How many parts necks that are about to close leave.
int parts_of(const axisym::Nodes& X) {
  constexpr double closing = 0.5;
  return 1 + int(std::ranges::count_if(axisym::necks(X), [](const auto& neck) {
           return neck.depth > closing;
         }));
}

std::string text_of(const axisym::TouchingSpheres& spheres) {
  const double v = axisym::diagnose({}, spheres).reduced_volume;
  const std::string shapes =
      spheres.nested ? fmt::format("two spheres one within the other, of radii {:.6g} and {:.6g}",
                                   spheres.radii[0], spheres.radii[1])
                     : fmt::format("a chain of {} spheres of radius {:.6g}", spheres.radii.size(),
                                   spheres.radii[0]);
  return fmt::format(
      "; the branch tends to {}, with V_r = {:.6g}, whose neck closes at H0 = {:.6g}; the values "
      "are theirs",
      shapes, v, axisym::closing_H0(spheres));
}

// What the branch's end in a closed neck means for the point: what it tends to.
PointOutcome limit_point(const StationaryCase& of, const BranchState& last) {
  PointOutcome point{{.status = PointStatus::limit}, {}};
  point.row.stop_reason =
      fmt::format("a neck closes: its radius is {:.2g}", axisym::thinnest_neck(last.X));
  if (of.model != Model::SSH || of.material.area_difference.is_there()) return point;
  const double v = of.branch == Branch::stomatocyte ? of.reduced_volume : last.at.reduced_volume;
  const auto spheres = limit_of(of.branch, v, parts_of(last.X));
  if (!spheres) return point;
  point.row.diagnostics = axisym::diagnose(of.material, *spheres);
  point.row.stop_reason += text_of(*spheres);
  return point;
}

PointOutcome fold_point(const StationaryCase& of, const axisym::FollowResult& result) {
  const axisym::ResolvedState fold = axisym::resolved_fold(result, of.numerics);
  const StationaryCase there = moved_to(fold.state.at, of);
  PointOutcome point = outcome_of(there, fold.state, fold.diagnostics);
  PointResult& row = point.row;
  row.residual = axisym::residual_of(there.material, of.model, fold.state);
  row.error = fold.error;
  // At the fold itself one eigenvalue is zero, and rounding would say whether it counts.
  row.negative_directions =
      axisym::negative_directions(of.material.with_L1(result.before.at.L), of.model, result.before);
  if (row.status != PointStatus::failed) describe_fold(of, fold, row);
  return point;
}

// Of a branch that ends before the point.
PointOutcome none_here(std::string reason) {
  PointOutcome point = failed_point(std::move(reason));
  point.row.status = PointStatus::unresolved;
  return point;
}

// `share`: of what is given of κ, κ_G, f, at the end of the line that was followed.
PointOutcome outcome_of(const StationaryCase& of, const axisym::FollowResult& result,
                        double share = 1) {
  const PlanePoint at = result.state.at;
  const double H0 = result.line.material_at(result.mu).spontaneous_curvature,
               coupling = result.line.coupling(result.mu) * result.line.scale(result.mu) * share;
  const double W2 = result.line.material_at(result.mu).area_difference.W2;
  const bool is_on_the_way = H0 != of.material.spontaneous_curvature
                          || W2 != of.material.area_difference.W2 || coupling != 1;
  if (result.arrival == axisym::Arrival::reached) return resolved_point(of, result.state);
  if (result.arrival == axisym::Arrival::neck) return limit_point(of, result.state);
  const std::string where = fmt::format(
      "H0 = {:.6g}{}{}", H0,
      of.material.area_difference.is_there() ? fmt::format(", area_difference's W2 = {:.6g}", W2)
                                             : "",
      of.material.has_given() ? fmt::format(", {:.4g} of what does not go along with L", coupling)
                              : "");
  const std::string shape = name(axisym::classify(result.state.X));
  if (result.arrival == axisym::Arrival::lost && shape != name(of.branch))
    return none_here(
        fmt::format("the states to which the {} branch leads are of class {} at V_r = {:.4g}, {}",
                    name(of.branch), shape, at.reduced_volume, where));
  if (result.arrival == axisym::Arrival::lost)
    return failed_point(
        fmt::format("Newton's method lost the branch near V_r = {:.4g}, L = {:.4g}, {}",
                    at.reduced_volume, at.L, where));
  if (!is_on_the_way) return fold_point(of, result);
  return none_here(fmt::format(
      "the smooth {} branch ends in a fold at {}, V_r = {:.6g}, L = {:.6g}, before this "
      "material",
      name(of.branch), where, at.reduced_volume, at.L));
}

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
                                                    .first_scale = from.at.L / next},
                                       from, of.numerics);
    if (next == of.L() || result.arrival != axisym::Arrival::reached)
      return outcome_of(of, result, share);
    from = result.state;
  }
}

}  // namespace

PointOutcome failed_point(std::string reason) {
  return {{.status = PointStatus::failed, .stop_reason = std::move(reason)}, {}};
}

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
  const auto start = settled(of, state);
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
    if (of.branch != Branch::stomatocyte) {
      if (!ssh.row.diagnostics) return same;
      v = ssh.row.diagnostics->volume / axisym::target_of(1).volume;
    }
    if (const auto spheres = limit_of(of.branch, v, int(std::lround(1 / (v * v)))))
      same.row.diagnostics = axisym::diagnose(of.material, *spheres);
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
  PointOutcome point = outcome_of(of, follow_up(of, *start, of.L()));
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

PointOutcome order_from(const StationaryCase& of, const State& ssh) {
  const Stopwatch watch;
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
  return failed_point("Newton's method found no ordered state near the SSH shape, even at small L");
}

PointOutcome branch_point(const StationaryCase& of) {
  StationaryCase classical = of;
  classical.model = Model::SSH;
  axisym::SshBranch branch(of.branch, of.material, of.numerics);
  PointOutcome ssh = ssh_point(classical, branch);
  if (of.model == Model::SSH || !has_state_here(ssh)) return ssh;
  return order_from(of, *ssh.state);
}

PointOutcome sphere_point(const StationaryCase& of) {
  const Stopwatch watch;
  const std::optional<double> order =
      has_free_order(of.model) ? model::sphere_rest_order(of.material) : model::full_order;
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
  const State start{
      axisym::spheroid(of.reduced_volume, of.branch == Branch::prolate, n.elements, n.grading),
      axisym::Field::Constant(3 * n.elements + 1, model::full_order)};
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
  point.row.residual = std::max(run.last.normal_speed, run.last.order_speed);
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
