#include "tools/picture/section/cut.h"

#include <cmath>

namespace sbeh::picture {

Cut mirrored(const axisym::State& profile) {
  const auto r = profile.X.row(0), z = profile.X.row(1);
  const double low = z.minCoeff(), high = z.maxCoeff(), middle = 0.5 * (low + high);
  Cut cut;
  const auto add = [&](Eigen::Index i, double sign) {
    cut.points.push_back({sign * r[i], z[i] - middle});
    cut.order.push_back(profile.beta[i]);
  };
  const Eigen::Index count = r.size();
  for (Eigen::Index i = 0; i < count; ++i) add(i, 1);
  for (Eigen::Index i = count - 1; i-- > 0;) add(i, -1);  // back on the other side
  cut.half_width = r.maxCoeff();
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
