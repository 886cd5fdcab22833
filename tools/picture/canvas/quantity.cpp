#include "tools/picture/canvas/quantity.h"

#include "tools/picture/canvas/csv.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Mark mark_of(const ScanPoint* point) {
  if (!point) return Mark::absent;
  switch (point->status) {
    case Status::stationary:
      return Mark::none;
    case Status::unresolved:
      return Mark::unresolved;
    case Status::failed:
      break;
  }
  return Mark::failed;
}

struct Entry {
  double value;
  Mark mark;
  int region;
};
using Value = std::function<Entry(std::size_t volume, std::size_t length)>;

// Index of the point's branch; −1 where there is no stationary state of it.
int branch_index(const ScanTable& scan, const ScanPoint* point) {
  if (mark_of(point) != Mark::none) return -1;
  return int(std::ranges::find(scan.branches(), point->branch) - scan.branches().begin());
}

Quantity tabulate(const ScanTable& scan, std::string title, const Value& value) {
  Quantity quantity{.title = std::move(title), .values = {}, .marks = {}, .regions = {}};
  for (std::size_t volume = 0; volume < scan.reduced_volumes().size(); ++volume) {
    auto& values = quantity.values.emplace_back();
    auto& marks = quantity.marks.emplace_back();
    auto& regions = quantity.regions.emplace_back();
    for (std::size_t length = 0; length < scan.lengths().size(); ++length) {
      auto [number, mark, region] = value(volume, length);
      if (mark == Mark::none && !std::isfinite(number)) mark = Mark::failed;
      values.push_back(mark == Mark::failed || mark == Mark::absent ? none : number);
      marks.push_back(mark);
      regions.push_back(mark == Mark::none ? region : -1);
    }
  }
  return quantity;
}

Quantity of_model(const ScanTable& scan, Model model, std::string title,
                  double ScanPoint::*member) {
  return tabulate(scan, std::move(title), [&](std::size_t volume, std::size_t length) {
    const ScanPoint* point = scan.find(model, volume, length);
    return Entry{point ? point->*member : none, mark_of(point), branch_index(scan, point)};
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

std::pair<double, double> Quantity::range() const {
  double low = infinity, high = -infinity;
  const auto include = [&](Mark wanted, double from, double to) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t j = 0; j < values[i].size(); ++j) {
        const double value = values[i][j];
        if (marks[i][j] != wanted || !(value >= from && value <= to)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  };
  include(Mark::none, -infinity, infinity);
  const double far = low <= high ? std::max(2.0 * (high - low), 0.5 * std::abs(high)) : infinity;
  include(Mark::unresolved, low - far, high + far);
  return low <= high ? std::pair(low, high) : std::pair(0.0, 1.0);
}

std::optional<BranchMap> lowest_branches(const ScanTable& scan,
                                         const std::filesystem::path& directory, Model model) {
  const std::filesystem::path file = directory / "lowest.csv";
  if (!std::filesystem::exists(file)) return {};
  const CsvTable table(file);
  const std::size_t models = table.column("model"), branches = table.column("branch");
  const auto volumes = table.numbers("reduced_volume"), lengths = table.numbers("L");
  BranchMap map{.quantity = {}, .names = scan.branches()};
  std::map<std::pair<long long, long long>, int> lowest;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.text(row, models) != (model == Model::SBEH ? "SBEH" : "SSH")) continue;
    const std::string& name = table.text(row, branches);
    const auto place = std::ranges::find(map.names, name);
    lowest[{parameter_key(volumes[row]), parameter_key(lengths[row])}] =
        int(place - map.names.begin());
    if (place == map.names.end()) map.names.push_back(name);
  }
  if (map.names.size() < 2) return {};
  map.quantity = tabulate(
      scan, with_name("lowest branch", model), [&](std::size_t volume, std::size_t length) {
        const auto found = lowest.find(
            {parameter_key(scan.reduced_volumes()[volume]), parameter_key(scan.lengths()[length])});
        if (found != lowest.end()) return Entry{double(found->second), Mark::none, found->second};
        return Entry{none, mark_of(scan.find(model, volume, length)), -1};
      });
  return map;
}

Quantity energy_gap(const ScanTable& scan) {
  return tabulate(scan, "energy gap U(SSH) − U(SBEH)", [&](std::size_t volume, std::size_t length) {
    const ScanPoint* ssh = scan.find(Model::SSH, volume, length);
    const ScanPoint* sbeh = scan.find(Model::SBEH, volume, length);
    const Mark mark = std::max(mark_of(ssh), mark_of(sbeh));
    const int region =
        branch_index(scan, sbeh) * int(scan.branches().size()) + branch_index(scan, ssh);
    return Entry{ssh && sbeh ? ssh->energy - sbeh->energy : none, mark, region};
  });
}

Quantity energy(const ScanTable& scan, Model model) {
  return of_model(scan, model, with_name("energy U", model), &ScanPoint::energy);
}

Quantity smallest_order(const ScanTable& scan) {
  return of_model(scan, Model::SBEH, with_name("smallest order β", Model::SBEH),
                  &ScanPoint::order_min);
}

Quantity largest_curvature(const ScanTable& scan, Model model) {
  return of_model(scan, model, with_name("largest |H|", model), &ScanPoint::H_abs_max);
}

}  // namespace sbeh::picture
