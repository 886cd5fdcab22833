#include "tools/picture/canvas/profile.h"

#include "tools/picture/canvas/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::picture {

Profile read_profile(const std::filesystem::path& file) {
  const CsvTable table(file);
  Profile profile{table.numbers("r"), table.numbers("z"), table.numbers("order")};
  const auto finite = [](double value) { return std::isfinite(value); };
  if (table.rows() < 3 || !std::ranges::all_of(profile.r, finite)
      || !std::ranges::all_of(profile.z, finite) || std::ranges::max(profile.r) <= 0.0) {
    throw InputError(
        fmt::format("{}: needs at least three points with finite r and z, not all on the axis; "
                    "compute this point again.",
                    file.string()));
  }
  return profile;
}

Cut mirrored(const Profile& profile) {
  const auto [low, high] = std::ranges::minmax(profile.z);
  const double middle = 0.5 * (low + high);
  Cut cut;
  for (std::size_t i = 0; i < profile.r.size(); ++i) {
    cut.points.push_back({profile.r[i], profile.z[i] - middle});
    cut.order.push_back(profile.order[i]);
  }
  for (std::size_t i = profile.r.size() - 1;
       i-- > 0;) {  // back to the north pole on the other side
    cut.points.push_back({-profile.r[i], profile.z[i] - middle});
    cut.order.push_back(profile.order[i]);
  }
  cut.half_width = std::ranges::max(profile.r);
  cut.half_height = 0.5 * (high - low);
  return cut;
}

Cut thinned(const Cut& cut, double spacing) {
  constexpr double largest_turn = 0.04;  // radian
  Cut kept = cut;
  kept.points.assign(1, cut.points.front());
  kept.order.assign(1, cut.order.front());
  double travelled = 0.0;
  double turned = 0.0;
  for (std::size_t i = 1; i < cut.points.size(); ++i) {
    const auto& [x, y] = cut.points[i];
    const double dx = x - cut.points[i - 1][0];
    const double dy = y - cut.points[i - 1][1];
    travelled += std::hypot(dx, dy);
    if (i + 1 < cut.points.size()) {
      const double ex = cut.points[i + 1][0] - x;
      const double ey = cut.points[i + 1][1] - y;
      turned += std::abs(std::atan2(dx * ey - dy * ex, dx * ex + dy * ey));
    }
    const bool last = i + 1 == cut.points.size();
    const bool turns = turned > largest_turn && travelled > 0.15 * spacing;
    if (last || travelled > spacing || turns) {
      kept.points.push_back(cut.points[i]);
      kept.order.push_back(cut.order[i]);
      travelled = turned = 0.0;
    }
  }
  return kept;
}

}  // namespace sbeh::picture
