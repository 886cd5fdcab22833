#include "studies/scan/branch_lines.h"

#include "axisym/rim/nested_spheres.h"
#include "axisym/stationary/stationary.h"
#include "studies/scan/collect.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

using axisym::RimRecord;
using model::Model;

namespace {

bool is_stationary(const std::optional<PointOutcome>& point) {
  return point && point->row.status == PointStatus::stationary && point->state;
}

// The fold that the scan has run into, or else the one ahead of its largest L.
std::vector<FoldRow> fold_of(const ScanInput& input, axisym::Branch branch, double v,
                             const PointLookup& point) {
  const auto fold_at = [&](double L, double L_error, const axisym::Diagnostics& d, double error,
                           const auto& state) {
    return std::vector<FoldRow>{{branch, v, L, d.energy.total(), d.order_min, d.H_abs_max,
                                 axisym::fold_kind(input.material, L, state), L_error, error}};
  };
  for (const double L : input.L) {
    const auto reached = point({v, L, Model::SBEH, branch});
    if (!reached || reached->row.fold_side != "at" || !reached->row.fold_L) continue;
    const PointResult& row = reached->row;
    return fold_at(
        *row.fold_L, row.fold_L_error.value_or(not_known), *row.diagnostics,
        row.error ? row.error->energy : not_known,
        axisym::guess_from(input.material.with_L(*row.fold_L), Model::SBEH, *reached->state));
  }
  const double L = input.L.back();
  const auto last = point({v, L, Model::SBEH, branch});
  const auto fold =
      is_stationary(last) ? fold_above(case_of(input, last->row.key), *last->state) : std::nullopt;
  if (!fold) return {};
  return fold_at(fold->state.at.L, fold->L_error, fold->diagnostics, fold->error.energy,
                 fold->state);
}

// Newton on the difference of two branches' energies, from states at the same reduced volume.
std::optional<EqualEnergyRow> meet(const ScanInput& input, const PointOutcome& first,
                                   const PointOutcome& second, double lowest, double highest) {
  const std::array<const PointOutcome*, 2> points{&first, &second};
  std::array<std::optional<axisym::BranchState>, 2> states;
  for (std::size_t k = 0; k < 2; ++k) {
    states[k] = settled(case_of(input, points[k]->row.key), *points[k]->state);
    if (!states[k]) return {};
  }
  auto [v, L, model, branch] = first.row.key;
  const model::Material material = input.material.with_L(L);
  for (int iteration = 0; iteration < 10; ++iteration) {
    std::array<double, 2> energy{};
    for (std::size_t k = 0; k < 2; ++k)
      energy[k] = axisym::diagnose(material, *states[k]).energy.total();
    const double slope = (states[0]->pressure - states[1]->pressure)
                       * (axisym::target_of(1).volume - axisym::target_of(0).volume);
    const double step = (energy[0] - energy[1]) / slope;
    if (std::abs(step) < 1e-9)
      return EqualEnergyRow{branch, second.row.key.branch, L, v, energy[0]};
    v = std::clamp(v - step, lowest, highest);
    for (auto& state : states) {
      const auto moved = axisym::follow(input.material, model, *state, {v, L}, input.numerics);
      if (moved.arrival != axisym::Arrival::reached) return {};
      state = moved.state;
    }
  }
  return {};
}

std::vector<EqualEnergyRow> meetings_at(const ScanInput& input, Model model, double L,
                                        const PointLookup& point) {
  std::vector<EqualEnergyRow> rows;
  const auto& branches = input.branches;
  for (std::size_t i = 0; i < branches.size(); ++i)
    for (std::size_t j = i + 1; j < branches.size(); ++j) {
      double gap_before = 0, v_before = 0;
      for (const double v : input.reduced_volume) {
        const auto a = point({v, L, model, branches[i]}), b = point({v, L, model, branches[j]});
        if (v == 1 || !is_stationary(a) || !is_stationary(b)) {
          gap_before = 0;
          continue;
        }
        const double gap = a->row.diagnostics->energy.total() - b->row.diagnostics->energy.total();
        if (gap * gap_before < 0)
          if (const auto row = meet(input, *a, *b, v_before, v)) rows.push_back(*row);
        gap_before = gap;
        v_before = v;
      }
    }
  return rows;
}

}  // namespace

