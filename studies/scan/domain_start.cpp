#include "studies/scan/domain_start.h"

#include "axisym/domains.h"
#include "axisym/redistribute.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/stability.h"
#include "studies/io/interrupt.h"
#include "studies/io/stopwatch.h"
#include "studies/scan/point_outcome.h"
#include "studies/states/revolved_order.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

using axisym::BranchState;
using axisym::State;
using axisym::StationaryCase;

State spheroid_with(const StationaryCase& of, const OrderPattern& pattern) {
  constexpr int passes = 3;  // nodes gather at interfaces that they see
  const axisym::Numerics& n = of.numerics;
  const double outside =
      pattern.formula.empty() ? outside_of(of.material, pattern) : *of.material.mean_order;
  State state{axisym::spheroid(of.reduced_volume, of.branch == axisym::Branch::prolate, n.elements,
                               n.grading),
              {}};
  for (int pass = 0; pass <= passes; ++pass) {
    if (pass > 0) state = axisym::redistribute(state, n.grading);
    state.beta = axisym::Field::Constant(state.X.cols(), outside);
    complete_order(of.material, pattern, state);
  }
  return state;
}

namespace {

int interface_count(const State& state) { return int(axisym::interfaces(state).size()); }

// What Newton's method finds from states on their way, with as many interfaces as asked for: of those with the fewest negative
// directions the first.
class Finder {
 public:
  explicit Finder(const StationaryCase& of) : of_(of) {}

  bool has_minimum() const { return best_ && falls_ == 0; }
  void try_from(const State& state) {
    auto found = settled(of_, axisym::redistribute(state, of_.numerics.grading));
    if (!found || interface_count(*found) != of_.interfaces) return;
    const int falls = axisym::negative_directions(of_.material, of_.model, *found);
    if (best_ && falls >= falls_) return;
    best_ = std::move(found);
    falls_ = falls;
  }
  const std::optional<BranchState>& best() const { return best_; }

 private:
  const StationaryCase& of_;
  std::optional<BranchState> best_;
  int falls_ = 0;
};

std::string text_of(int interfaces) {
  return interfaces == 0 ? "none: the order is uniform"
                         : fmt::format("{} interface{}", interfaces, interfaces == 1 ? "" : "s");
}

}  // namespace

PointOutcome point_with(const StationaryCase& of, const OrderPattern& pattern) {
  constexpr double coarse = 1e-3;  // of a way whose end alone counts
  constexpr double latest = 1e3;
  const Stopwatch watch;
  axisym::Numerics numerics = of.numerics;
  numerics.tolerance = std::max(numerics.tolerance, coarse);
  const State start = spheroid_with(of, pattern);
  numerics.elements = axisym::element_count(start.X);
  Finder finder(of);
  int steps = 0, next = 32;
  const axisym::FlowResult run = axisym::run_flow(
      of.material, of.model, start, axisym::target_of(of.reduced_volume), numerics,
      {.end_time = latest}, [&](const axisym::FlowRecord&, const State& state, bool) {
        if (++steps >= next) {
          next *= 2;
          finder.try_from(state);
        }
        return !finder.has_minimum() && interface_count(state) == of.interfaces
            && interrupt_signal() == 0;
      });
  if (!finder.has_minimum()) finder.try_from(run.state);
  const auto& found = finder.best();
  PointOutcome point;
  if (found) {
    point = resolved_point(of, *found);
  } else {
    const int there = interface_count(run.state);
    point = failed_point(
        there == of.interfaces
            ? fmt::format("the flow from the domains comes to no state at rest: {} at t = {:.4g}",
                          axisym::describe(run.stop), run.last.time)
            : fmt::format("the domains have not stayed: {} at the start, {} at t = {:.4g}",
                          text_of(of.interfaces), text_of(there), run.last.time));
  }
  point.row.steps = run.steps;
  point.row.wall_seconds = watch.seconds();
  return point;
}

}  // namespace sbeh::studies
