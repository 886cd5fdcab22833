#include "studies/diagram/diagram_branches.h"

#include "axisym/diagnostics.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/stationary.h"
#include "axisym/stationary/symmetry.h"
#include "studies/io/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace sbeh::studies {

using axisym::Line;
using axisym::PathState;
using axisym::Special;
using axisym::Trace;

namespace {

using Lines = std::vector<DiagramBranch>;

axisym::TraceOptions options_of(const DiagramInput& input) {
  return {.largest_m = input.modes, .stops = [] { return interrupt_signal() != 0; }};
}

// The oblate or prolate at the beginning of a line.
std::optional<PathState> near_the_sphere(const DiagramInput& input, const Line& line,
                                         bool prolate) {
  const axisym::Numerics numerics = input.numerics();
  const axisym::State start{
      axisym::spheroid(line.from.reduced_volume, prolate, numerics.elements, numerics.grading),
      axisym::Field::Constant(3 * numerics.elements + 1, model::full_order)};
  const model::Material material = line.material_at(0);
  auto state = solve_at(material, line.model, line.from,
                        axisym::guess_from(material, line.model, start), {.symmetric = true});
  if (!state) return {};
  return with_tangent(line, {axisym::symmetric_part(*state), 0});
}

// A child's name: the second one of its kind is number 2.
std::string name_of(const std::string& parent, std::map<std::string, int>& counts) {
  const std::string kind = parent == "prolate" ? "pear" : "stomatocyte";
  const int number = ++counts[kind];
  return number == 1 ? kind : fmt::format("{}-{}", kind, number);
}

// Those that leave a symmetric branch; one that comes back to it leaves it once.
void add_children(const DiagramInput& input, const DiagramBranch& parent, Lines& branches) {
  Line open = parent.line;
  open.symmetric = false;
  std::map<std::string, int> counts;
  std::vector<double> returned;
  for (const axisym::SpecialState& loss : parent.trace.specials) {
    if (loss.kind != Special::symmetry_loss || !std::isfinite(loss.error)) continue;
    const double volume = open.at(loss.state.mu).reduced_volume;
    const bool is_known = std::ranges::any_of(
        returned, [&](double end) { return std::abs(end - volume) < near_return; });
    if (is_known) continue;
    const auto start = leaving(open, loss, input.numerics());
    if (!start) continue;
    Trace trace = axisym::trace(open, *start, input.numerics(), options_of(input));
    if (trace.points.empty()) continue;
    std::optional<double> end;
    if (trace.end == axisym::TraceEnd::parent) {
      end = open.at(trace.points.back().state.mu).reduced_volume;
      returned.push_back(*end);
    }
    branches.push_back(
        {name_of(parent.name, counts), parent.name, volume, end, open, std::move(trace)});
  }
}

// The state of the line on a classical branch where that has its W₂: no moment acts there, or a small one. Among minima,
// or among saddles, which the line's own ensemble may make minima.
std::optional<PathState> on_classical(const Line& line, const DiagramBranch& classical,
                                      bool minima) {
  const double wanted = line.material.area_difference.W2;
  const auto W2 = [&](const axisym::TracePoint& p) {
    return diagnose(classical.line.material, p.state).W2;
  };
  const auto& points = classical.trace.points;
  std::optional<PathState> best;
  for (std::size_t k = 1; k < points.size() && !best; ++k) {
    const double before = W2(points[k - 1]), after = W2(points[k]);
    if (points[k - 1].leg != points[k].leg || (points[k].negative_directions == 0) != minima
        || (before - wanted) * (after - wanted) > 0 || before == after)
      continue;
    const double share = (wanted - before) / (after - before);
    const double mu =
        points[k - 1].state.mu + share * (points[k].state.mu - points[k - 1].state.mu);
    const auto there =
        solve_at(line.material_at(mu), line.model, line.at(mu),
                 (share < 0.5 ? points[k - 1] : points[k]).state, {.symmetric = line.symmetric});
    if (there) best = with_tangent(line, {*there, mu});
  }
  return best;
}

}  // namespace

std::vector<DiagramBranch> classical_diagram_branches(const DiagramInput& input) {
  DiagramInput classical = input;
  classical.kind = DiagramKind::spontaneous_curvature;
  classical.modes = 0;
  return branches_at(classical, 0, {});
}

std::vector<DiagramBranch> branches_at(const DiagramInput& input, double value,
                                       const std::vector<DiagramBranch>& classical) {
  Lines branches;
  Line line = input.line(value);
  if (input.kind != DiagramKind::bilayer_coupling) {
    line.symmetric = true;
    for (const bool prolate : {false, true})
      if (const auto start = near_the_sphere(input, line, prolate))
        branches.push_back({prolate ? "prolate" : "oblate",
                            "",
                            line.from.reduced_volume,
                            {},
                            line,
                            axisym::trace(line, *start, input.numerics(), options_of(input))});
  } else {
    for (const DiagramBranch& from : classical) {
      line.symmetric = from.line.symmetric;
      auto start = on_classical(line, from, true);
      if (!start) start = on_classical(line, from, false);
      if (start)
        branches.push_back({from.name,
                            from.from,
                            line.at(start->mu).reduced_volume,
                            {},
                            line,
                            trace_both_ways(line, *start, input.numerics(), options_of(input))});
    }
  }
  const Lines parents = branches;
  for (const DiagramBranch& parent : parents)
    if (parent.line.symmetric) add_children(input, parent, branches);
  return branches;
}

}  // namespace sbeh::studies
