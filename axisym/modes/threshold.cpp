#include "axisym/modes/threshold.h"

#include "axisym/redistribute.h"
#include "model/numerics/root.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

namespace sbeh::axisym {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

SecondVariation second_variation_at(const Line& line, const LineState& state) {
  return second_variation(line.material_at(state.mu), line.model, state);
}

// The coordinate in which the line goes.
double coordinate(const Line& line, const PlanePoint& at) {
  return line.from.L == line.to.L ? at.reduced_volume : at.L;
}
double coordinate(const Line& line, double mu) { return coordinate(line, line.at(mu)); }

PathState step_to(const Line& line, const PathState& from, double ds) {
  if (ds == 0) return from;
  auto there = arc_step(line, from, ds);
  if (!there) throw std::domain_error("the branch is lost");
  return *std::move(there);
}

struct Kind {
  int m;
  Parity parity;
};

// The lowest eigenvalue; throws std::domain_error where there is none.
double eigenvalue_of(const SecondVariation& second, const Kind& kind) {
  const auto found = lowest_modes(second, kind.m, kind.parity, 1);
  if (!found || found->modes.empty()) throw std::domain_error("the eigenvalue is not found");
  return found->modes.front().eigenvalue;
}

double rigid_residual(const SecondVariation& second) {
  double largest = 0;
  for (const int m : {0, 1}) {
    const auto found = lowest_modes(second, m, 1);
    largest = std::max(largest, found ? found->rigid_residual : infinite);
  }
  return largest;
}

// An eigenvalue that has different signs at the ends of a step.
struct Change {
  Kind kind;
  double before, after;
};

struct LengthAndValue {
  double length, value;
};

// A zero nearby, and the eigenvalue's slope by the length of the path.
struct Zero {
  PathState state;
  double slope;
  double last_change = infinite;  // of the length
  double rigid_residual = infinite;
};

// By bisection and secants.
Zero rough_zero(const Line& line, const PathState& from, double ds, const Change& change) {
  constexpr int bits = 8;
  constexpr double apart = 1e-3;  // of ds: for the slope, above what rounding adds
  std::vector<std::pair<double, double>> seen{{0, change.before}, {ds, change.after}};
  const auto eigenvalue = [&](double h) {
    if (h == 0 || h == ds) return h == 0 ? change.before : change.after;
    const double value =
        eigenvalue_of(second_variation_at(line, step_to(line, from, h)), change.kind);
    seen.emplace_back(h, value);
    return value;
  };
  model::root_between(eigenvalue, 0, ds, bits);
  const auto size = [](const auto& point) { return std::abs(point.second); };
  const auto [h, value] = *std::ranges::min_element(seen, {}, size);
  const auto distance = [h = h, ds](const auto& point) {
    const double away = std::abs(point.first - h);
    return away > apart * ds ? away : infinite;
  };
  const auto [other, other_value] = *std::ranges::min_element(seen, {}, distance);
  return {step_to(line, from, h), (value - other_value) / (h - other)};
}

// By Newton's method, the slope being known.
Zero polished(const Line& line, const Zero& rough, const Kind& kind) {
  constexpr int most_iterations = 8;
  constexpr double tolerance = 1e-8;
  Zero zero = rough;
  zero.last_change = infinite;
  double h = 0;
  std::optional<SecondVariation> second;
  for (int i = 0; i < most_iterations && std::abs(zero.last_change) > tolerance; ++i) {
    second = second_variation_at(line, zero.state);
    zero.last_change = -eigenvalue_of(*second, kind) / rough.slope;
    h += zero.last_change;
    zero.state = step_to(line, rough.state, h);
  }
  zero.rigid_residual = rigid_residual(*second);
  return zero;
}

// Empty where Newton's method fails.
std::optional<PathState> over(int elements, const Line& line, const PathState& state,
                              const Numerics& numerics) {
  return on_nodes(line, state, redistribute(state, numerics.grading, elements));
}

// μ at the zero over half as many elements; infinite where there is none.
double place_over_half(const Line& line, const Zero& zero, const Kind& kind,
                       const Numerics& numerics) {
  const auto coarse = over(element_count(zero.state.X) / 2, line, zero.state, numerics);
  if (!coarse) return infinite;
  const double value = eigenvalue_of(second_variation_at(line, *coarse), kind);
  return coarse->mu - coarse->slope() * value / zero.slope;
}

struct LowestMode {
  Kind kind;
  double eigenvalue;
};

std::vector<LowestMode> lowest_of_each(const Line& line, const LineState& state,
                                       std::span<const int> ms) {
  std::vector<LowestMode> lowest;
  const SecondVariation second = second_variation_at(line, state);
  for (const int m : ms) {
    const auto found = lowest_modes(second, m, 1);
    if (!found) continue;
    for (const Eigenmode& mode : found->modes)
      lowest.push_back({{m, mode.parity}, mode.eigenvalue});
  }
  return lowest;
}

// The eigenvalues of a kind at both ends of a step.
std::vector<Change> at_both_ends(const std::vector<LowestMode>& before,
                                 const std::vector<LowestMode>& after) {
  std::vector<Change> ends;
  for (const LowestMode& a : before)
    for (const LowestMode& b : after)
      if (a.kind.m == b.kind.m && a.kind.parity == b.kind.parity)
        ends.push_back({a.kind, a.eigenvalue, b.eigenvalue});
  return ends;
}
bool changes_sign(const Change& ends) { return (ends.before < 0) != (ends.after < 0); }

// Where within a step the eigenvalue, which has one sign at both ends, has the other: parabolas lead to where it is
// least against that sign.
std::optional<LengthAndValue> beyond_zero(const Line& line, const PathState& from, double ds,
                                          const Change& ends) {
  constexpr int most_values = 12;
  constexpr double nearest = 1e-3;  // of ds
  const double sign = ends.before < 0 ? -1 : 1;
  const auto at = [&](double h) {
    return LengthAndValue{
        h, eigenvalue_of(second_variation_at(line, step_to(line, from, h)), ends.kind)};
  };
  LengthAndValue low{0, ends.before}, middle = at(ds / 2), high{ds, ends.after};
  for (int i = 1; i < most_values && sign * middle.value > 0; ++i) {
    if (high.length - low.length < nearest * ds) return {};
    const double a = sign * low.value, b = sign * middle.value, c = sign * high.value;
    const bool falls_to_low = a < b, falls_to_high = c < b;
    if (falls_to_low || falls_to_high) {
      (falls_to_low && a < c ? high : low) = middle;
      middle = at((low.length + high.length) / 2);
      continue;
    }
    const double left = middle.length - low.length, right = high.length - middle.length;
    const double p = (c - b) * left, q = (a - b) * right;  // b is no larger than a and c
    const double turn = middle.length + (p + q > 0 ? (q * right - p * left) / (2 * (p + q)) : 0);
    if (std::abs(turn - middle.length) < nearest * ds) return {};
    const LengthAndValue next = at(turn);
    const bool is_lower = sign * next.value < b;
    if (turn < middle.length)
      (is_lower ? high : low) = is_lower ? middle : next;
    else
      (is_lower ? low : high) = is_lower ? middle : next;
    if (is_lower) middle = next;
  }
  return sign * middle.value > 0 ? std::nullopt : std::optional(middle);
}

// At the fold of a branch that is symmetric top to bottom, or has no such symmetry, the eigenvalue of m = 0 vanishes.
bool is_of_fold(const Kind& kind) { return kind.m == 0 && kind.parity != Parity::odd; }

// Steps may go past the end, where the next line begins.
bool is_between_ends(const Line& line, const PlanePoint& at) {
  const double begin = coordinate(line, 0), end = coordinate(line, 1), x = coordinate(line, at);
  return (x - begin) * (end - begin) >= 0 && (end - x) * (end - begin) > 0;
}

// As far as the end by the tangent, or as shapes may change in a step.
double first_step(const PathState& from) {
  constexpr double largest = 0.3;
  return std::min(1 / from.slope(), largest / largest_change(from.tangent));
}

// The length after which the path turns back, a little less.
double length_to_fold(const Line& line, const PathState& from, double beyond) {
  constexpr int bits = 20;
  const auto slope = [&](double h) { return step_to(line, from, h).slope(); };
  const model::Bracket fold = model::root_between(slope, 0, beyond, bits);
  return slope(fold.low) > 0 ? fold.low : (1 - std::ldexp(1, -bits)) * fold.low;
}

// Estimated, of the coordinate.
double error_of(const Line& line, const Zero& zero, double coarser_mu) {
  constexpr double overestimate = 1. / 16;
  const double of_length =
      std::max(std::abs(zero.last_change), zero.rigid_residual / std::abs(zero.slope));
  return std::abs(coordinate(line, 1) - coordinate(line, 0))
       * std::max(overestimate * std::abs(zero.state.mu - coarser_mu),
                  std::abs(zero.state.slope()) * of_length);
}

Threshold located(const Line& line, const PathState& from, double ds, const Change& change,
                  const Numerics& numerics, double promised) {
  const Kind& kind = change.kind;
  Threshold threshold{kind.m, kind.parity, {from, line.at(from.mu)}, infinite, false};
  const auto keep = [&](const Zero& zero, double coarser_mu) {
    const PathState& state = zero.state;
    threshold.state = {state, line.at(state.mu), state.determinant_sign};
    threshold.error = error_of(line, zero, coarser_mu);
    threshold.is_located = threshold.error <= promised;
  };
  try {
    Zero zero = polished(line, rough_zero(line, from, ds, change), kind);
    keep(zero, place_over_half(line, zero, kind, numerics));
    while (!threshold.is_located && 2 * element_count(zero.state.X) <= most_elements) {
      const auto fine = over(2 * element_count(zero.state.X), line, zero.state, numerics);
      if (!fine) break;
      const double before = zero.state.mu;
      zero = polished(line, {*fine, zero.slope}, kind);
      keep(zero, before);
    }
  } catch (const std::domain_error&) {  // lost on the way
    threshold.is_located = false;
  }
  return threshold;
}

}  // namespace

