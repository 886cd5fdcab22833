#include "tools/picture/scan/quantity.h"

#include "studies/scan/lowest.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

Mark mark_of(const PointResult* point) {
  if (!point) return Mark::absent;
  switch (point->status) {
    case PointStatus::stationary:
      return Mark::none;
    case PointStatus::limit:
      return Mark::limit;
    case PointStatus::unresolved:
      return Mark::unresolved;
    case PointStatus::failed:
      return Mark::failed;
  }
  return Mark::failed;
}

bool has_value(Mark mark) { return mark == Mark::none || mark == Mark::limit; }

struct Entry {
  double value;
  Mark mark;
  int region;
  bool is_saddle = false;
};
using Value = std::function<Entry(std::size_t volume, std::size_t length)>;

// Index of the point's branch; −1 where there is no state of it.
int branch_index(const ScanGrid& scan, const PointResult* point) {
  if (!has_value(mark_of(point))) return -1;
  return int(std::ranges::find(scan.branches(), sbeh::name(point->key.branch))
             - scan.branches().begin());
}

bool is_saddle(std::optional<int> negative_directions) {
  return negative_directions.value_or(0) > 0;
}
bool is_saddle(const PointResult* point) {
  return point && is_saddle(point->modes.negative_directions);
}

// A quantity without values yet.
struct Kind {
  const char* name;
  std::string title;
  Palette palette;
  studies::Dimension dimension{};
};

Quantity tabulate(const ScanGrid& scan, Kind kind, const Value& value) {
  Quantity quantity{.name = kind.name,
                    .title = std::move(kind.title),
                    .dimension = kind.dimension,
                    .palette = kind.palette};
  for (std::size_t volume = 0; volume < scan.reduced_volumes().size(); ++volume) {
    auto& values = quantity.values.emplace_back();
    auto& marks = quantity.marks.emplace_back();
    auto& regions = quantity.regions.emplace_back();
    auto& saddles = quantity.saddles.emplace_back();
    for (std::size_t length = 0; length < scan.lengths().size(); ++length) {
      auto [number, mark, region, is_saddle] = value(volume, length);
      if (has_value(mark) && !std::isfinite(number))
        mark = mark == Mark::limit ? Mark::singular : Mark::failed;
      values.push_back(has_value(mark) ? number : none);
      marks.push_back(mark);
      regions.push_back(has_value(mark) ? region : -1);
      saddles.push_back(has_value(mark) && is_saddle);
    }
  }
  return quantity;
}

// A quantity of the points that have a state.
template <class Value>
Quantity of_model(const ScanGrid& scan, Model model, Kind kind, Value value) {
  return tabulate(scan, std::move(kind), [&](std::size_t volume, std::size_t length) {
    const PointResult* point = scan.find(model, volume, length);
    return Entry{point && point->diagnostics ? std::invoke(value, *point->diagnostics) : none,
                 mark_of(point), branch_index(scan, point), is_saddle(point)};
  });
}

std::string with_name(const char* title, Model model) {
  return std::string(title) + (model == Model::SBEH ? " (SBEH)" : " (SSH)");
}

}  // namespace

bool Quantity::has(Mark mark) const {
  return std::ranges::any_of(
      marks, [&](const auto& row) { return std::ranges::find(row, mark) != row.end(); });
}

bool Quantity::has_saddle() const {
  return std::ranges::any_of(
      saddles, [&](const auto& row) { return std::ranges::find(row, true) != row.end(); });
}

Range Quantity::range() const {
  Range range;
  for (const auto& row : values)
    for (const double value : row)
      if (std::isfinite(value)) range.include(value);
  return range;
}

std::optional<BranchMap> lowest_branches(const ScanGrid& scan, Model model) {
  BranchMap map{{}, scan.branches(), {}, scan.branches().size()};
  struct Lowest {
    int branch;
    double energy;
    bool is_saddle;
  };
  std::map<std::pair<double, double>, Lowest> lowest;
  for (const studies::LowestRow& row : scan.rows(studies::lowest_columns(), "lowest.csv")) {
    if (row.model != model) continue;
    Lowest& found = lowest[{row.reduced_volume, row.L}];
    found = {-1, row.energy, is_saddle(row.negative_directions_3d)};
    if (row.branch == studies::not_found) continue;
    const auto place = std::ranges::find(map.names, row.branch);
    found.branch = int(place - map.names.begin());
    if (place == map.names.end()) map.names.push_back(row.branch);
  }
  if (map.names.size() < 2) return {};
  map.energies.assign(scan.reduced_volumes().size(),
                      std::vector<double>(scan.lengths().size(), none));
  map.quantity = tabulate(
      scan, {"lowest", with_name("lowest branch", model), energy_palette},
      [&](std::size_t volume, std::size_t length) {
        const auto found = lowest.find({scan.reduced_volumes()[volume], scan.lengths()[length]});
        if (found == lowest.end())
          return Entry{none, mark_of(scan.find(model, volume, length)), -1};
        const auto& [index, energy, is_saddle] = found->second;
        map.energies[volume][length] = energy;
        return Entry{double(index), index < 0 ? Mark::not_found : Mark::none, index, is_saddle};
      });
  return map;
}

