#include "tools/picture/chart/colours.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sbeh::picture {
namespace {

using Table = std::vector<std::array<int, 3>>;

// At equal distances from 0 to 1: viridis and magma of S. van der Walt and N. Smith, cividis of J. Nunez,
// C. Anderton and R. Renslow. Magma begins where it is no longer black.
const Table& table_of(Palette palette) {
  static const Table viridis{{68, 1, 84},    {72, 36, 117},  {65, 68, 135},  {53, 95, 141},
                             {42, 120, 142}, {33, 145, 140}, {34, 168, 132}, {68, 191, 112},
                             {122, 209, 81}, {189, 223, 38}, {253, 231, 37}};
  static const Table cividis{{0, 32, 77},     {0, 51, 111},    {57, 72, 107},   {87, 92, 109},
                             {112, 113, 115}, {138, 135, 121}, {166, 157, 117}, {196, 181, 108},
                             {228, 207, 91},  {255, 234, 70}};
  static const Table magma{{24, 15, 62},    {69, 16, 119},   {114, 31, 129},
                           {159, 47, 127},  {205, 64, 113},  {241, 96, 93},
                           {253, 149, 103}, {254, 201, 141}, {252, 253, 191}};
  static const Table grey{{20, 20, 20}, {235, 235, 235}};
  switch (palette) {
    case Palette::viridis:
      return viridis;
    case Palette::cividis:
      return cividis;
    case Palette::magma:
      return magma;
    case Palette::grey:
      return grey;
  }
  return viridis;
}

constexpr double tick_distance = 0.15;  // of the bar's length
constexpr int table_size = 64;

}  // namespace

ColourMap::ColourMap(Palette palette, const Range& range, double white_share, double factor)
    : scale_(range.empty() ? linear_axis(0.0, 1.0, 1.0, tick_distance)
                           : linear_axis(range.low, range.high, 1.0, tick_distance)),
      factor_(factor) {
  if (range.width() > 1e-9 * std::abs(range.high)) scale_ = cropped(scale_, range.low, range.high);
  vtkNew<vtkColorTransferFunction> function;
  const Table& colours = table_of(palette);
  const auto lightened = [&](int channel) {
    return channel / 255.0 + white_share * (1 - channel / 255.0);
  };
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const auto& [r, g, b] = colours[i];
    function->AddRGBPoint(double(i) / double(colours.size() - 1), lightened(r), lightened(g),
                          lightened(b));
  }
  const unsigned char* table = function->GetTable(0.0, 1.0, table_size);
  for (int i = 0; i < table_size; ++i)
    table_.push_back({table[3 * i], table[3 * i + 1], table[3 * i + 2]});
}

Colour ColourMap::at(double share) const {
  const double fraction = std::clamp(share, 0.0, 1.0);
  return table_[std::size_t(std::lround(fraction * (table_size - 1)))];
}

ColourMap chosen_colours(const Options& options, Palette usual, const Range& data,
                         double white_share, const studies::Dimension& dimension) {
  const double factor = options.factor(dimension);
  const Range shown = data.empty() ? data : Range{factor * data.low, factor * data.high};
  return {options.palette.value_or(usual), options.scale.value_or(shown), white_share, factor};
}

void draw_colour_bar(Canvas& canvas, const Rect& rect, const ColourMap& map,
                     const std::string& title, double text_size, double title_room) {
  constexpr int steps = 100;
  const Axis& axis = map.scale();
  for (int i = 0; i < steps; ++i) {
    const double y = rect.y + i * rect.height / steps;
    canvas.fill({rect.x, y, rect.width, rect.height / steps + (i + 1 < steps ? 1.0 : 0.0)},
                map.at((i + 0.5) / steps));
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
  if (!title.empty())
    canvas.text(x, rect.centre_y(), title,
                {.size = fitted_size(canvas, {title}, std::max(title_room, rect.height), text_size),
                 .upward = true});
}

void draw_short_bar(Canvas& canvas, double x, const Range& room, const ColourMap& map,
                    const std::string& title, double text_size) {
  const double length = std::min(room.width(), 18.0 * text_size);
  draw_colour_bar(canvas, {x, 0.5 * (room.low + room.high - length), text_size, length}, map, title,
                  text_size, room.width());
}

double colour_bar_margin(const Canvas& canvas, const ColourMap& map, bool title, double text_size) {
  double widest = 0.0;
  for (const auto& label : map.scale().labels)
    widest = std::max(widest, canvas.text_width(label, 0.85 * text_size));
  return 0.5 * text_size + widest + (title ? 1.8 * text_size : 0.0);
}

std::vector<Colour> line_colours(std::size_t count) {
  const ColourMap map(Palette::viridis, {0.0, 1.0});
  constexpr double lightest = 0.83;  // what is paler is not seen on white
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < count; ++i)
    colours.push_back(map(count == 1 ? 0.0 : lightest * (1 - double(i) / double(count - 1))));
  return colours;
}

Colour ink_on(Colour background) {
  const double luminance =
      0.299 * background.red + 0.587 * background.green + 0.114 * background.blue;
  return luminance > 128.0 ? black : white;
}

}  // namespace sbeh::picture
