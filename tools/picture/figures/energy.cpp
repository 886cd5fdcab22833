#include "studies/figures/tables.h"
#include "tools/picture/chart/history.h"
#include "tools/picture/figures/figures.h"

#include <map>
#include <set>
#include <tuple>

namespace sbeh::picture {
namespace {

constexpr double first_time = 1e-4;  // shown; what is earlier looks like the start

struct History {
  std::vector<double> time, energy;
};

}  // namespace

void draw_figure_energy(Canvas& canvas, const Options& options) {
  Histories all{.sbeh = true, .ssh = true};
  std::map<std::tuple<double, double, bool, bool>, History> histories;  // V_r, L, is SSH, in 3D
  std::set<double> volumes, lengths;
  for (const auto& row :
       studies::read_rows(studies::figures::energy_columns(), options.directory / "energy.csv")) {
    const bool in_3d = row.solver == studies::figures::Solver::in_3d;
    const bool is_ssh = row.model == model::Model::SSH;
    volumes.insert(row.reduced_volume);
    lengths.insert(row.L);
    (is_ssh ? all.ssh_3d : all.sbeh_3d) |= in_3d;
    History& history = histories[{row.reduced_volume, row.L, is_ssh, in_3d}];
    if (row.time < first_time) continue;
    history.time.push_back(row.time);
    history.energy.push_back(row.energy);
  }
  all.reduced_volumes.assign(volumes.begin(), volumes.end());
  all.lengths.assign(lengths.begin(), lengths.end());
  for (const auto& [key, history] : histories) {
    const auto& [volume, L, is_ssh, in_3d] = key;
    all.curves.push_back(
        {volume, L, is_ssh, in_3d, over_time(history.time, history.energy, options.energy_shift)});
  }
  draw_histories(canvas, options, all,
                 {.columns = volumes.size(),
                  .width = 1600.0,
                  .height_by_width = 1.1,
                  .gap = 2.0,
                  .above_legend = 0.8});
}

}  // namespace sbeh::picture
