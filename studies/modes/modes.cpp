#include "studies/modes/modes.h"

#include "axisym/circles.h"
#include "axisym/modes/fluctuations.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/modes/found_modes.h"
#include "studies/scan/branch_points.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::studies {

namespace fs = std::filesystem;
using axisym::StationaryState;

namespace {

// The contour is told up to this m at least: flicker is fitted up to 20 or so.
constexpr int least_contour_m = 20;

// ---- the state ----------------------------------------------------------------------------------

StationaryState state_of_row(const ModesInput& input) {
  constexpr double same = 1e-6;
  const axisym::State profile = state_of(row_of(input));
  const auto found = settled(input.state, profile);
  if (!found || (found->X - profile.X).cwiseAbs().maxCoeff() > same)
    throw OutputError(
        fmt::format("{}: the profile of its row {} is not at rest: compute the scan again",
                    input.scan, text_of(input.state)));
  return *found;
}

StationaryState state_of(const ModesInput& input) {
  if (!input.scan.empty()) return state_of_row(input);
  const PointOutcome point = branch_point(input.state);
  if (point.row.status != PointStatus::stationary)
    throw std::runtime_error(fmt::format("{}: there is no state whose modes could be told: {}",
                                         text_of(input.state), point.row.stop_reason));
  return *point.state;
}

void stop_if_interrupted() {
  if (interrupt_signal() != 0) throw Interrupted("interrupted");
}

// ---- fluctuations -------------------------------------------------------------------------------

// Whether the sign of λ is known, and positive.
bool is_stable(double eigenvalue, double residual) { return eigenvalue > residual; }

std::vector<ContourRow> contour_of(const ModesInput& input, const axisym::SecondVariation& second,
                                   double residual) {
  std::vector<ContourRow> rows;
  for (int m = 0; m <= std::max(input.largest_m, least_contour_m); ++m) {
    stop_if_interrupted();
    ContourRow row{.m = m};
    const auto lowest = axisym::lowest_modes(second, m, 1);
    if (lowest && is_stable(lowest->modes.front().eigenvalue, residual))
      if (const auto variance = axisym::contour_variance(second, m)) {
        row.mean_square = input.thermal_energy * *variance;
        row.spectrum = m == 0 ? row.mean_square : row.mean_square / 2;
      }
    rows.push_back(row);
  }
  return rows;
}

void add_fluctuations(const ModesInput& input, const axisym::SecondVariation& second,
                      ModesSummary& summary) {
  std::set<int> unstable;
  for (const ModeRow& mode : summary.modes) {
    FluctuationRow row{mode.key, mode.eigenvalue};
    if (is_stable(mode.eigenvalue, summary.rigid_residual))
      row.mean_square = input.thermal_energy / mode.eigenvalue;
    else
      unstable.insert(mode.key.m);
    summary.fluctuations.push_back(row);
  }
  summary.contour = contour_of(input, second, summary.rigid_residual);
  summary.largest_radius = axisym::widest_circle(second.state.X, second.state.H).radius;
  if (!unstable.empty())
    summary.warnings.push_back(fmt::format(
        "no equilibrium: the state is no minimum for m = {}, whose fluctuations are left empty; "
        "those of the others are about a state that does not last",
        fmt::join(unstable, ", ")));
  double sum = 0;
  for (const ContourRow& row : summary.contour)
    if (std::isfinite(row.mean_square)) sum += row.mean_square;
  constexpr double small = 0.1;  // of the radius
  if (std::sqrt(sum) > small * summary.largest_radius)
    summary.warnings.push_back(
        fmt::format("the contour fluctuates by {:.2g} of a radius of {:.3g}: too much for an "
                    "energy of second order",
                    std::sqrt(sum), summary.largest_radius));
}

// ---- files --------------------------------------------------------------------------------------

std::string nodes_of(const FoundMode& mode) {
  const axisym::Field s = arc_lengths(mode.state.X);
  std::vector<ModeNode> nodes;
  for (Eigen::Index i = 0; i < s.size(); ++i)
    nodes.push_back({s[i], mode.state.X(0, i), mode.state.X(1, i), mode.state.beta[i], mode.u[i],
                     mode.b[i], mode.energy_u[i], mode.energy_b[i]});
  return table_text(mode_node_columns(), nodes);
}

void write_modes(const OutputFolder& folder, const FoundModes& found,
                 std::vector<std::string>& warnings) {
  make_folder(folder / "modes");
  for (const FoundMode& mode : found.modes) {
    stop_if_interrupted();
    const fs::path file = folder / ("modes/" + stem(mode.key));
    write_file(fs::path(file).concat(".csv"), nodes_of(mode));
    try {
      write_mode(fs::path(file).concat(".vtu"), mode);
    } catch (const std::invalid_argument& error) {
      warnings.push_back(fmt::format("modes/{}.vtu is left out: {}", stem(mode.key), error.what()));
    }
  }
}

}  // namespace

bool ModesSummary::is_resolved() const {
  return std::ranges::none_of(modes, [&](const ModeRow& mode) {
    return std::abs(mode.eigenvalue) <= rigid_residual
        || std::abs(mode.eigenvalue) <= mode.eigenvalue_error;
  });
}

