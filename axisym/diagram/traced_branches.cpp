#include "axisym/diagram/traced_branches.h"

#include "axisym/start_shapes.h"
#include "axisym/stationary/stationary.h"
#include "axisym/stationary/symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sbeh::axisym {

namespace {

// The oblate or prolate at the beginning of a line.
std::optional<PathState> near_the_sphere(const Line& line, const Numerics& numerics, bool prolate) {
  const State start{
      spheroid(line.from.reduced_volume, prolate, numerics.elements, numerics.grading),
      Field::Constant(3 * numerics.elements + 1, model::full_order)};
  const model::Material material = line.material_at(0);
  auto state = solve_at(material, line.model, line.from, guess_from(material, line.model, start),
                        {.symmetric = true});
  if (!state) return {};
  return with_tangent(line, {symmetric_part(*state), 0});
}

// A child's name: the second one of its kind is number 2.
std::string name_of(const std::string& parent, std::map<std::string, int>& counts) {
  const std::string kind = parent == "prolate" ? "pear" : "stomatocyte";
  const int number = ++counts[kind];
  return number == 1 ? kind : fmt::format("{}-{}", kind, number);
}

// Those that leave a symmetric branch; one that comes back to it leaves it once.
void add_children(const TracedBranch& parent, const Numerics& numerics, const TraceOptions& options,
                  std::vector<TracedBranch>& branches) {
  Line open = parent.line;
  open.symmetric = false;
  std::map<std::string, int> counts;
  std::vector<double> returned;
  for (const SpecialState& loss : parent.trace.specials) {
    if (loss.kind != Special::symmetry_loss || !std::isfinite(loss.error)) continue;
    const double volume = open.at(loss.state.mu).reduced_volume;
    const bool is_known = std::ranges::any_of(
        returned, [&](double end) { return std::abs(end - volume) < near_return; });
    if (is_known) continue;
    const auto start = leaving(open, loss, numerics);
    if (!start) continue;
    Trace way = trace(open, *start, numerics, options);
    if (way.points.empty()) continue;
    std::optional<double> end;
    if (way.end == TraceEnd::parent) {
      end = open.at(way.points.back().state.mu).reduced_volume;
      returned.push_back(*end);
    }
    branches.push_back(
        {name_of(parent.name, counts), parent.name, volume, end, open, std::move(way)});
  }
}

}  // namespace

std::vector<TracedBranch> traced_from_sphere(Line line, const Numerics& numerics,
                                             const TraceOptions& options) {
  line.symmetric = true;
  std::vector<TracedBranch> branches;
  for (const bool prolate : {false, true})
    if (const auto start = near_the_sphere(line, numerics, prolate))
      branches.push_back({prolate ? "prolate" : "oblate",
                          "",
                          line.from.reduced_volume,
                          {},
                          line,
                          trace(line, *start, numerics, options)});
  return branches;
}

void add_leaving(std::vector<TracedBranch>& branches, const Numerics& numerics,
                 const TraceOptions& options) {
  const std::vector<TracedBranch> parents = branches;
  for (const TracedBranch& parent : parents)
    if (parent.line.symmetric) add_children(parent, numerics, options, branches);
}

}  // namespace sbeh::axisym
