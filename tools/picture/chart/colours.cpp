#include "tools/picture/chart/colours.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sbeh::picture {
namespace {

// The map viridis of S. van der Walt and N. Smith at equal distances from 0 to 1.
constexpr std::array<std::array<double, 3>, 11> viridis{{{0.267, 0.005, 0.329},
                                                         {0.283, 0.141, 0.458},
                                                         {0.254, 0.265, 0.530},
                                                         {0.207, 0.372, 0.553},
                                                         {0.164, 0.471, 0.558},
                                                         {0.128, 0.567, 0.551},
                                                         {0.135, 0.659, 0.518},
                                                         {0.267, 0.749, 0.441},
                                                         {0.478, 0.821, 0.318},
                                                         {0.741, 0.873, 0.150},
                                                         {0.993, 0.906, 0.144}}};

constexpr double tick_distance = 0.15;  // of the bar's length
constexpr int table_size = 64;

}  // namespace

ColourMap::ColourMap(Palette palette, const Range& range)
    : scale_(linear_axis(range.low, range.high, 1.0, tick_distance)) {
  if (range.width() > 1e-9 * std::abs(range.high)) scale_ = cropped(scale_, range.low, range.high);
  vtkNew<vtkColorTransferFunction> function;
  const std::size_t used = palette == Palette::lines ? viridis.size() - 1 : viridis.size();
  for (std::size_t i = 0; i < used; ++i) {
    auto [r, g, b] = viridis[palette == Palette::lines ? used - 1 - i : i];
    if (palette == Palette::surfaces) {
      constexpr double white_share = 0.22;
      for (double* channel : {&r, &g, &b}) *channel += white_share * (1 - *channel);
    }
    if (palette == Palette::plain) r = g = b = 0.82;
    function->AddRGBPoint(double(i) / double(used - 1), r, g, b);
  }
  const unsigned char* table = function->GetTable(0.0, 1.0, table_size);
  for (int i = 0; i < table_size; ++i)
    table_.push_back({table[3 * i], table[3 * i + 1], table[3 * i + 2]});
}

Colour ColourMap::operator()(double value) const {
  const double fraction = std::clamp(scale_.share(value), 0.0, 1.0);
  return table_[std::size_t(std::lround(fraction * (table_size - 1)))];
}

void draw_colour_bar(Canvas& canvas, const Rect& rect, const ColourMap& map,
                     const std::string& title, double text_size) {
  constexpr int steps = 100;
  const Axis& axis = map.scale();
  for (int i = 0; i < steps; ++i) {
    const double y = rect.y + i * rect.height / steps;
    const double value = axis.low + (i + 0.5) / steps * (axis.high - axis.low);
    canvas.fill({rect.x, y, rect.width, rect.height / steps + (i + 1 < steps ? 1.0 : 0.0)},
                map(value));
  }
  const LineStyle thin{.colour = dark_grey, .width = 1.2};
  canvas.line(rect.outline(), thin);
  const double spacing = rect.height * tick_distance;
  const auto stride = std::size_t(std::ceil(1.2 * text_size / spacing));
  for (std::size_t i = 0; i < axis.ticks.size(); i += stride) {
    const double y = rect.y + axis.share(axis.ticks[i]) * rect.height;
    canvas.line({{rect.right(), y}, {rect.right() + 0.3 * text_size, y}}, thin);
    canvas.text(rect.right() + 0.5 * text_size, y, axis.labels[i],
                {.size = 0.85 * text_size, .align = Align::left});
  }
  const double x = rect.right() + colour_bar_margin(canvas, map, true, text_size) - 0.6 * text_size;
  if (!title.empty()) canvas.text(x, rect.centre_y(), title, {.size = text_size, .upward = true});
}

void draw_short_bar(Canvas& canvas, double x, const Range& room, const ColourMap& map,
                    const std::string& title, double text_size) {
  const double length = std::min(room.width(), 18.0 * text_size);
  draw_colour_bar(canvas, {x, 0.5 * (room.low + room.high - length), text_size, length}, map, title,
                  text_size);
}

double colour_bar_margin(const Canvas& canvas, const ColourMap& map, bool title, double text_size) {
  double widest = 0.0;
  for (const auto& label : map.scale().labels)
    widest = std::max(widest, canvas.text_width(label, 0.85 * text_size));
  return 0.5 * text_size + widest + (title ? 1.8 * text_size : 0.0);
}

std::vector<Colour> line_colours(std::size_t count) {
  const ColourMap map(Palette::lines, {0.0, 1.0});
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < count; ++i)
    colours.push_back(map(count == 1 ? 1.0 : 0.08 + 0.92 * double(i) / double(count - 1)));
  return colours;
}

Colour ink_on(Colour background) {
  const double luminance =
      0.299 * background.red + 0.587 * background.green + 0.114 * background.blue;
  return luminance > 128.0 ? black : white;
}

}  // namespace sbeh::picture
