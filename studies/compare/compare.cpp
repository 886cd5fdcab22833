#include "studies/compare/compare.h"

#include "model/time/step_control.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/stopwatch.h"
#include "studies/witnesses/evolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// ---- the methods --------------------------------------------------------------------------------

// What the first state that has such a part has of it; null where none has.
template <class Part>
const Part* first_of(const std::vector<WitnessState>& states,
                     std::optional<Part> WitnessState::*part) {
  for (const WitnessState& state : states)
    if (state.*part) return &*(state.*part);
  return nullptr;
}

WitnessState state_of(Witness witness, const CompareInput& input,
                      const std::vector<WitnessState>& before, const fs::path& frame) {
  switch (witness) {
    case Witness::newton:
      return newton_state(input.state);
    case Witness::shooting:
      return shooting_state(input.state);
    case Witness::minimiser:
      return minimiser_state(input.state);
    case Witness::flow:
      return flow_state(input.state, history_times(input.surface3d));
    case Witness::surface3d:
      return surface_state(input.state, input.surface3d, first_of(before, &WitnessState::profile),
                           frame);
    case Witness::states:
      return rest_state(input.state, input.surface3d.triangles,
                        first_of(before, &WitnessState::profile));
    case Witness::harmonics:
      return harmonic_state(input.state, input.harmonics, first_of(before, &WitnessState::mesh));
    case Witness::harmonic_flow:
      break;
  }
  return {};
}

WitnessState evolution_of(Witness witness, const CompareInput& input) {
  const EvolutionCase& of = *input.evolution;
  if (witness == Witness::harmonic_flow) return evolution_by_harmonics(of.run, input.harmonic_flow);
  return of.has_ended() ? evolution_of_folder(of.run, of.file) : evolution_on_triangles(of.run);
}

std::vector<WitnessState> states_of(const CompareInput& input, const fs::path& frame) {
  std::vector<WitnessState> states;
  for (const Witness witness : input.methods) {
    const Stopwatch watch;
    states.push_back(input.evolution ? evolution_of(witness, input)
                                     : state_of(witness, input, states, frame));
    states.back().seconds = watch.seconds();
    if (interrupt_signal()) throw Interrupted("interrupted");
  }
  return states;
}

// ---- profiles -----------------------------------------------------------------------------------

// Moves points along the axis to where they are nearest to the curve, by least squares.
void align(Eigen::Matrix2Xd& points, const Meridian& curve) {
  for (int iteration = 0; iteration < 8; ++iteration) {
    double weight = 0, sum = 0;
    for (const auto x : points.colwise()) {
      const double t = curve.nearest(x);
      const double n_z = curve.tangent(t).normalized()[0];
      weight += n_z * n_z;
      sum += n_z * curve.normal_distance(t, x);
    }
    points.row(1).array() -= sum / weight;
    if (std::abs(sum / weight) < 1e-12) break;
  }
}

double distance_of(const WitnessState& a, const WitnessState& b) {
  if (a.meridian && b.meridian) return distance(*a.meridian, *b.meridian);
  return a.meridian ? distance(b.points, *a.meridian) : distance(a.points, *b.meridian);
}

// Largest difference at the times that both have; not_known where there are none.
double history_difference(const WitnessState& a, const WitnessState& b) {
  double largest = not_known;
  for (const EnergyAt& p : a.history)
    for (const EnergyAt& q : b.history)
      if (p.time > 0 && std::abs(p.time - q.time) <= model::same_time * p.time)
        largest = std::fmax(largest, std::abs(p.energy - q.energy));
  return largest;
}

// Nodes by their arc length, which are in no order of their own.
std::vector<PlacedPoint> placed(const WitnessState& state, const Meridian& reference) {
  std::vector<PlacedPoint> points;
  for (Eigen::Index i = 0; i < state.points.cols(); ++i) {
    const Eigen::Vector2d x = state.points.col(i);
    const double t = reference.nearest(x);
    const bool own = &reference == (state.meridian ? &*state.meridian : nullptr);
    points.push_back({state.witness, reference.arc_length(t), x[0], x[1], state.order[i],
                      own ? 0 : reference.normal_distance(t, x)});
  }
  if (!state.meridian) std::ranges::sort(points, {}, &PlacedPoint::arc_length);
  return points;
}

