#include "studies/scan/branch_lines.h"

#include "axisym/domains.h"
#include "axisym/stationary/stationary.h"
#include "studies/scan/collect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

using model::Model;

namespace {

bool is_stationary(const std::optional<PointOutcome>& point) {
  return point && point->row.status == PointStatus::stationary && point->state;
}

bool is_ours(const ScanInput& input, const axisym::ResolvedState& fold) {
  return input.interfaces == 0 || int(axisym::interfaces(fold.state).size()) == input.interfaces;
}

// The fold along V_r that states with domains have run into at an L.
std::vector<FoldRow> fold_in_volume(const ScanInput& input, axisym::Branch branch, double L,
                                    const PointLookup& point) {
  for (const double v : input.reduced_volume) {
    const auto reached = point({v, L, Model::SBEH, branch});
    if (!reached || !reached->row.fold_reduced_volume || reached->row.fold_side != "at") continue;
    const PointResult& row = reached->row;
    const axisym::Diagnostics& d = *row.diagnostics;
    FoldRow fold{branch, *row.fold_reduced_volume, L, d.energy.total(), d.order_min, d.H_abs_max};
    fold.energy_error = row.error ? row.error->energy : not_known;
    fold.reduced_volume_error = row.fold_reduced_volume_error.value_or(not_known);
    return {fold};
  }
  return {};
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
        axisym::guess_from(input.material.with_L1(*row.fold_L), Model::SBEH, *reached->state));
  }
  const double L = input.L.back();
  const auto last = point({v, L, Model::SBEH, branch});
  const auto fold =
      is_stationary(last) ? fold_above(case_of(input, last->row.key), *last->state) : std::nullopt;
  if (!fold || !is_ours(input, *fold)) return {};
  return fold_at(fold->state.at.L, fold->place_error, fold->diagnostics, fold->error.energy,
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
  const model::Material material = input.material.with_L1(L);
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
  std::vector<FoldRow> rows = collect<FoldRow>(volumes * input.branches.size(), [&](std::size_t k) {
    const double v = input.reduced_volume[k % volumes];
    return v < 1 ? fold_of(input, input.branches[k / volumes], v, point) : std::vector<FoldRow>{};
  });
  if (input.interfaces == 0) return rows;
  for (const axisym::Branch branch : input.branches)
    for (const double L : input.L)
      for (const FoldRow& row : fold_in_volume(input, branch, L, point)) rows.push_back(row);
  return rows;
}

std::vector<EqualEnergyRow> find_equal_energies(const ScanInput& input, const PointLookup& point) {
  const Model model = input.has(Model::SBEH) ? Model::SBEH : Model::SSH;
  return collect<EqualEnergyRow>(
      input.L.size(), [&](std::size_t k) { return meetings_at(input, model, input.L[k], point); });
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
      known_column("reduced_volume_error", &FoldRow::reduced_volume_error, "{:.3g}"),
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

}  // namespace sbeh::studies
