// The findings of the stationary oblates: figures 1 and 2.
#include "studies/figures/figures.h"
#include "studies/figures/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

namespace sbeh::studies::figures {

using model::Model;

namespace {

using Point = std::pair<double, double>;  // V_r, L
using Histories = std::map<std::tuple<Solver, Model, Point>, History>;

// A quantity over the grid, where it is known.
using Values = std::map<Point, double>;

Histories histories_of(const std::vector<EnergyRow>& energy) {
  Histories histories;
  for (const EnergyRow& row : energy) {
    History& h = histories[{row.solver, row.model, {row.reduced_volume, row.L}}];
    h.ended = row.at_rest.has_value();
    h.at_rest = row.at_rest.value_or(false);
    h.time.push_back(row.time);
    h.value.push_back(row.energy);
  }
  return histories;
}

// How often a quantity over the grid grows from one L to the next, and from one V_r to the next smaller.
struct Growth {
  int with_L = 0, of_L = 0, with_volume = 0, of_volume = 0;
  bool everywhere() const { return with_L == of_L && with_volume == of_volume; }
  std::string text() const {
    return fmt::format("grows in {} of {} steps of L and {} of {} steps down in V_r", with_L, of_L,
                       with_volume, of_volume);
  }
};

Growth growth_of(const Values& values) {
  std::set<double> volumes, lengths;
  for (const auto& [point, value] : values) {
    volumes.insert(point.first);
    lengths.insert(point.second);
  }
  Growth growth;
  for (const auto& [point, value] : values) {
    const auto [v, L] = point;
    if (const auto next = lengths.upper_bound(L); next != lengths.end())
      if (const auto other = values.find({v, *next}); other != values.end()) {
        ++growth.of_L;
        growth.with_L += other->second > value;
      }
    if (const auto larger = volumes.upper_bound(v); larger != volumes.end())
      if (const auto other = values.find({*larger, L}); other != values.end()) {
        ++growth.of_volume;
        growth.with_volume += value > other->second;
      }
  }
  return growth;
}

std::string point_text(const Point& at) {
  return fmt::format("V_r = {:.4g}, L = {:.4g}", at.first, at.second);
}

const Values::value_type& least(const Values& values) {
  return *std::ranges::min_element(values, {}, &Values::value_type::second);
}
const Values::value_type& largest(const Values& values) {
  return *std::ranges::max_element(values, {}, &Values::value_type::second);
}

std::string text_of(const Values::value_type& at, int digits) {
  return fmt::format("{:.{}f} ({})", at.second, digits, point_text(at.first));
}

// ---- figure 1 -----------------------------------------------------------------------------------

// An energy that falls is written with rounding errors of 1e-13 of itself.
constexpr double rounding = 1e-12;

Finding falling_energies(const Histories& histories, Solver solver) {
  int count = 0, falling = 0;
  double rise = -HUGE_VAL;
  for (const auto& [key, h] : histories) {
    if (std::get<0>(key) != solver || h.size() < 2) continue;
    ++count;
    falling += h.largest_rise() <= rounding * std::abs(h.last());
    rise = std::max(rise, h.largest_rise());
  }
  const std::string rises =
      fmt::format(", and rises by {:.1e} at most from one time to the next", rise);
  return {fmt::format("{}: the energy falls in {} of {} histories{}", name(solver), falling, count,
                      falling == count ? "" : rises),
          "energies fall in all runs", count > 0 ? agrees(falling == count) : Agreement::open};
}

Values gaps_at_rest(const Histories& histories) {
  Values gaps;
  for (const auto& [key, sbeh] : histories) {
    const auto& [solver, model, point] = key;
    const auto ssh = histories.find({solver, Model::SSH, point});
    if (solver == Solver::axisymmetric && model == Model::SBEH && ssh != histories.end()
        && sbeh.at_rest && ssh->second.at_rest)
      gaps[point] = ssh->second.last() - sbeh.last();
  }
  return gaps;
}

Finding ends_at_rest(const Histories& histories, Solver solver) {
  int ended = 0, at_rest = 0;
  double last = 0;
  for (const auto& [key, h] : histories) {
    if (std::get<0>(key) != solver) continue;
    ended += h.ended;
    at_rest += h.at_rest;
    if (h.at_rest) last = std::max(last, h.end());
  }
  return {fmt::format("{}: {} of {} runs end at rest, the last at t = {:.3g}", name(solver),
                      at_rest, ended, last),
          "all runs converge to a stationary shape", agrees(at_rest == ended)};
}

Finding order_of_models(const Histories& histories) {
  int times = 0, lower = 0;
  for (const auto& [key, sbeh] : histories) {
    const auto& [solver, model, point] = key;
    const auto ssh = histories.find({solver, Model::SSH, point});
    if (model != Model::SBEH || ssh == histories.end()) continue;
    for (std::size_t i = 0; i < sbeh.size(); ++i)
      if (sbeh.time[i] > 0) {
        ++times;
        lower += sbeh.value[i] < ssh->second.at(sbeh.time[i]);
      }
  }
  return {fmt::format("U(SBEH) < U(SSH) at {} of {} times t > 0", lower, times),
          "SBEH has the lower energy at all times", agrees(lower == times)};
}

std::optional<Finding> against_axisymmetric(const Histories& histories) {
  int count = 0;
  double worst = 0;
  Point at;
  for (const auto& [key, h] : histories) {
    const auto& [solver, model, point] = key;
    const auto other = histories.find({Solver::axisymmetric, model, point});
    if (solver != Solver::in_3d || other == histories.end() || !h.at_rest) continue;
    ++count;
    const double difference = std::abs(h.last() / other->second.last() - 1);
    if (difference >= worst) {
      worst = difference;
      at = point;
    }
  }
  if (count == 0) return {};
  return Finding{
      fmt::format("energies at rest of {} runs in 3D: within {:.1e} of the axisymmetric ones, "
                  "relatively (worst at {})",
                  count, worst, point_text(at)),
      "", Agreement::open};
}

// ---- figure 2 -----------------------------------------------------------------------------------

template <class Quantity>
Values finite_values(const std::vector<ShapeRow>& shapes, Quantity quantity) {
  Values values;
  for (const ShapeRow& row : shapes)
    if (const double value = std::invoke(quantity, row); std::isfinite(value))
      values[{row.reduced_volume, row.L}] = value;
  return values;
}

double distance_in_3d(const ShapeRow& row) { return row.in_3d ? row.in_3d->distance : not_known; }

Finding shapes_in_3d(const std::vector<ShapeRow>& shapes) {
  int at_rest = 0;
  double energy = 0, order = 0;
  for (const ShapeRow& row : shapes) {
    if (!row.in_3d) continue;
    at_rest += row.in_3d->ending.starts_with("at rest");
    energy = std::fmax(energy, std::abs(row.in_3d->energy - row.energy) / std::abs(row.energy));
    order = std::fmax(order, std::abs(row.in_3d->order_min - row.order_min));
  }
  const auto distances = finite_values(shapes, distance_in_3d);
  return {fmt::format("{} of {} shapes in 3D, {} of them at rest; largest differences from the "
                      "axisymmetric ones: energy {:.1e}, smallest order {:.1e}, distance {:.1e}",
                      distances.size(), shapes.size(), at_rest, energy, order,
                      largest(distances).second),
          "", Agreement::open};
}

}  // namespace

std::vector<Finding> energy_findings(const std::vector<EnergyRow>& energy) {
  const auto histories = histories_of(energy);
  std::vector<Finding> findings;
  for (const Solver solver : {Solver::axisymmetric, Solver::in_3d}) {
    const auto has = [&](const auto& entry) { return std::get<0>(entry.first) == solver; };
    if (std::none_of(histories.begin(), histories.end(), has)) continue;
    findings.push_back(falling_energies(histories, solver));
    findings.push_back(ends_at_rest(histories, solver));
  }
  const auto gaps = gaps_at_rest(histories);
  if (!gaps.empty()) {
    findings.push_back(order_of_models(histories));
    const Growth growth = growth_of(gaps);
    findings.push_back(
        {fmt::format("U(SSH) − U(SBEH) at rest: {} to {}; it {}", text_of(least(gaps), 5),
                     text_of(largest(gaps), 5), growth.text()),
         "the gap widens as L grows and as V_r falls", agrees(growth.everywhere())});
  }
  if (const auto in_space = against_axisymmetric(histories)) findings.push_back(*in_space);
  return findings;
}

std::vector<Finding> shapes_findings(const std::vector<ShapeRow>& shapes) {
  std::vector<Finding> findings;
  const auto own = finite_values(shapes, &ShapeRow::distance_from_SSH),
             same = finite_values(shapes, &ShapeRow::SSH_distance),
             order = finite_values(shapes, &ShapeRow::order_min),
             radius = finite_values(shapes, &ShapeRow::order_min_radius);
  if (own.empty() || same.empty() || order.empty() || radius.empty()) return findings;
  const double change = largest(same).second, nearest = least(radius).second;
  // The last digits depend on when an evolution counts as at rest.
  findings.push_back({fmt::format("SSH's shapes for different L are {:.1e} apart at most", change),
                      "SSH's shapes are the same for all L",
                      agrees(change < 1e-2 * least(own).second)});
  const Growth apart = growth_of(own);
  findings.push_back({fmt::format("SBEH's shapes are {} to {} away from SSH's; that {}",
                                  text_of(least(own), 4), text_of(largest(own), 4), apart.text()),
                      "they differ more as L grows and as V_r falls", agrees(apart.everywhere())});
  Values loss;
  for (const auto& [point, value] : order) loss[point] = -value;
  const Growth growth = growth_of(loss);
  findings.push_back(
      {fmt::format("smallest order {} to {}; its loss {}", text_of(largest(order), 4),
                   text_of(least(order), 4), growth.text()),
       "order falls with growing L and falling V_r", agrees(growth.everywhere())});
  findings.push_back(
      {fmt::format("order is least at {:.3f} of the equator's radius or farther out", nearest),
       "order is least at the rim", agrees(nearest > 0.95)});
  if (!finite_values(shapes, distance_in_3d).empty()) findings.push_back(shapes_in_3d(shapes));
  return findings;
}

}  // namespace sbeh::studies::figures
