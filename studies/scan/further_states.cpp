#include "studies/scan/further_states.h"

#include "studies/scan/collect.h"
#include "studies/scan/traced_states.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

using axisym::Branch;
using axisym::BranchState;
using axisym::StationaryCase;
using model::Model;

namespace {

// SSH's states of a branch at a reduced volume but the one that stands in scan.csv, which `first` is.
std::vector<BranchState> others(const TracedStates& traced, const StationaryCase& of,
                                const std::optional<double>& first) {
  constexpr double same = 1e-6;
  std::vector<BranchState> states = traced.at(of.branch, of.reduced_volume);
  const auto nearest = std::ranges::min_element(states, {}, [&](const BranchState& state) {
    return std::abs(axisym::diagnose(of.material, state).energy.total() - first.value_or(0));
  });
  if (first && nearest != states.end()
      && std::abs(axisym::diagnose(of.material, *nearest).energy.total() - *first)
             < same * (1 + std::abs(*first)))
    states.erase(nearest);
  return states;
}

// One of them for each model and L.
class FurtherState {
 public:
  FurtherState(const ScanInput& input, PointKey key, int number, const BranchState& state)
      : input_(input), key_(key), number_(number), ssh_{state.at, state} {}

  std::vector<FurtherRow> rows(const std::filesystem::path& folder) {
    if (input_.has(Model::SSH))
      for (const double L : input_.L)
        keep(Model::SSH, L, folder, [&](const auto& of) { return rescale_to(of, ssh_); });
    if (!input_.has(Model::SBEH)) return std::move(rows_);
    std::optional<Neighbour> last;
    for (const double L : input_.L) {
      const bool is_its_own = L == ssh_.at.L || !input_.material.has_given();
      if (!last && !is_its_own) break;
      const auto state = keep(Model::SBEH, L, folder, [&](const auto& of) {
        return last ? follow_to(of, *last) : order_from(of, ssh_.state);
      });
      if (!state) break;
      last = Neighbour{{key_.reduced_volume, L}, *state};
    }
    return std::move(rows_);
  }

 private:
  template <class Compute>
  std::optional<axisym::State> keep(Model model, double L, const std::filesystem::path& folder,
                                    Compute&& compute) {
    key_.model = model;
    key_.L = L;
    const StationaryCase of = case_of(input_, key_);
    PointOutcome point = compute(of);
    if (!has_state_here(point)) return {};
    const bool is_wanted = point.row.status == PointStatus::stationary
                        && point.row.negative_directions.value_or(0) <= *input_.further;
    if (is_wanted) {
      if (input_.modes > 0) add_modes(of, input_.modes, point);
      FurtherRow row{point.row};
      row.key = key_;
      row.number = number_;
      rows_.push_back(row);
      write_profile(folder / "points"
                        / fmt::format("{}_{}-{}_v{}_L{}.csv", sbeh::name(model), name(key_.branch),
                                      number_, key_.reduced_volume, L),
                    *point.state);
    }
    return *point.state;
  }

  const ScanInput& input_;
  PointKey key_;
  int number_;
  Neighbour ssh_;
  std::vector<FurtherRow> rows_;
};

}  // namespace

std::vector<FurtherRow> find_further(const ScanInput& input, const ScanTable& table,
                                     const std::filesystem::path& folder) {
  const double L = input.L.front();
  TracedStates traced(input.material.with_L1(L), input.numerics);
  for (const double volume : input.reduced_volume)
    if (volume != 1) traced.begin_at(volume);
  const std::size_t volumes = input.reduced_volume.size();
  auto rows = collect<FurtherRow>(volumes * input.branches.size(), [&](std::size_t k) {
    const PointKey key{input.reduced_volume[k % volumes], L, Model::SSH,
                       input.branches[k / volumes]};
    std::vector<FurtherRow> found;
    if (key.reduced_volume == 1) return found;
    const StationaryCase of = case_of(input, key);
    std::optional<double> first;
    if (const PointResult* row = table.find(key); row && row->status == PointStatus::stationary) {
      first = row->diagnostics->energy.total();
    } else if (!input.has(Model::SSH)) {
      const PointOutcome computed = branch_point(of);
      if (has_state_here(computed)) first = computed.row.diagnostics->energy.total();
    }
    int number = 1;
    for (const BranchState& state : others(traced, of, first)) {
      const auto some = FurtherState(input, key, ++number, state).rows(folder);
      found.insert(found.end(), some.begin(), some.end());
    }
    return found;
  });
  std::ranges::stable_sort(rows, {}, [](const FurtherRow& row) { return row.key; });
  return rows;
}

const Columns<FurtherRow>& further_columns() {
  static const Columns<FurtherRow> columns = [] {
    Columns<FurtherRow> all;
    for (const Column<PointResult>& one : scan_columns()) {
      all.push_back({one.name, [&one = one](const FurtherRow& row) { return one.write(row); },
                     [&one = one](FurtherRow& row, const std::string& field) {
                       return one.read(row, field);
                     }});
      if (one.name == "branch") all.push_back(column("number", &FurtherRow::number));
    }
    return all;
  }();
  return columns;
}

}  // namespace sbeh::studies