// ---- comparisons --------------------------------------------------------------------------------

std::optional<double> tolerance_of(const CompareInput& input, const Comparison& of) {
  const bool in_3d = is_in_3d(of.first) || is_in_3d(of.second);
  const Tolerances& tolerances = in_3d ? input.tolerance_3d : input.tolerance;
  const auto at = tolerances.find(of.quantity);
  return at == tolerances.end() ? std::nullopt : std::optional(at->second);
}

std::vector<Comparison> compare(const CompareInput& input, const WitnessState& a,
                                const WitnessState& b) {
  std::vector<Comparison> all;
  const auto add = [&](const char* quantity) -> Comparison& {
    return all.emplace_back(
        Comparison{.quantity = quantity, .first = a.witness, .second = b.witness});
  };
  for (const Quantity& quantity : quantities()) {
    Comparison& one = add(quantity.name);
    one.first_value = a.measures.*quantity.value;
    one.second_value = b.measures.*quantity.value;
    one.difference = std::abs(one.first_value - one.second_value);
    if (quantity.is_energy) one.relative_difference = one.difference / std::abs(a.measures.energy);
  }
  if (a.meridian || b.meridian) add("distance").difference = distance_of(a, b);
  if (!a.history.empty() && !b.history.empty()) {
    Comparison& history = add("history");
    history.difference = history_difference(a, b);
    history.relative_difference = history.difference / std::abs(a.measures.energy);
  }
  for (Comparison& one : all) one.tolerance = tolerance_of(input, one);
  return all;
}

// ---- tables -------------------------------------------------------------------------------------

std::vector<PlacedPoint> all_placed(const std::vector<WitnessState>& states) {
  std::vector<PlacedPoint> points;
  if (const Meridian* reference = first_of(states, &WitnessState::meridian))
    for (const WitnessState& state : states)
      for (const PlacedPoint& point : placed(state, *reference)) points.push_back(point);
  return points;
}

void write_tables(const OutputFolder& folder, const CompareSummary& summary) {
  const auto write = [&](std::string_view name, const auto& columns, const auto& rows) {
    write_file(folder / name, table_text(columns, rows));
  };
  if (const auto points = all_placed(summary.states); !points.empty())
    write("profiles.csv", placed_columns(), points);
  write("methods.csv", method_columns(), summary.states);
  std::vector<HistoryRow> histories;
  for (const WitnessState& state : summary.states)
    for (const EnergyAt& at : state.history) histories.push_back({state.witness, at});
  if (!histories.empty()) write("histories.csv", history_columns(), histories);
  write("compare.csv", comparison_columns(), summary.comparisons);
}

// ---- tables for people --------------------------------------------------------------------------

constexpr int name_width = 20, cell_width = 18;
std::string cell(double value, const char* format) {
  return fmt::format("{:>{}}", std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value),
                     cell_width);
}

std::string values_for_people(const std::vector<WitnessState>& states) {
  std::string text = fmt::format("{:<{}}", "", name_width);
  for (const WitnessState& state : states)
    text += fmt::format("{:>{}}", name(state.witness), cell_width);
  for (const Quantity& quantity : quantities()) {
    text += fmt::format("\n{:<{}}", quantity.name, name_width);
    for (const WitnessState& state : states)
      text += cell(state.measures.*quantity.value, "{:.11g}");
  }
  text += fmt::format("\n{:<{}}", "seconds", name_width);
  for (const WitnessState& state : states) text += cell(state.seconds, "{:.3g}");
  return text + "\n";
}

