#include "tools/picture/chart/axis.h"

#include "tools/picture/canvas/geometry.h"

#include <fmt/format.h>
#include <vtkAxis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sbeh::picture {
namespace {

std::string power_of_ten(int exponent) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

std::string decade_label(int exponent, int factor) {
  if (exponent >= -3 && exponent <= 3)
    return fmt::format("{:g}", factor * std::pow(10.0, exponent));
  return factor == 1 ? power_of_ten(exponent)
                     : fmt::format("{}·{}", factor, power_of_ten(exponent));
}

// Largest over smallest distance of neighbours: 1 for even spacing.
double unevenness(const std::vector<double>& values) {
  Range distances;
  for (std::size_t i = 1; i < values.size(); ++i) distances.include(values[i] - values[i - 1]);
  return distances.high / distances.low;
}

std::vector<double> logarithms(const std::vector<double>& values) {
  std::vector<double> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(std::log10(value));
  return result;
}

std::vector<double> edges_of(const std::vector<double>& centres) {
  const std::size_t n = centres.size();
  std::vector<double> edges(n + 1);
  for (std::size_t i = 1; i < n; ++i) edges[i] = 0.5 * (centres[i - 1] + centres[i]);
  edges[0] = n > 1 ? 2.0 * centres[0] - edges[1] : centres[0] - 0.5;
  edges[n] = n > 1 ? 2.0 * centres[n - 1] - edges[n - 1] : centres[0] + 0.5;
  return edges;
}

}  // namespace

Axis linear_axis(double low, double high, double length, double spacing, std::string title) {
  if (!(high > low)) {
    const double margin = low == 0.0 ? 0.5 : 0.05 * std::abs(low);
    low -= margin;
    high += margin;
  }
  const double step = vtkAxis::NiceMinMax(low, high, float(length), float(spacing));
  const int decimals = std::max(0, int(std::ceil(-std::log10(step) - 1e-6)));
  Axis axis{.low = low, .high = high, .title = std::move(title)};
  for (double tick = low; tick < high + 0.5 * step; tick += step) {
    const double clean = std::abs(tick) < 1e-6 * step ? 0.0 : tick;
    axis.ticks.push_back(clean);
    axis.labels.push_back(with_minus(fmt::format("{:.{}f}", clean, decimals)));
  }
  return axis;
}

Axis cropped(const Axis& axis, double low, double high) {
  const double rounding = 1e-9 * (high - low);
  Axis result{.low = low, .high = high, .title = axis.title};
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    if (axis.ticks[i] < low - rounding || axis.ticks[i] > high + rounding) continue;
    result.ticks.push_back(axis.ticks[i]);
    result.labels.push_back(axis.labels[i]);
  }
  return result;
}

Axis exact_axis(double low, double high, double length, double spacing, std::string title) {
  return cropped(linear_axis(low, high, length, spacing, std::move(title)), low, high);
}

Axis decade_axis(double log_low, double log_high, std::string title) {
  if (log_high - log_low < 0.3) {  // less than a factor of 2
    log_low -= 0.2;
    log_high += 0.2;
  }
  const double decades = log_high - log_low;
  Axis axis{.low = log_low, .high = log_high, .title = std::move(title)};
  for (int exponent = int(std::floor(log_low)); exponent <= int(std::ceil(log_high)); ++exponent) {
    for (int factor = 1; factor < 10; ++factor) {
      const double tick = exponent + std::log10(double(factor));
      if (tick < log_low - 1e-9 || tick > log_high + 1e-9) continue;
      const bool labelled =
          factor == 1 || (decades < 2.3 && (factor == 2 || factor == 5)) || decades < 0.8;
      axis.ticks.push_back(tick);
      axis.labels.push_back(labelled ? decade_label(exponent, factor) : "");
    }
  }
  return axis;
}

Axis without_crowd(Axis axis, const std::vector<double>& extents, double length, double gap) {
  std::vector<std::size_t> labelled;
  for (std::size_t i = 0; i < axis.labels.size(); ++i)
    if (!axis.labels[i].empty()) labelled.push_back(i);
  const auto fits = [&](std::size_t stride) {
    for (std::size_t k = stride; k < labelled.size(); k += stride) {
      const std::size_t a = labelled[k - stride], b = labelled[k];
      const double distance = (axis.share(axis.ticks[b]) - axis.share(axis.ticks[a])) * length;
      if (distance < 0.5 * (extents[a] + extents[b]) + gap) return false;
    }
    return true;
  };
  std::size_t stride = 1;
  while (stride < labelled.size() && !fits(stride)) ++stride;
  for (std::size_t k = 0; k < labelled.size(); ++k)
    if (k % stride != 0) axis.labels[labelled[k]].clear();
  return axis;
}

Axis without_lesser_ticks(const Axis& axis, double length, double least) {
  Axis kept{.low = axis.low, .high = axis.high, .title = axis.title};
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < axis.ticks.size(); ++i) {
    if (i > 0)
      nearest =
          std::min(nearest, (axis.share(axis.ticks[i]) - axis.share(axis.ticks[i - 1])) * length);
    if (axis.labels[i].empty()) continue;
    kept.ticks.push_back(axis.ticks[i]);
    kept.labels.push_back(axis.labels[i]);
  }
  return nearest < least ? kept : axis;
}

std::string with_minus(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

std::string volume_title(double reduced_volume) { return "Vᵣ = " + short_number(reduced_volume); }

std::string length_title(double length) { return "L = " + short_number(length); }

GridAxis table_axis(const std::vector<double>& values, const std::string& title) {
  GridAxis grid;
  for (std::size_t i = 0; i < values.size(); ++i) {
    grid.centres.push_back(double(i));
    grid.axis.ticks.push_back(double(i));
    grid.axis.labels.push_back(short_number(values[i]));
  }
  grid.edges = edges_of(grid.centres);
  grid.axis.low = -0.5;
  grid.axis.high = double(values.size()) - 0.5;
  grid.axis.title = title;
  grid.values = values;
  return grid;
}

GridAxis distance_axis(const std::vector<double>& values, const std::string& title, double length,
                       double spacing) {
  const bool logarithmic = values.size() > 2 && values.front() > 0.0
                        && unevenness(logarithms(values)) < unevenness(values);
  GridAxis grid;
  grid.centres = logarithmic ? logarithms(values) : values;
  grid.edges = edges_of(grid.centres);
  if (values.size() > 1) {
    grid.edges.front() = grid.centres.front();
    grid.edges.back() = grid.centres.back();
  }
  const double low = grid.edges.front(), high = grid.edges.back();
  grid.axis = logarithmic ? cropped(decade_axis(low, high, title), low, high)
                          : exact_axis(low, high, length, spacing, title);
  grid.values = values;
  return grid;
}

double share_of(const GridAxis& grid, double value) {
  const std::vector<double>&v = grid.values, &at = grid.centres;
  double place = at[0];
  if (v.size() > 1) {
    const auto above = std::upper_bound(v.begin() + 1, v.end() - 1, value);
    const auto k = std::size_t(above - v.begin());
    place = at[k - 1] + (value - v[k - 1]) / (v[k] - v[k - 1]) * (at[k] - at[k - 1]);
  }
  return grid.axis.share(place);
}

}  // namespace sbeh::picture
