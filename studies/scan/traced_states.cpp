#include "studies/scan/traced_states.h"

#include "axisym/curvature.h"
#include "axisym/shape_class.h"
#include "axisym/stationary/arclength.h"
#include "axisym/stationary/stability.h"
#include "studies/io/interrupt.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/point_outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace sbeh::studies {

using axisym::Branch;
using axisym::BranchState;
using axisym::StationaryCase;
using axisym::TracedBranch;
using axisym::TracePoint;
using model::Model;

namespace {

constexpr double least_volume = 0.3;

bool is_of(Branch branch, const axisym::Nodes& X) {
  return std::string_view(name(axisym::classify(X))) == name(branch);
}

double volume_of(const TracedBranch& branch, const TracePoint& point) {
  return branch.line.at(point.state.mu).reduced_volume;
}

BranchState state_of(const TracedBranch& branch, const TracePoint& point) {
  return {point.state, branch.line.at(point.state.mu), 0};
}

// The state at a reduced volume near one of a trace, on its side of a fold.
std::optional<BranchState> state_near(const TracedBranch& branch, const TracePoint& near,
                                      double reduced_volume, const axisym::Numerics& numerics) {
  const axisym::Line& line = branch.line;
  const auto found = axisym::follow(line.material, line.model, state_of(branch, near),
                                    {reduced_volume, line.from.L}, numerics);
  return found.arrival == axisym::Arrival::reached ? std::optional(found.state) : std::nullopt;
}

// The points of a trace next to which it passes a reduced volume: between two of a leg, between one and the fold, and between the
// beginning and the first.
std::vector<const TracePoint*> points_near(const TracedBranch& branch, double reduced_volume) {
  const auto& points = branch.trace.points;
  std::vector<const TracePoint*> near;
  const auto is_between = [&](double a, double b) {
    return (a > reduced_volume) != (b > reduced_volume);
  };
  const auto volume = [&](std::size_t k) { return volume_of(branch, points[k]); };
  if (!points.empty() && is_between(branch.start_volume, volume(0))) near.push_back(&points[0]);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const TracePoint &a = points[k - 1], &b = points[k];
    if (a.leg == b.leg) {
      const bool a_nearer =
          std::abs(volume(k - 1) - reduced_volume) < std::abs(volume(k) - reduced_volume);
      if (is_between(volume(k - 1), volume(k))) near.push_back(a_nearer ? &a : &b);
      continue;
    }
    for (const axisym::SpecialState& fold : branch.trace.specials) {
      if (fold.kind != axisym::Special::fold || fold.leg != a.leg) continue;
      const double end = branch.line.at(fold.state.mu).reduced_volume;
      if (is_between(volume(k - 1), end)) near.push_back(&a);
      if (is_between(volume(k), end)) near.push_back(&b);
    }
  }
  return near;
}

// Whether a branch of this class has closed its neck on the way to a reduced volume.
bool has_closed(const TracedBranch& branch, Branch of, double reduced_volume) {
  const auto& points = branch.trace.points;
  if (branch.trace.end != axisym::TraceEnd::limit || points.size() < 2
      || !is_of(of, points.back().state.X))
    return false;
  const double last = volume_of(branch, points.back()),
               before = volume_of(branch, points[points.size() - 2]);
  return last < before ? reduced_volume < last : reduced_volume > last;
}

// Where the states of a class are, as a clause.
std::string place_of(const std::vector<TracedBranch>& branches, Branch of) {
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const TracedBranch& branch : branches)
    for (const TracePoint& point : branch.trace.points)
      if (is_of(of, point.state.X)) {
        low = std::min(low, volume_of(branch, point));
        high = std::max(high, volume_of(branch, point));
      }
  return high == 0 ? fmt::format("none was met between V_r = {} and the sphere", least_volume)
                   : fmt::format("they are between V_r = {:.6g} and {:.6g}", low, high);
}

// Symmetry losses alone are looked for, and only to go on from.
axisym::TraceOptions trace_options() {
  return {.largest_m = 0, .stops = [] { return interrupt_signal() != 0; }, .promised = 1e-6};
}

}  // namespace