void show_lowest(
    const BranchMap& lowest, Quantity& quantity,
    const std::function<double(std::size_t volume, std::size_t length, double energy)>& of_limit) {
  for (std::size_t i = 0; i < quantity.marks.size(); ++i)
    for (std::size_t j = 0; j < quantity.marks[i].size(); ++j) {
      const double branch = lowest.quantity.values[i][j];
      const bool is_limit = branch >= double(lowest.rows_of);
      if (!is_limit && lowest.quantity.marks[i][j] != Mark::not_found) continue;
      const double value = is_limit && of_limit ? of_limit(i, j, lowest.energies[i][j]) : none;
      quantity.values[i][j] = value;
      quantity.saddles[i][j] = false;
      quantity.marks[i][j] = !is_limit            ? Mark::not_found
                           : std::isfinite(value) ? Mark::none
                                                  : Mark::singular;
      // Apart from the regions of all pairs of branches with rows.
      quantity.regions[i][j] =
          std::isfinite(value) ? int(lowest.rows_of * lowest.rows_of) + int(branch) : -1;
    }
}

Quantity energy_gap(const ScanGrid& scan, const std::optional<BranchMap>& lowest) {
  const auto energy_at = [&](Model model, std::size_t volume, std::size_t length) {
    const PointResult* point = scan.find(model, volume, length);
    return has_value(mark_of(point)) ? energy_of(*point) : none;
  };
  Quantity gap = tabulate(
      scan, {"gap", "energy gap U(SSH) − U(SBEH)", energy_palette, studies::dimension::energy},
      [&](std::size_t volume, std::size_t length) {
        const PointResult* ssh = scan.find(Model::SSH, volume, length);
        const PointResult* sbeh = scan.find(Model::SBEH, volume, length);
        const double of_ssh = energy_at(Model::SSH, volume, length),
                     of_sbeh = energy_at(Model::SBEH, volume, length);
        Mark mark = std::max(mark_of(ssh), mark_of(sbeh));
        if (has_value(mark) && studies::is_below(of_ssh, of_sbeh)) mark = Mark::not_found;
        const int region =
            branch_index(scan, sbeh) * int(scan.branches().size()) + branch_index(scan, ssh);
        return Entry{of_ssh - of_sbeh, mark, region, is_saddle(sbeh)};
      });
  if (lowest)
    show_lowest(*lowest, gap, [&](std::size_t volume, std::size_t length, double energy) {
      return energy_at(Model::SSH, volume, length) - energy;
    });
  return gap;
}

Quantity energy(const ScanGrid& scan, Model model, const std::optional<BranchMap>& lowest) {
  Quantity energy =
      of_model(scan, model,
               {"energy", with_name("energy U", model), energy_palette, studies::dimension::energy},
               [](const axisym::Diagnostics& d) { return d.energy.total(); });
  if (lowest) show_lowest(*lowest, energy, [](std::size_t, std::size_t, double of) { return of; });
  return energy;
}

Quantity smallest_order(const ScanGrid& scan, const std::optional<BranchMap>& lowest) {
  Quantity order = of_model(scan, Model::SBEH,
                            {"order", with_name("smallest order β", Model::SBEH), order_palette},
                            &axisym::Diagnostics::order_min);
  if (lowest) show_lowest(*lowest, order);
  return order;
}

Quantity largest_curvature(const ScanGrid& scan, Model model,
                           const std::optional<BranchMap>& lowest) {
  Quantity curvature = of_model(scan, model,
                                {"curvature", with_name("largest |H|", model), curvature_palette,
                                 studies::dimension::curvature},
                                &axisym::Diagnostics::H_abs_max);
  if (lowest) show_lowest(*lowest, curvature);
  return curvature;
}

Quantity in_units(Quantity quantity, const ScanGrid& scan, const Options& options) {
  quantity.title = options.titled(quantity.title, quantity.dimension);
  for (auto& row : quantity.values)
    for (std::size_t length = 0; length < row.size(); ++length)
      row[length] *= options.factor(quantity.dimension, scan.L_of(length));
  return quantity;
}

}  // namespace sbeh::picture
