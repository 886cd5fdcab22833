#include "tools/picture/quantity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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

using Value = std::function<std::pair<double, Mark>(std::size_t volume, std::size_t length)>;

Quantity tabulate(const ScanTable& scan, std::string title, const Value& value) {
  Quantity quantity{.title = std::move(title), .values = {}, .marks = {}};
  for (std::size_t volume = 0; volume < scan.reduced_volumes().size(); ++volume) {
    auto& values = quantity.values.emplace_back();
    auto& marks = quantity.marks.emplace_back();
    for (std::size_t length = 0; length < scan.lengths().size(); ++length) {
      auto [number, mark] = value(volume, length);
      if (mark == Mark::none && !std::isfinite(number)) mark = Mark::failed;
      values.push_back(mark == Mark::failed || mark == Mark::absent ? none : number);
      marks.push_back(mark);
    }
  }
  return quantity;
}

Quantity of_model(const ScanTable& scan, Model model, std::string title,
                  double ScanPoint::*member) {
  return tabulate(scan, std::move(title), [&](std::size_t volume, std::size_t length) {
    const ScanPoint* point = scan.find(model, volume, length);
    return std::pair(point ? point->*member : none, mark_of(point));
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

Quantity energy_gap(const ScanTable& scan) {
  return tabulate(scan, "energy gap U(SSH) − U(SBEH)", [&](std::size_t volume, std::size_t length) {
    const ScanPoint* ssh = scan.find(Model::SSH, volume, length);
    const ScanPoint* sbeh = scan.find(Model::SBEH, volume, length);
    const Mark mark = std::max(mark_of(ssh), mark_of(sbeh));
    return std::pair(ssh && sbeh ? ssh->energy - sbeh->energy : none, mark);
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
