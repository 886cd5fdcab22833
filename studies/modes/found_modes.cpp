#include "studies/modes/found_modes.h"

#include "axisym/modes/growth_rates.h"
#include "axisym/stationary/accuracy.h"
#include "studies/io/interrupt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

namespace sbeh::studies {

namespace {

constexpr int most_refined = 4;  // more elements would bring in rounding

// Those of one m by their numbers: the lowest `most` of each parity, and all that are negative.
std::vector<FoundMode> numbered(const axisym::ModeSpectrum& spectrum, const Physics& physics,
                                const axisym::State& state, int most) {
  std::map<axisym::Parity, int> count;
  std::vector<FoundMode> modes;
  for (const axisym::Eigenmode& of : spectrum.modes) {
    if (count[of.parity] >= most && of.eigenvalue >= 0) continue;
    const ModeKey key{of.m, of.parity, ++count[of.parity]};
    modes.push_back({{physics, state, key, of.eigenvalue, not_known, of.u, of.b}, of.u, of.b});
  }
  std::ranges::stable_sort(modes, {}, [](const StateMode& mode) { return mode.key.parity; });
  return modes;
}

// The largest rates of m, `count` of each parity or at least half of that; none where they are not found.
std::vector<axisym::GrowthMode> rates_of(const axisym::LinearFlow& flow, int m, int count) {
  for (; count > 0; count /= 2)
    if (auto rates = axisym::growth_rates(flow, m, count)) return *rates;
  return {};
}

// The modes of the flow take the place of those of the same number: there are as many that grow as there are
// negative eigenvalues. Those that are not found leave the energy's, without a rate.
void take_rates(const axisym::LinearFlow& flow, std::vector<FoundMode>& modes) {
  int count = 0;
  for (const StateMode& mode : modes) count = std::max(count, mode.key.number);
  std::map<axisym::Parity, int> taken;
  for (const axisym::GrowthMode& growth : rates_of(flow, modes.front().key.m, count)) {
    const auto mode = std::ranges::find(
        modes, ModeKey{growth.m, growth.parity, ++taken[growth.parity]}, &StateMode::key);
    if (mode == modes.end()) continue;
    mode->rate = growth.rate;
    mode->u = growth.u;
    if (has_free_order(mode->model)) mode->b = growth.b;  // otherwise it is 0 but for rounding
  }
}

void warn(const std::vector<FoundMode>& modes, std::vector<std::string>& warnings) {
  const int m = modes.front().key.m;
  const auto any = [&](auto is) { return std::ranges::any_of(modes, is); };
  if (any([](const StateMode& mode) { return std::isnan(mode.rate); }))
    warnings.push_back(fmt::format("m = {}: not all rates are found", m));
  if (any([](const StateMode& mode) { return mode.rate * mode.eigenvalue > 0; }))
    warnings.push_back(fmt::format(
        "m = {}: rates and eigenvalues contradict each other; more elements may tell", m));
}

// Without errors; empty where an eigenvalue is not found.
std::optional<FoundModes> modes_of(const ModesInput& input, const axisym::StationaryState& state) {
  const Physics physics{input.state.model, input.state.material};
  FoundModes found{axisym::second_variation(physics.material, physics.model, state), {}, 0, {}};
  const axisym::LinearFlow flow(found.second, physics.material, physics.model);
  for (int m = 0; m <= input.largest_m; ++m) {
    if (interrupt_signal() != 0) throw Interrupted("interrupted");
    const auto spectrum = axisym::lowest_and_negative_modes(found.second, m, input.number);
    if (!spectrum) return {};
    found.rigid_residual = std::max(found.rigid_residual, spectrum->rigid_residual);
    std::vector<FoundMode> modes = numbered(*spectrum, physics, state, input.number);
    take_rates(flow, modes);
    warn(modes, found.warnings);
    for (FoundMode& mode : modes) {
      normalise(mode.u, mode.b);
      found.modes.push_back(std::move(mode));
    }
  }
  return found;
}

// From half as many elements.
void take_errors(std::vector<FoundMode>& modes, const std::vector<FoundMode>& coarse) {
  for (FoundMode& mode : modes) {
    const auto half = std::ranges::find(coarse, mode.key, &StateMode::key);
    if (half == coarse.end()) continue;
    mode.eigenvalue_error = axisym::overestimate * std::abs(mode.eigenvalue - half->eigenvalue);
    mode.rate_error = axisym::overestimate * std::abs(mode.rate - half->rate);
  }
}

// The first of each m and parity; those that are not known are left as they are.
bool is_as_promised(const std::vector<FoundMode>& modes) {
  const auto exceeds = [](double error, double value) {
    return error > promised_eigenvalue * (1 + std::abs(value));
  };
  return std::ranges::none_of(modes, [&](const FoundMode& mode) {
    return mode.key.number == 1
        && (exceeds(mode.eigenvalue_error, mode.eigenvalue) || exceeds(mode.rate_error, mode.rate));
  });
}

// Over other elements, where there are such modes.
std::optional<FoundModes> modes_over(const ModesInput& input, const axisym::StationaryState& state,
                                     int elements) {
  const axisym::StationaryCase& of = input.state;
  const auto there =
      axisym::on_elements(of.material, of.model, {state, of.at()}, elements, of.numerics.grading);
  return there ? modes_of(input, *there) : std::nullopt;
}

}  // namespace

FoundModes find_modes(const ModesInput& input, const axisym::StationaryState& state) {
  auto found = modes_of(input, state);
  if (!found)
    throw std::runtime_error(fmt::format(
        "{}: its modes are not all found: use more elements in [numerics]", text_of(input.state)));
  const int elements = axisym::element_count(state.X);
  if (const auto half = modes_over(input, state, elements / 2))
    take_errors(found->modes, half->modes);
  for (int more = 2 * elements; !is_as_promised(found->modes) && more <= most_refined * elements;
       more *= 2) {
    auto fine = modes_over(input, found->second.state, more);
    if (!fine) break;
    take_errors(fine->modes, found->modes);
    found = std::move(fine);
  }
  return *std::move(found);
}

}  // namespace sbeh::studies