Threshold threshold_within(const Line& line, const PathState& from, double ds, int m, Parity parity,
                           const Numerics& numerics, double promised) {
  const auto eigenvalue_at = [&](double h) {
    return eigenvalue_of(second_variation_at(line, step_to(line, from, h)), {m, parity});
  };
  return located(line, from, ds, {{m, parity}, eigenvalue_at(0), eigenvalue_at(ds)}, numerics,
                 promised);
}

namespace {

// Those of one kind within a step.
std::vector<Threshold> within_step(const Line& line, const PathState& from, double ds,
                                   const Change& ends, const Numerics& numerics, double promised,
                                   Search search) {
  if (changes_sign(ends) != (search == Search::changes)) return {};
  if (search == Search::changes) return {located(line, from, ds, ends, numerics, promised)};
  try {
    const auto between = beyond_zero(line, from, ds, ends);
    if (!between) return {};
    const auto& [h, value] = *between;
    return {located(line, from, h, {ends.kind, ends.before, value}, numerics, promised),
            located(line, step_to(line, from, h), ds - h, {ends.kind, value, ends.after}, numerics,
                    promised)};
  } catch (const std::domain_error&) {  // lost on the way
    return {};
  }
}

}  // namespace

std::vector<Threshold> thresholds_along(const Line& line, const StationaryState& from,
                                        std::span<const int> ms, const Numerics& numerics,
                                        double promised, Search search) {
  constexpr int most_steps = 60;
  constexpr double shortest = 1e-6;
  std::vector<Threshold> found;
  auto here = with_tangent(line, {from, 0});
  if (!here) return {};
  std::vector<LowestMode> before = lowest_of_each(line, *here, ms);
  double ds = first_step(*here);
  for (int step = 0; step < most_steps; ++step) {
    auto next = advance(line, *here, ds, shortest);
    if (!next) break;
    const bool is_over_fold = next->slope() <= 0;
    if (is_over_fold) {
      ds = length_to_fold(line, *here, ds);
      next = step_to(line, *here, ds);
    }
    const std::vector<LowestMode> after = lowest_of_each(line, *next, ms);
    for (const Change& ends : at_both_ends(before, after)) {
      if (is_over_fold && is_of_fold(ends.kind)) continue;
      for (Threshold& threshold : within_step(line, *here, ds, ends, numerics, promised, search))
        if (is_between_ends(line, threshold.state.at)) found.push_back(std::move(threshold));
    }
    if (is_over_fold || next->mu >= 1) break;
    here = with_fresh_nodes(line, *next, numerics);
    before = after;
    ds *= 1.5;
  }
  return found;
}

}  // namespace sbeh::axisym
