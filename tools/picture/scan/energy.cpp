#include "studies/states/series_file.h"
#include "tools/picture/chart/history.h"
#include "tools/picture/scan/scan.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_panels = 6;
constexpr std::size_t most_lengths = 8;

Points energy_over_time(const std::filesystem::path& series, double L, const Options& options) {
  const double of_time = options.factor(studies::dimension::time, L),
               of_energy = options.factor(studies::dimension::energy, L);
  std::vector<double> time, energy;
  for (const studies::SeriesRow& row : studies::read_rows(studies::series_columns(), series)) {
    time.push_back(of_time * row.record.time);
    energy.push_back(of_energy * row.record.energy.total());
  }
  return over_time(time, energy, of_energy * options.energy_shift);
}

Histories read_histories(const ScanGrid& scan, const Options& options) {
  Histories all{.sbeh = scan.has(Model::SBEH), .ssh = scan.has(Model::SSH)};
  const auto lengths = evenly_spread(scan.lengths().size(), most_lengths);
  for (const std::size_t l : lengths) all.lengths.push_back(scan.lengths()[l]);
  for (const std::size_t v : evenly_spread(scan.reduced_volumes().size(), most_panels)) {
    const double volume = all.reduced_volumes.emplace_back(scan.reduced_volumes()[v]);
    for (const std::size_t l : lengths)
      for (const Model model : {Model::SBEH, Model::SSH}) {
        const PointResult* point = scan.find(model, v, l);
        if (!point || !std::filesystem::exists(scan.series(*point))) continue;
        Points points = energy_over_time(scan.series(*point), scan.lengths()[l], options);
        if (points.size() > 1)
          all.curves.push_back(
              {volume, scan.lengths()[l], model == Model::SSH, false, std::move(points)});
      }
  }
  return all;
}

}  // namespace

void draw_energy_picture(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  if (!scan.has_series()) {
    if (!options.only.empty()) fmt::print("no energy: the scan has left no energies over time\n");
    return;
  }
  const Histories all = read_histories(scan, options);
  if (all.curves.empty()) {
    fmt::print("no energy: no history has two rows\n");
    return;
  }
  const std::size_t count = all.reduced_volumes.size();
  const std::size_t columns = count == 4 ? 2 : std::min<std::size_t>(count, 3);
  draw_histories(canvas, options, all,
                 {.columns = columns,
                  .width = columns == 1 ? 900.0 : 1600.0,
                  .height_by_width = 0.85,
                  .gap = 2.6,
                  .above_legend = 0.6});
}

}  // namespace sbeh::picture
