#include "tools/picture/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::picture {

bool Options::wants(const std::string& picture) const {
  return only.empty() || std::ranges::find(only, picture) != only.end();
}

Field Options::field_for(const Range& orders) const {
  constexpr double uniform = 1e-6;
  return field.value_or(orders.width() < uniform ? Field::curvature : Field::order);
}

double Options::text_size() const {
  constexpr double points_per_mm = 72.0 / 25.4, points = 8.0;  // on paper
  if (width_mm) return points / points_per_mm * pixels_per_mm;
  if (!size) return usual_text;
  return std::clamp(std::min(size->width / 80.0, size->height / 45.0), 9.0, 40.0);
}

Output Options::output(const std::vector<Format>& usual) const {
  return {.formats = formats.empty() ? usual : formats,
          .width = width_mm.value_or(0.0),
          .must_fit = has_size()};
}

std::string Options::energy_name() const {
  const char* unit = units ? "E₀" : "";
  if (energy_shift == 0.0) return "U";
  if (std::abs(energy_shift - 4.0 * std::numbers::pi) < 1e-6) return fmt::format("U + 4π{}", unit);
  return fmt::format("U {} {:.6g}{}", energy_shift > 0.0 ? "+" : "−", std::abs(energy_shift), unit);
}

std::string Options::unit_after(const studies::Dimension& dimension) const {
  return units ? fmt::format(" {}", units->unit(dimension)) : "";
}

}  // namespace sbeh::picture
