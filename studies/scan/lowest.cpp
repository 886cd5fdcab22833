#include "studies/scan/lowest.h"

#include "axisym/flow.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace sbeh::studies {

using axisym::RimKind;
using model::Model;

namespace {

// A state of the scan, at its own L.
struct Trial {
  const PointResult* row;
  double L;

  // Its energy at another L. Scaled up, the share of k₀ > 0 counts too much; scaled down, too little: then none, and none with what
  // does not go along with L.
  std::optional<double> energy_at(double other, const model::Material& material) const {
    if (other != L && material.has_given()) return {};
    if (material.residual_stiffness > 0 && other < L) return {};
    const axisym::Energy& energy = row->diagnostics->energy;
    return (energy.distortion + energy.bending) * other / L + energy.thermotropic;
  }
  bool serves(Model model, double other) const {
    const PointKey& key = row->key;
    const bool is_offered =
        key.model == model && L == other && row->status == PointStatus::stationary;
    return !is_offered && (key.model == Model::SSH || key.model == model);
  }
  std::string name(double other) const {
    const PointKey& key = row->key;
    const std::string of = L == other ? "" : fmt::format(" of L = {:.6g}", L);
    return fmt::format("{} {}{}", sbeh::name(key.model), sbeh::name(key.branch), of);
  }
};

// What a row describes, if it is a state of its reduced volume: at rest, or at the fold along L, or of another class than
// the one asked for.
std::optional<Trial> trial_of(const PointResult& row) {
  if (!row.diagnostics || row.self_contact) return {};
  const bool at_fold = row.fold_side == "at";
  if (row.status == PointStatus::unresolved && !at_fold) return {};
  const double volume = 4 * std::numbers::pi / 3 * row.key.reduced_volume;
  if (std::abs(row.diagnostics->volume - volume) > 1e-8 * volume) return {};
  return Trial{&row, at_fold && row.fold_L ? *row.fold_L : row.key.L};
}

class Lowest {
 public:
  Lowest(const StateGrid& grid, const ScanTable& table, const std::vector<RimRow>& beyond)
      : grid_(grid), table_(table), beyond_(beyond) {
    for (const auto& [key, row] : table.rows())
      if (const auto trial = trial_of(row)) trials_[key.reduced_volume].push_back(*trial);
  }

  std::optional<LowestRow> at(Model model, double L, double v) const {
    LowestRow lowest{model, L, v, not_found};
    offer_states(lowest);
    if (model == Model::SBEH) offer_singular(lowest);
    find_bound(lowest);
    if (lowest.branch == not_found && std::isnan(lowest.bound)) return {};
    if (is_below(lowest.bound, lowest.energy)) {
      lowest.branch = not_found;
      lowest.energy = not_known;
      lowest.negative_directions_3d.reset();
    }
    return lowest;
  }

 private:
  static void offer(LowestRow& lowest, const std::string& branch, double energy,
                    std::optional<int> negative_directions_3d = {}) {
    if (lowest.branch != not_found && !(energy < lowest.energy)) return;
    lowest.branch = branch;
    lowest.energy = energy;
    lowest.negative_directions_3d = negative_directions_3d;
  }
  void offer_states(LowestRow& lowest) const {
    for (const axisym::Branch branch : grid_.branches) {
      const PointResult* point =
          table_.find({lowest.reduced_volume, lowest.L, lowest.model, branch});
      if (point && point->status == PointStatus::stationary)
        offer(lowest, name(branch), point->diagnostics->energy.total(),
              point->modes.negative_directions);
    }
  }
  void offer_singular(LowestRow& lowest) const {
    for (const RimRow& state : beyond_)
      if (state.L == lowest.L && state.reduced_volume == lowest.reduced_volume
          && state.resolution <= axisym::largest_resolution) {
        if (state.kind == RimKind::sharp)
          offer(lowest, "sharp_oblate", state.energy, state.modes.negative_directions);
        if (state.kind == RimKind::nested_spheres) offer(lowest, "nested_spheres", state.energy);
      }
  }
  void find_bound(LowestRow& lowest) const {
    const auto trials = trials_.find(lowest.reduced_volume);
    if (trials == trials_.end()) return;
    for (const Trial& trial : trials->second) {
      if (!trial.serves(lowest.model, lowest.L)) continue;
      const auto energy = trial.energy_at(lowest.L, grid_.material);
      if (!energy || *energy >= lowest.bound) continue;
      lowest.bound = *energy;
      lowest.bound_of = trial.name(lowest.L);
    }
  }

  const StateGrid& grid_;
  const ScanTable& table_;
  const std::vector<RimRow>& beyond_;
  std::map<double, std::vector<Trial>> trials_;  // by reduced volume
};

}  // namespace

std::vector<LowestRow> find_lowest(const StateGrid& grid, const ScanTable& table,
                                   const std::vector<RimRow>& beyond) {
  const Lowest lowest(grid, table, beyond);
  std::vector<LowestRow> rows;
  for (const Model model : grid.models)
    for (const double L : grid.L)
      for (const double v : grid.reduced_volume)
        if (const auto row = lowest.at(model, L, v)) rows.push_back(*row);
  return rows;
}

const Columns<LowestRow>& lowest_columns() {
  static const Columns<LowestRow> columns{
      column("model", &LowestRow::model),
      column("L", &LowestRow::L),
      column("reduced_volume", &LowestRow::reduced_volume),
      column("branch", &LowestRow::branch),
      known_column("energy", &LowestRow::energy),
      known_column("bound", &LowestRow::bound),
      column("bound_of", &LowestRow::bound_of),
      column("negative_directions_3d", &LowestRow::negative_directions_3d),
  };
  return columns;
}

}  // namespace sbeh::studies
