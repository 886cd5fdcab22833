#include "studies/io/scales.h"

#include "studies/io/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace sbeh::studies {

namespace {

// ---- names of units -----------------------------------------------------------------------------

bool is_si(const Dimension& d) {
  return d == dimension::tension || d == dimension::pressure || d == dimension::friction;
}

struct Factor {
  std::string name;
  int power;
};

std::string product(const std::vector<Factor>& factors, int sign, bool for_columns) {
  constexpr const char* raised[] = {"", "", "²", "³", "⁴"};
  std::string text;
  for (const auto& [name, power] : factors) {
    const int p = sign * power;
    if (p <= 0) continue;
    if (!text.empty()) text += for_columns ? "_" : " ";
    text += name + (p == 1 ? "" : for_columns ? std::to_string(p) : raised[p]);
  }
  return text;
}

std::string name_of(const Dimension& d, const Scales& scales, bool for_columns) {
  if (d == dimension::none) return "";
  if (d == dimension::tension) return for_columns ? "N_per_m" : "N/m";
  if (d == dimension::pressure) return "Pa";
  if (d == dimension::friction && scales.time) return for_columns ? "Pa_s_per_m" : "Pa s/m";
  const std::vector<Factor> factors{{scales.in_kT ? "kT" : "J", d.energy},
                                    {for_columns ? "um" : "µm", d.length},
                                    {scales.time ? "s" : "T", d.time}};
  std::string above = product(factors, 1, for_columns);
  const std::string below = product(factors, -1, for_columns);
  if (below.empty()) return above;
  if (for_columns) return (above.empty() ? "" : above + "_") + "per_" + below;
  return (above.empty() ? "1" : above) + "/" + below;
}

// ---- physical values ----------------------------------------------------------------------------

struct Unit {
  std::string_view name;
  double size;  // in m, J, s
};
struct KnownUnits {
  Dimension dimension;
  const char* example;
  std::vector<Unit> units;
};
const std::vector<KnownUnits>& known_units() {
  static const std::vector<KnownUnits> all{
      {dimension::length,
       "3.9 um",
       {{"um", 1e-6}, {"µm", 1e-6}, {"μm", 1e-6}, {"nm", 1e-9}, {"mm", 1e-3}, {"m", 1}}},
      {dimension::curvature,
       "0.2 1/um",
       {{"1/um", 1e6}, {"1/µm", 1e6}, {"1/μm", 1e6}, {"1/nm", 1e9}, {"1/mm", 1e3}, {"1/m", 1}}},
      {dimension::energy, "1 kT", {{"kT", 0}, {"k_BT", 0}, {"J", 1}}},
      {dimension::time,
       "2 s",
       {{"s", 1},
        {"ms", 1e-3},
        {"us", 1e-6},
        {"µs", 1e-6},
        {"μs", 1e-6},
        {"min", 60},
        {"h", 3600}}},
  };
  return all;
}

// Of the number 1.
std::optional<double> size_of(const Scales& scales, const Dimension& d) {
  if ((d.energy != 0 && !scales.energy) || (d.time != 0 && !scales.time)) return {};
  return std::pow(scales.length, d.length) * std::pow(scales.energy.value_or(1), d.energy)
       * std::pow(scales.time.value_or(1), d.time);
}

}  // namespace

double Scales::factor(const Dimension& d) const {
  const bool si = is_si(d) && (d.time == 0 || time);
  const double micrometres = si ? 1 : 1e6, energies = !si && in_kT ? 1 / thermal : 1;
  return std::pow(micrometres * length, d.length)
       * std::pow(energies * energy.value_or(1), d.energy) * std::pow(time.value_or(1), d.time);
}

std::string Scales::unit(const Dimension& d) const { return name_of(d, *this, false); }

std::string Scales::suffix(const Dimension& d) const {
  const std::string name = name_of(d, *this, true);
  return name.empty() ? name : fmt::format("_{}", name);
}

double number_in(const Scales& scales, std::string_view text, const Dimension& dimension) {
  const auto known = std::ranges::find(known_units(), dimension, &KnownUnits::dimension);
  if (known == known_units().end()) throw std::invalid_argument("must be a number");
  const std::size_t space = std::min(text.find(' '), text.size());
  std::string_view word = text.substr(space);
  word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
  const auto unit = std::ranges::find(known->units, word, &Unit::name);
  double value = 0;
  if (!parse_number(text.substr(0, space), value) || unit == known->units.end()) {
    std::string words;
    for (const Unit& one : known->units)
      if (one.name.find_first_of("\xc2\xce") == std::string_view::npos)
        words += fmt::format("{}{}", words.empty() ? "" : ", ", one.name);
    throw std::invalid_argument(
        fmt::format("must be a number, or a text as in \"{}\" with one of these units: {}",
                    known->example, words));
  }
  const auto size = size_of(scales, dimension);
  if (!size)
    throw std::invalid_argument(
        "needs surface_viscosity (Pa s m) or friction (Pa s/m) in [units], which tell the unit of "
        "time");
  value *= (unit->size == 0 ? scales.thermal : unit->size) / *size;
  return std::strtod(fmt::format("{:.14e}", value).c_str(), nullptr);
}

}  // namespace sbeh::studies