std::vector<FoldRow> find_folds(const ScanInput& input, const PointLookup& point) {
  const std::size_t volumes = input.reduced_volume.size();
  return collect<FoldRow>(volumes * input.branches.size(), [&](std::size_t k) {
    const double v = input.reduced_volume[k % volumes];
    return v < 1 ? fold_of(input, input.branches[k / volumes], v, point) : std::vector<FoldRow>{};
  });
}

std::vector<EqualEnergyRow> find_equal_energies(const ScanInput& input, const PointLookup& point) {
  const Model model = input.has(Model::SBEH) ? Model::SBEH : Model::SSH;
  return collect<EqualEnergyRow>(
      input.L.size(), [&](std::size_t k) { return meetings_at(input, model, input.L[k], point); });
}

std::vector<RimRecord> find_beyond_fold(const ScanInput& input, const std::vector<FoldRow>& folds) {
  constexpr double reach = 2;  // sharp rims are lower than smooth ones from half the fold's L on
  std::vector<RimRecord> rows = collect<RimRecord>(folds.size(), [&](std::size_t k) {
    const FoldRow& fold = folds[k];
    const bool is_near = fold.branch == axisym::Branch::oblate && fold.L <= reach * input.L.back()
                      && fold.reduced_volume > 0.51;
    return is_near ? axisym::beyond_fold(input.material, fold.reduced_volume, input.L)
                   : std::vector<RimRecord>{};
  });
  if (std::ranges::find(input.branches, axisym::Branch::stomatocyte) != input.branches.end())
    for (const double v : input.reduced_volume)
      for (const double L : input.L)
        if (v < 1) rows.push_back(axisym::nested_spheres(input.material, v, L));
  return rows;
}

std::string stem(const RimRecord& row) {
  return fmt::format("{}_v{}_L{}", sbeh::name(row.kind), row.reduced_volume, row.L);
}

std::string profile_text(const axisym::State& state) {
  const Columns<ProfileRow>& all = profile_columns();
  std::vector<ProfileRow> rows;
  double s = 0;
  for (Eigen::Index i = 0; i < state.beta.size(); ++i) {
    if (i > 0) s += (state.X.col(i) - state.X.col(i - 1)).norm();
    rows.push_back({s, state.X(0, i), state.X(1, i), state.beta[i], not_known});
  }
  return table_text(Columns<ProfileRow>(all.begin(), all.end() - 1), rows);
}

const Columns<FoldRow>& fold_columns() {
  static const Columns<FoldRow> columns{
      column("reduced_volume", &FoldRow::reduced_volume),
      column("L", &FoldRow::L),
      column("energy", &FoldRow::energy),
      column("order_min", &FoldRow::order_min),
      column("H_abs_max", &FoldRow::H_abs_max),
      column("branch", &FoldRow::branch),
      column("kind", &FoldRow::kind),
      known_column("L_error", &FoldRow::L_error, "{:.3g}"),
      known_column("energy_error", &FoldRow::energy_error, "{:.3g}"),
  };
  return columns;
}

const Columns<EqualEnergyRow>& equal_energy_columns() {
  static const Columns<EqualEnergyRow> columns{
      column("first", &EqualEnergyRow::first),
      column("second", &EqualEnergyRow::second),
      column("L", &EqualEnergyRow::L),
      column("reduced_volume", &EqualEnergyRow::reduced_volume),
      column("energy", &EqualEnergyRow::energy),
  };
  return columns;
}

const Columns<RimRecord>& rim_columns() {
  static const Columns<RimRecord> columns{
      column("reduced_volume", &RimRecord::reduced_volume),
      column("L", &RimRecord::L),
      column("kind", &RimRecord::kind),
      column("energy", &RimRecord::energy),
      column("order_rim", &RimRecord::order_rim),
      column("H_rim", &RimRecord::H_rim),
      column("H_abs_max", &RimRecord::H_abs_max),
      column("resolution", &RimRecord::resolution),
      derived_column<RimRecord>("status",
                                [](const RimRecord& row) -> std::string {
                                  if (row.kind == axisym::RimKind::nested_spheres) return "limit";
                                  return name(row.resolution > axisym::largest_resolution
                                                  ? PointStatus::unresolved
                                                  : PointStatus::stationary);
                                }),
      column("jump", &RimRecord::jump),
      column("pressure", &RimRecord::pressure),
      column("negative_directions", &RimRecord::negative_directions),
  };
  return columns;
}

}  // namespace sbeh::studies
