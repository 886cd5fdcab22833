#include "studies/modes/modes.h"

#include "axisym/circles.h"
#include "axisym/modes/fluctuations.h"
#include "axisym/modes/growth_rates.h"
#include "axisym/modes/stability_3d.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/scan/branch_points.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sbeh::studies {

namespace fs = std::filesystem;
using axisym::StationaryState;

namespace {

// The contour is told up to this m at least: flicker is fitted up to 20 or so.
constexpr int least_contour_m = 20;

std::string text_of(const axisym::StationaryCase& of) {
  return fmt::format("{} {}, V_r = {}, L = {}", sbeh::name(of.model), name(of.branch),
                     of.reduced_volume, of.L());
}

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

// ---- its modes ----------------------------------------------------------------------------------

void stop_if_interrupted() {
  if (interrupt_signal() != 0) throw Interrupted("interrupted");
}

// With the eigenfunction of its eigenvalue, ∫(u² + b²) cos² mφ dS = 1.
struct FoundMode : StateMode {
  axisym::Field energy_u, energy_b;
};

struct FoundModes {
  std::vector<FoundMode> modes;  // by m, parity and number
  double rigid_residual = 0;
  std::vector<std::string> warnings;
};

// Those of one m by their numbers: the lowest `most` of each parity, and all that are negative.
std::vector<FoundMode> numbered(const axisym::ModeSpectrum& spectrum, const Physics& physics,
                                const axisym::State& state, int most) {
  std::map<axisym::Parity, int> count;
  std::vector<FoundMode> modes;
  for (const axisym::Eigenmode& of : spectrum.modes) {
    if (count[of.parity] >= most && of.eigenvalue >= 0) continue;
    const ModeKey key{of.m, of.parity, ++count[of.parity]};
    modes.push_back({{physics, state, key, of.eigenvalue, not_known, of.u, of.b}, of.u, of.b});
  }
  std::ranges::stable_sort(modes, {}, [](const StateMode& mode) { return mode.key.parity; });
  return modes;
}

// The largest rates of m, `count` of each parity or at least half of that; none where they are not found.
std::vector<axisym::GrowthMode> rates_of(const axisym::LinearFlow& flow, int m, int count) {
  for (; count > 0; count /= 2)
    if (auto rates = axisym::growth_rates(flow, m, count)) return *rates;
  return {};
}

// The modes of the flow take the place of those of the same number: there are as many that grow as there are
// negative eigenvalues. Those that are not found leave the energy's, without a rate.
void take_rates(const axisym::LinearFlow& flow, std::vector<FoundMode>& modes,
                std::vector<std::string>& warnings) {
  const int m = modes.front().key.m;
  int count = 0;
  for (const StateMode& mode : modes) count = std::max(count, mode.key.number);
  std::map<axisym::Parity, int> taken;
  for (const axisym::GrowthMode& growth : rates_of(flow, m, count)) {
    const int number = ++taken[growth.parity];
    const auto at = std::ranges::find_if(modes, [&](const StateMode& mode) {
      return mode.key.parity == growth.parity && mode.key.number == number;
    });
    if (at == modes.end()) continue;
    at->rate = growth.rate;
    at->u = growth.u;
    if (has_free_order(at->model)) at->b = growth.b;  // otherwise it is 0 but for rounding
  }
  const auto any = [&](auto is) { return std::ranges::any_of(modes, is); };
  if (any([](const StateMode& mode) { return std::isnan(mode.rate); }))
    warnings.push_back(fmt::format("m = {}: not all rates are found", m));
  if (any([](const StateMode& mode) { return mode.rate * mode.eigenvalue > 0; }))
    warnings.push_back(fmt::format(
        "m = {}: rates and eigenvalues contradict each other; more elements may tell", m));
}

FoundModes find_modes(const ModesInput& input, const axisym::SecondVariation& second) {
  FoundModes found;
  const Physics physics{input.state.model, input.state.material};
  const axisym::LinearFlow flow(second, physics.material, physics.model);
  for (int m = 0; m <= input.largest_m; ++m) {
    stop_if_interrupted();
    const auto spectrum = axisym::lowest_and_negative_modes(second, m, input.number);
    if (!spectrum)
      throw std::runtime_error(
          fmt::format("{}: the modes of m = {} are not found: use more elements in [numerics]",
                      text_of(input.state), m));
    found.rigid_residual = std::max(found.rigid_residual, spectrum->rigid_residual);
    std::vector<FoundMode> modes = numbered(*spectrum, physics, second.state, input.number);
    take_rates(flow, modes, found.warnings);
    for (FoundMode& mode : modes) {
      normalise(mode.u, mode.b);
      found.modes.push_back(std::move(mode));
    }
  }
  return found;
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

struct ModeNode {
  double arc_length, r, z, order, displacement, order_change;
  double energy_displacement, energy_order_change;  ///< of the eigenfunction of λ
};
const Columns<ModeNode>& node_columns() {
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

std::string nodes_of(const FoundMode& mode) {
  const axisym::Field s = arc_lengths(mode.state.X);
  std::vector<ModeNode> nodes;
  for (Eigen::Index i = 0; i < s.size(); ++i)
    nodes.push_back({s[i], mode.state.X(0, i), mode.state.X(1, i), mode.state.beta[i], mode.u[i],
                     mode.b[i], mode.energy_u[i], mode.energy_b[i]});
  return table_text(node_columns(), nodes);
}

void write_modes(const OutputFolder& folder, const FoundModes& found) {
  make_folder(folder / "modes");
  for (const FoundMode& mode : found.modes) {
    stop_if_interrupted();
    const fs::path file = folder / ("modes/" + stem(mode.key));
    write_mode(fs::path(file).concat(".vtu"), mode);
    write_file(fs::path(file).concat(".csv"), nodes_of(mode));
  }
}

}  // namespace

bool ModesSummary::is_resolved() const {
  return std::ranges::all_of(
      modes, [&](const ModeRow& mode) { return std::abs(mode.eigenvalue) > rigid_residual; });
}

ModesSummary run_modes(const ModesInput& input, const fs::path& path, std::string_view version) {
  const StationaryState state = state_of(input);
  const OutputFolder folder(path);
  begin_or_continue(folder, describe(input, version), "modes.csv", "modes");
  const axisym::SecondVariation second =
      axisym::second_variation(input.state.material, input.state.model, state);
  const FoundModes found = find_modes(input, second);
  ModesSummary summary;
  summary.rigid_residual = found.rigid_residual;
  summary.warnings = found.warnings;
  for (const FoundMode& mode : found.modes)
    summary.modes.push_back({mode.key, mode.eigenvalue, mode.rate});
  if (input.thermal_energy > 0) add_fluctuations(input, second, summary);
  write_modes(folder, found);
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

// What the signs say.
std::string verdict_on(const ModesInput& input, const ModesSummary& summary) {
  if (!summary.is_resolved())
    return "unresolved: an eigenvalue is no farther from 0 than a rigid motion's, so that its sign "
           "is not known; more elements may tell\n";
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
  text +=
      fmt::format("{:>3}  {:<7}{:>6}{:>18}{:>18}\n", "m", "parity", "number", "eigenvalue", "rate");
  for (const ModeRow& mode : summary.modes)
    text += fmt::format("{:>3}  {:<7}{:>6}{:>18}{:>18}\n", mode.key.m, name(mode.key.parity),
                        mode.key.number, number_text(mode.eigenvalue), number_text(mode.rate));
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
