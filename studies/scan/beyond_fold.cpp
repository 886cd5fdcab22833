#include "studies/scan/beyond_fold.h"

#include "axisym/redistribute.h"
#include "axisym/rim/nested_spheres.h"
#include "axisym/stationary/accuracy.h"
#include "axisym/stationary/symmetry.h"
#include "studies/scan/collect.h"
#include "studies/scan/lowest.h"
#include "studies/scan/mode_columns.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::studies {

using axisym::RimKind;
using axisym::RimRecord;
using model::Model;

namespace {

// The same state over P3 elements with their nodes where the curvature is; empty where these do not resolve it.
std::optional<axisym::StationaryState> on_elements(const ScanInput& input, const RimRecord& row) {
  const axisym::Numerics& numerics = input.numerics;
  const auto guess = axisym::guess_from(input.material.with_L1(row.L), Model::SBEH, row.state);
  const auto placed = redistribute(guess, numerics.grading, 2 * numerics.elements);
  const auto there = axisym::solve_at(input.material, Model::SBEH, {row.reduced_volume, row.L},
                                      placed, {.symmetric = true});
  if (!there) return {};
  const auto fine = axisym::resolved(input.material, Model::SBEH, *there, numerics);
  const double energy = fine.diagnostics.energy.total();
  const bool is_same = !is_below(energy, row.energy) && !is_below(row.energy, energy);
  if (!fine.is_resolved || fine.diagnostics.resolution > axisym::largest_resolution || !is_same)
    return {};
  return fine.state;
}

// All but what rigid motions leave is not known where that is no small share of the least eigenvalue.
axisym::Stability3d trusted(const axisym::Stability3d& modes) {
  constexpr double share = 0.01;
  double least = std::numeric_limits<double>::infinity();
  for (const double eigenvalue : modes.eigenvalue)
    if (!std::isnan(eigenvalue)) least = std::min(least, std::abs(eigenvalue));
  if (modes.rigid_residual <= share * least) return modes;
  axisym::Stability3d unknown;
  unknown.rigid_residual = modes.rigid_residual;
  return unknown;
}

RimRow with_stability(const ScanInput& input, const RimRecord& record) {
  RimRow row{record};
  const bool has_modes = input.modes > 0 && record.order_rim > 0
                      && (record.kind == RimKind::saddle || record.kind == RimKind::sharp
                          || record.kind == RimKind::equal_energy);
  if (!has_modes) return row;
  if (const auto state = on_elements(input, record))
    if (const auto modes = axisym::stability_3d(input.material.with_L1(record.L), Model::SBEH,
                                                *state, input.modes))
      row.modes = trusted(*modes);
  return row;
}

}  // namespace

std::vector<RimRow> find_beyond_fold(const ScanInput& input, const std::vector<FoldRow>& folds) {
  constexpr double reach = 2;  // sharp rims are lower than smooth ones from half the fold's L on
  std::vector<RimRow> rows = collect<RimRow>(folds.size(), [&](std::size_t k) {
    const FoldRow& fold = folds[k];
    std::vector<RimRow> found;
    if (fold.branch == axisym::Branch::oblate && fold.L <= reach * input.L.back()
        && fold.reduced_volume > 0.51)
      for (const RimRecord& record :
           axisym::beyond_fold(input.material, fold.reduced_volume, input.L))
        found.push_back(with_stability(input, record));
    return found;
  });
  if (std::ranges::find(input.branches, axisym::Branch::stomatocyte) != input.branches.end())
    for (const double v : input.reduced_volume)
      for (const double L : input.L)
        if (v < 1) rows.push_back({axisym::nested_spheres(input.material, v, L)});
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

const Columns<RimRow>& rim_columns() {
  using Row = RimRow;
  static const Columns<Row> columns{
      column<Row>("reduced_volume", &Row::reduced_volume),
      column<Row>("L", &Row::L),
      column<Row>("kind", &Row::kind),
      column<Row>("energy", &Row::energy),
      column<Row>("order_rim", &Row::order_rim),
      column<Row>("H_rim", &Row::H_rim),
      column<Row>("H_abs_max", &Row::H_abs_max),
      column<Row>("resolution", &Row::resolution),
      derived_column<Row>("status",
                          [](const Row& row) -> std::string {
                            if (row.kind == axisym::RimKind::nested_spheres) return "limit";
                            return name(row.resolution > axisym::largest_resolution
                                            ? PointStatus::unresolved
                                            : PointStatus::stationary);
                          }),
      column<Row>("jump", &Row::jump),
      column<Row>("pressure", &Row::pressure),
      column<Row>("negative_directions", &Row::negative_directions),
  };
  static const Columns<Row> all = with_modes(columns);
  return all;
}

}  // namespace sbeh::studies