// Those of all others from the first; the history, which few pairs have, stands elsewhere.
std::string differences_for_people(const CompareSummary& summary) {
  const Witness reference = summary.states.front().witness;
  std::string text =
      fmt::format("differences from {} (energies: relative to the total; ! tolerance missed)\n",
                  name(reference));
  for (const std::string& quantity : tolerated_quantities()) {
    if (quantity == "history") continue;
    text += fmt::format("{:<{}}{:>{}}", quantity, name_width, "", cell_width);
    for (const WitnessState& state : summary.states) {
      if (state.witness == reference) continue;
      const auto at = std::find_if(
          summary.comparisons.begin(), summary.comparisons.end(), [&](const Comparison& c) {
            return c.quantity == quantity && c.first == reference && c.second == state.witness;
          });
      const bool there = at != summary.comparisons.end();
      text += cell(there ? at->judged() : not_known, there && at->misses() ? "! {:.2e}" : "{:.2e}");
    }
    text += "\n";
  }
  return text;
}

}  // namespace

double Comparison::judged() const {
  return std::isnan(relative_difference) ? difference : relative_difference;
}

bool Comparison::misses() const { return tolerance && !(judged() <= *tolerance); }

bool CompareSummary::agrees() const { return complaints(*this).empty(); }

CompareSummary run_compare(const CompareInput& input, const fs::path& path,
                           std::string_view version) {
  const OutputFolder folder(path);
  refuse_results(folder, {"run.toml", "compare.csv", "scan.csv", "series.csv", "branches.csv"});
  CompareSummary summary{.states = states_of(input, folder / "surface3d.vtu"), .comparisons = {}};
  std::vector<WitnessState>& states = summary.states;
  if (const Meridian* reference = first_of(states, &WitnessState::meridian))
    for (WitnessState& state : states)
      if (!state.meridian && state.points.size() > 0) align(state.points, *reference);
  for (std::size_t i = 0; i < states.size(); ++i)
    for (std::size_t j = i + 1; j < states.size(); ++j)
      if (states[i].failure.empty() && states[j].failure.empty())
        for (const Comparison& one : compare(input, states[i], states[j]))
          summary.comparisons.push_back(one);
  write_tables(folder, summary);
  write_file(folder / "run.toml", describe(input, version));
  return summary;
}

std::string table_of(const CompareSummary& summary) {
  std::string text = values_for_people(summary.states) + "\n" + differences_for_people(summary);
  for (const Comparison& c : summary.comparisons)
    if (c.quantity == "history")
      text += fmt::format("energies of {} and {} over time differ by {:.2e} of the last one{}\n",
                          name(c.first), name(c.second), c.judged(), c.misses() ? " !" : "");
  for (const WitnessState& state : summary.states)
    if (!state.remark.empty()) text += fmt::format("{}: {}\n", name(state.witness), state.remark);
  return text;
}

std::vector<std::string> complaints(const CompareSummary& summary) {
  std::vector<std::string> sentences;
  for (const WitnessState& state : summary.states)
    if (!state.failure.empty())
      sentences.push_back(fmt::format("{} has no state: {}", name(state.witness), state.failure));
  for (const Comparison& c : summary.comparisons) {
    if (!c.misses()) continue;
    const std::string first = name(c.first), second = name(c.second);
    const std::string values =
        c.quantity == "distance" || c.quantity == "history"
            ? fmt::format("of {} and {}", first, second)
            : fmt::format("{} by {}, {} by {}", c.first_value, first, c.second_value, second);
    sentences.push_back(
        std::isnan(c.judged())
            ? fmt::format(
                "{}: not known of both {} and {}, so that its tolerance {} cannot be judged",
                c.quantity, first, second, *c.tolerance)
            : fmt::format("{}: {}: the {}difference {:.3g} is more than the tolerance {}",
                          c.quantity, values, std::isnan(c.relative_difference) ? "" : "relative ",
                          c.judged(), *c.tolerance));
  }
  return sentences;
}

}  // namespace sbeh::studies