TracedStates::TracedStates(const model::Material& material, const axisym::Numerics& numerics)
    : material_(material),
      numerics_(numerics),
      line_{.material = material,
            .model = Model::SSH,
            .from = {axisym::nearly_round, material.L1},
            .to = {least_volume, material.L1}},
      symmetric_{axisym::SshBranch(Branch::prolate, material, numerics),
                 axisym::SshBranch(Branch::oblate, material, numerics)} {
  branches_ = traced_from_sphere(line_, numerics, trace_options());
  add_leaving(branches_, numerics, trace_options());
}

void TracedStates::begin_at(double reduced_volume) {
  if (!material_.area_difference.is_there()) return;
  axisym::Line line = line_;
  line.symmetric = true;
  const double mu = (reduced_volume - line.from.reduced_volume)
                  / (line.to.reduced_volume - line.from.reduced_volume);
  std::vector<TracedBranch> begun;
  for (const bool prolate : {true, false}) {
    const Branch branch = prolate ? Branch::prolate : Branch::oblate;
    const auto found = symmetric_[prolate ? 0 : 1].at(reduced_volume);
    if (!found || found->arrival != axisym::Arrival::reached) continue;
    const auto known = at(branch, reduced_volume);
    if (std::ranges::any_of(known, [&](const auto& one) { return is_same(one, found->state); }))
      continue;
    const auto start = axisym::with_tangent(line, {found->state, mu});
    if (!start) continue;
    axisym::Trace trace = axisym::trace_both_ways(line, *start, numerics_, trace_options());
    if (trace.points.empty()) continue;
    const double first = line.at(trace.points.front().state.mu).reduced_volume;
    begun.push_back({name(branch), "", first, {}, line, std::move(trace)});
  }
  add_leaving(begun, numerics_, trace_options());
  std::ranges::move(begun, std::back_inserter(branches_));
}

bool TracedStates::is_same(const BranchState& a, const BranchState& b) const {
  constexpr double same = 1e-9;
  const double one = axisym::energy(material_, a, a.H).total(),
               other = axisym::energy(material_, b, b.H).total();
  return std::abs(one - other) < same * (1 + std::abs(one));
}

std::vector<BranchState> TracedStates::at(Branch branch, double reduced_volume) const {
  std::vector<std::tuple<int, double, BranchState>> found;
  for (const TracedBranch& traced : branches_)
    for (const TracePoint* near : points_near(traced, reduced_volume)) {
      const auto state = state_near(traced, *near, reduced_volume, numerics_);
      if (!state || !is_of(branch, state->X)) continue;
      const bool is_known = std::ranges::any_of(
          found, [&](const auto& one) { return is_same(std::get<2>(one), *state); });
      if (is_known) continue;
      found.emplace_back(axisym::negative_directions(material_, Model::SSH, *state),
                         axisym::energy(material_, *state, state->H).total(), *state);
    }
  std::ranges::stable_sort(
      found, {}, [](const auto& one) { return std::pair(std::get<0>(one), std::get<1>(one)); });
  std::vector<BranchState> states;
  states.reserve(found.size());
  for (auto& one : found) states.push_back(std::move(std::get<2>(one)));
  return states;
}

PointOutcome TracedStates::point(const StationaryCase& of) {
  const Stopwatch watch;
  begin_at(of.reduced_volume);
  const auto states = at(of.branch, of.reduced_volume);
  PointOutcome point;
  if (!states.empty()) {
    point = resolved_point(of, states.front());
  } else if (const auto closed = std::ranges::find_if(
                 branches_,
                 [&](const auto& b) { return has_closed(b, of.branch, of.reduced_volume); });
             closed != branches_.end()) {
    // The trace ends where the neck is narrow, the branch a little later.
    const BranchState last = state_of(*closed, closed->trace.points.back());
    point = outcome_of(of, axisym::follow(material_, Model::SSH, last, of.at(), numerics_));
  } else {
    point = failed_point(fmt::format("no {} is there at this V_r: {}", name(of.branch),
                                     place_of(branches_, of.branch)));
    point.row.status = PointStatus::unresolved;
  }
  point.row.wall_seconds = watch.seconds();
  return point;
}

}  // namespace sbeh::studies