ModesSummary run_modes(const ModesInput& input, const fs::path& path, std::string_view version) {
  const StationaryState state = state_of(input);
  const OutputFolder folder(path);
  begin_or_continue(folder, describe(input, version), "modes.csv", "modes");
  const FoundModes found = find_modes(input, state);
  ModesSummary summary;
  summary.rigid_residual = found.rigid_residual;
  summary.warnings = found.warnings;
  for (const FoundMode& mode : found.modes)
    summary.modes.push_back(
        {mode.key, mode.eigenvalue, mode.rate, mode.eigenvalue_error, mode.rate_error});
  if (input.thermal_energy > 0) add_fluctuations(input, found.second, summary);
  write_modes(folder, found, summary.warnings);
  if (input.thermal_energy > 0) {
    write_file(folder / "fluctuations.csv",
               table_text(fluctuation_columns(), summary.fluctuations));
    write_file(folder / "contour.csv", table_text(contour_columns(), summary.contour));
  }
  write_file(folder / "modes.csv", table_text(mode_columns(), summary.modes));
  return summary;
}

const Columns<ModeRow>& mode_columns() {
  using Row = ModeRow;
  static const Columns<Row> columns{
      column<Row>("m", inside(&Row::key, &ModeKey::m)),
      column<Row>("parity", inside(&Row::key, &ModeKey::parity)),
      column<Row>("number", inside(&Row::key, &ModeKey::number)),
      column("eigenvalue", &Row::eigenvalue),
      known_column("rate", &Row::rate),
      known_column("eigenvalue_error", &Row::eigenvalue_error, "{:.3g}"),
      known_column("rate_error", &Row::rate_error, "{:.3g}"),
  };
  return columns;
}

const Columns<ModeNode>& mode_node_columns() {
  static const Columns<ModeNode> columns{
      column("arc_length", &ModeNode::arc_length),
      column("r", &ModeNode::r),
      column("z", &ModeNode::z),
      column("order", &ModeNode::order),
      column("displacement", &ModeNode::displacement),
      column("order_change", &ModeNode::order_change),
      column("energy_displacement", &ModeNode::energy_displacement),
      column("energy_order_change", &ModeNode::energy_order_change),
  };
  return columns;
}

const Columns<FluctuationRow>& fluctuation_columns() {
  using Row = FluctuationRow;
  static const Columns<Row> columns{
      column<Row>("m", inside(&Row::key, &ModeKey::m)),
      column<Row>("parity", inside(&Row::key, &ModeKey::parity)),
      column<Row>("number", inside(&Row::key, &ModeKey::number)),
      column("eigenvalue", &Row::eigenvalue),
      known_column("mean_square", &Row::mean_square),
  };
  return columns;
}

const Columns<ContourRow>& contour_columns() {
  using Row = ContourRow;
  static const Columns<Row> columns{
      column("m", &Row::m),
      known_column("mean_square", &Row::mean_square),
      known_column("spectrum", &Row::spectrum),
  };
  return columns;
}

namespace {

std::string number_text(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.9g}", value);
}

std::string error_text(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.1e}", value);
}

// What the signs say.
std::string verdict_on(const ModesInput& input, const ModesSummary& summary) {
  if (!summary.is_resolved())
    return "unresolved: an eigenvalue is no farther from 0 than its error or a rigid motion's, so "
           "that its sign is not known; more elements may tell\n";
  std::set<int> unstable;
  int directions = 0;
  for (const ModeRow& mode : summary.modes)
    if (mode.eigenvalue < 0) {
      unstable.insert(mode.key.m);
      directions += mode.key.m == 0 ? 1 : 2;
    }
  if (unstable.empty())
    return fmt::format("stable: a minimum, as modes up to m = {} say\n", input.largest_m);
  return fmt::format("unstable: the energy falls in {} direction{}, of m = {}\n", directions,
                     directions == 1 ? "" : "s", fmt::join(unstable, ", "));
}

}  // namespace

std::string table_of(const ModesInput& input, const ModesSummary& summary) {
  std::string text = text_of(input.state) + "\n";
  text += fmt::format("{:>3}  {:<7}{:>6}{:>18}{:>10}{:>18}{:>10}\n", "m", "parity", "number",
                      "eigenvalue", "error", "rate", "error");
  for (const ModeRow& mode : summary.modes)
    text += fmt::format("{:>3}  {:<7}{:>6}{:>18}{:>10}{:>18}{:>10}\n", mode.key.m,
                        name(mode.key.parity), mode.key.number, number_text(mode.eigenvalue),
                        error_text(mode.eigenvalue_error), number_text(mode.rate),
                        error_text(mode.rate_error));
  text += verdict_on(input, summary);
  text += fmt::format(
      "rigid motions, whose eigenvalue is 0, have {:.1e}: so large at least is the error\n",
      summary.rigid_residual);
  if (!summary.contour.empty())
    text += fmt::format("k_BT = {} is {:.3g} of κ(2/3) = {:.4g}; the contour's radius is {:.6g}\n",
                        input.thermal_energy,
                        input.thermal_energy / input.state.material.kappa(model::full_order),
                        input.state.material.kappa(model::full_order), summary.largest_radius);
  return text;
}

}  // namespace sbeh::studies
