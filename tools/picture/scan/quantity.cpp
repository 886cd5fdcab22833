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
  if (point->status == PointStatus::stationary) return Mark::none;
  return point->status == PointStatus::failed ? Mark::failed : Mark::unresolved;
}

struct Entry {
  double value;
  Mark mark;
  int region;
};
using Value = std::function<Entry(std::size_t volume, std::size_t length)>;

// Index of the point's branch; −1 where there is no stationary state of it.
int branch_index(const ScanGrid& scan, const PointResult* point) {
  if (mark_of(point) != Mark::none) return -1;
  return int(std::ranges::find(scan.branches(), sbeh::name(point->key.branch))
             - scan.branches().begin());
}

Quantity tabulate(const ScanGrid& scan, std::string title, const Value& value) {
  Quantity quantity{.title = std::move(title)};
  for (std::size_t volume = 0; volume < scan.reduced_volumes().size(); ++volume) {
    auto& values = quantity.values.emplace_back();
    auto& marks = quantity.marks.emplace_back();
    auto& regions = quantity.regions.emplace_back();
    for (std::size_t length = 0; length < scan.lengths().size(); ++length) {
      auto [number, mark, region] = value(volume, length);
      if (mark == Mark::none && !std::isfinite(number)) mark = Mark::failed;
      values.push_back(mark == Mark::none || mark == Mark::unresolved ? number : none);
      marks.push_back(mark);
      regions.push_back(mark == Mark::none ? region : -1);
    }
  }
  return quantity;
}

// A quantity of the points that have a state.
template <class Value>
Quantity of_model(const ScanGrid& scan, Model model, std::string title, Value value) {
  return tabulate(scan, std::move(title), [&](std::size_t volume, std::size_t length) {
    const PointResult* point = scan.find(model, volume, length);
    return Entry{point && point->diagnostics ? std::invoke(value, *point->diagnostics) : none,
                 mark_of(point), branch_index(scan, point)};
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

Range Quantity::range() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Range range;
  const auto include = [&](Mark wanted, double from, double to) {
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < values[i].size(); ++j)
        if (const double value = values[i][j];
            marks[i][j] == wanted && value >= from && value <= to)
          range.include(value);
  };
  include(Mark::none, -infinity, infinity);
  const auto [low, high] = range;
  const double far = low <= high ? std::max(2.0 * (high - low), 0.5 * std::abs(high)) : infinity;
  include(Mark::unresolved, low - far, high + far);
  return range.low <= range.high ? range : Range{0.0, 1.0};
}

std::optional<BranchMap> lowest_branches(const ScanGrid& scan,
                                         const std::filesystem::path& directory, Model model) {
  const std::filesystem::path file = directory / "lowest.csv";
  if (!std::filesystem::exists(file)) return {};
  BranchMap map{{}, scan.branches()};
  constexpr int not_found = -1;
  std::map<std::pair<double, double>, int> lowest;
  for (const studies::LowestRow& row : studies::read_rows(studies::lowest_columns(), file)) {
    if (row.model != model) continue;
    int& index = lowest[{row.reduced_volume, row.L}] = not_found;
    if (row.branch == studies::not_found) continue;
    const auto place = std::ranges::find(map.names, row.branch);
    index = int(place - map.names.begin());
    if (place == map.names.end()) map.names.push_back(row.branch);
  }
  if (map.names.size() < 2) return {};
  map.quantity = tabulate(
      scan, with_name("lowest branch", model), [&](std::size_t volume, std::size_t length) {
        const auto found = lowest.find({scan.reduced_volumes()[volume], scan.lengths()[length]});
        if (found != lowest.end())
          return Entry{double(found->second),
                       found->second == not_found ? Mark::not_found : Mark::none, found->second};
        return Entry{none, mark_of(scan.find(model, volume, length)), -1};
      });
  return map;
}

void mark_not_found(const BranchMap& lowest, Quantity& quantity) {
  for (std::size_t i = 0; i < quantity.marks.size(); ++i)
    for (std::size_t j = 0; j < quantity.marks[i].size(); ++j)
      if (lowest.quantity.marks[i][j] == Mark::not_found) {
        quantity.values[i][j] = none;
        quantity.marks[i][j] = Mark::not_found;
        quantity.regions[i][j] = -1;
      }
}

Quantity energy_gap(const ScanGrid& scan) {
  return tabulate(scan, "energy gap U(SSH) − U(SBEH)", [&](std::size_t volume, std::size_t length) {
    const PointResult* ssh = scan.find(Model::SSH, volume, length);
    const PointResult* sbeh = scan.find(Model::SBEH, volume, length);
    Mark mark = std::max(mark_of(ssh), mark_of(sbeh));
    if (mark == Mark::none && studies::is_below(energy_of(*ssh), energy_of(*sbeh)))
      mark = Mark::not_found;
    const int region =
        branch_index(scan, sbeh) * int(scan.branches().size()) + branch_index(scan, ssh);
    return Entry{ssh && sbeh ? energy_of(*ssh) - energy_of(*sbeh) : none, mark, region};
  });
}

Quantity energy(const ScanGrid& scan, Model model) {
  return of_model(scan, model, with_name("energy U", model),
                  [](const axisym::Diagnostics& d) { return d.energy.total(); });
}

Quantity smallest_order(const ScanGrid& scan) {
  return of_model(scan, Model::SBEH, with_name("smallest order β", Model::SBEH),
                  &axisym::Diagnostics::order_min);
}

Quantity largest_curvature(const ScanGrid& scan, Model model) {
  return of_model(scan, model, with_name("largest |H|", model), &axisym::Diagnostics::H_abs_max);
}

}  // namespace sbeh::picture
