#include "studies/diagram/diagram_branches.h"

#include "axisym/diagnostics.h"
#include "axisym/stationary/stationary.h"
#include "studies/io/interrupt.h"

#include <optional>

namespace sbeh::studies {

using axisym::Line;
using axisym::PathState;

namespace {

using Lines = std::vector<DiagramBranch>;

axisym::TraceOptions options_of(const DiagramInput& input) {
  return {.largest_m = input.modes, .stops = [] { return interrupt_signal() != 0; }};
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
  const axisym::Numerics numerics = input.numerics();
  const axisym::TraceOptions options = options_of(input);
  Lines branches;
  Line line = input.line(value);
  if (input.kind != DiagramKind::bilayer_coupling) {
    branches = axisym::traced_from_sphere(line, numerics, options);
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
                            trace_both_ways(line, *start, numerics, options)});
    }
  }
  axisym::add_leaving(branches, numerics, options);
  return branches;
}

}  // namespace sbeh::studies
