#include "tools/picture/section/cut.h"

#include "axisym/curvature.h"
#include "tools/picture/chart/chart.h"

#include <algorithm>
#include <cmath>

namespace sbeh::picture {

Cut mirrored(const axisym::State& profile) {
  const auto r = profile.X.row(0), z = profile.X.row(1);
  const double low = z.minCoeff(), high = z.maxCoeff(), middle = 0.5 * (low + high);
  const bool has_elements = r.size() % 3 == 1;  // 3 n + 1 nodes
  const axisym::Field H = has_elements ? axisym::mean_curvature(profile.X) : axisym::Field();
  Cut cut;
  const auto add = [&](Eigen::Index i, double sign) {
    cut.points.push_back({sign * r[i], z[i] - middle});
    cut.order.push_back(profile.beta[i]);
    if (H.size()) cut.curvature.push_back(H[i]);
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
  Cut kept{.points = {},
           .order = {},
           .curvature = {},
           .half_width = cut.half_width,
           .half_height = cut.half_height};
  const auto keep = [&](std::size_t i) {
    kept.points.push_back(cut.points[i]);
    kept.order.push_back(cut.order[i]);
    if (!cut.curvature.empty()) kept.curvature.push_back(cut.curvature[i]);
  };
  keep(0);
  double travelled = 0.0, turned = 0.0;
  for (std::size_t i = 1; i < cut.points.size(); ++i) {
    const auto& [x, y] = cut.points[i];
    const double dx = x - cut.points[i - 1][0], dy = y - cut.points[i - 1][1];
    travelled += std::hypot(dx, dy);
    if (i + 1 < cut.points.size()) {
      const double ex = cut.points[i + 1][0] - x, ey = cut.points[i + 1][1] - y;
      turned += std::abs(std::atan2(dx * ey - dy * ex, dx * ex + dy * ey));
    }
    const bool last = i + 1 == cut.points.size();
    const bool turns = turned > largest_turn && travelled > 0.15 * spacing;
    if (last || travelled > spacing || turns) {
      keep(i);
      travelled = turned = 0.0;
    }
  }
  return kept;
}

void Extent::include(const Cut& cut) {
  half_width = std::max(half_width, cut.half_width);
  half_height = std::max(half_height, cut.half_height);
}

void FieldRanges::include(const Cut& cut) {
  for (const double value : cut.order)
    if (std::isfinite(value)) order.include(value);
  for (const double value : cut.curvature)
    if (std::isfinite(value)) curvature.include(value);
}

CutColours colours_for(const FieldRanges& ranges, const Options& options) {
  const Field field = options.field_for(ranges.order);
  return {field,
          chosen_colours(options, palette_of(field),
                         field == Field::order ? ranges.order : ranges.curvature, 0.0,
                         dimension_of(field)),
          options.titled(title_of(field), dimension_of(field))};
}

LineStyle style_by_length(std::size_t length, std::size_t count) {
  const double fraction = count == 1 ? 1.0 : double(length) / double(count - 1);
  const auto grey = static_cast<unsigned char>(190.0 * (1.0 - fraction));
  return {.colour = {grey, grey, grey}, .width = 1.4 + 0.8 * fraction};
}

void draw_cuts(Canvas& canvas, const Rect& cell, double scale, const std::vector<CutLine>& lines) {
  constexpr double point_distance = 3.0;  // pixels
  const double x = 0.5 * cell.width / scale;
  const double y = 0.5 * cell.height / scale;
  Chart chart(canvas, cell, 1.0, {.low = -x, .high = x}, {.low = -y, .high = y});
  for (const CutLine& line : lines) {
    const Cut cut = thinned(*line.cut, point_distance / scale);
    if (!line.colours) {
      chart.curve(cut.points, line.style);
      continue;
    }
    std::vector<Colour> colours;
    for (const double value : line.colours->values(cut))
      colours.push_back(std::isfinite(value) ? line.colours->map(value) : dark_grey);
    if (colours.empty()) colours.assign(cut.points.size(), dark_grey);
    chart.coloured_curve(cut.points, colours, line.style.width);
  }
}

}  // namespace sbeh::picture
