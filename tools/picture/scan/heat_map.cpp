#include "tools/picture/scan/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

namespace sbeh::picture {
namespace {

constexpr double hatch_distance = 9.0;  // pixels
// Of the width: shorter pieces, at the rugged edges of regions and in corners, are only noise.
constexpr double shortest_contour = 0.12;

double to_pixels(double value, const Axis& axis, double origin, double length) {
  return origin + axis.share(value) * length;
}

// The ends of parallel lines at 45° through the rectangle.
void add_hatch(Points& ends, const Rect& r) {
  const double distance = std::min(hatch_distance, 0.7 * std::min(r.width, r.height));
  for (double c = 0.5 * distance; c < r.width + r.height; c += distance) {
    // From the left or upper edge to the lower or right edge: x − r.x + (r.top − y) = c.
    const double from = std::max(0.0, c - r.height), to = std::min(r.width, c);
    ends.push_back({r.x + from, r.top() - (c - from)});
    ends.push_back({r.x + to, r.top() - (c - to)});
  }
}

void add_cross(Points& ends, const Rect& r) {
  const double half = 0.32 * std::min(r.width, r.height);
  const double x = r.centre_x(), y = r.centre_y();
  ends.insert(
      ends.end(),
      {{x - half, y - half}, {x + half, y + half}, {x - half, y + half}, {x + half, y - half}});
}

// A diamond, closed by four segments.
void add_diamond(Points& ends, const Rect& r) {
  const double half = 0.32 * std::min(r.width, r.height);
  const double x = r.centre_x(), y = r.centre_y();
  const Points corners{{x - half, y}, {x, y + half}, {x + half, y}, {x, y - half}};
  for (std::size_t k = 0; k < 4; ++k) ends.insert(ends.end(), {corners[k], corners[(k + 1) % 4]});
}

struct Cell {
  Rect rect;
  Colour colour;
  Mark mark;
  double value;
};

void draw_cells(Canvas& canvas, const std::vector<Cell>& cells) {
  Points on_dark, on_light, signs;
  for (const Cell& cell : cells) {
    canvas.fill(cell.rect, cell.colour);
    if (cell.mark == Mark::failed) add_cross(signs, cell.rect);
    if (cell.mark == Mark::not_found) add_diamond(signs, cell.rect);
    if (cell.mark != Mark::unresolved) continue;
    add_hatch(ink_on(cell.colour).red == 0 ? on_light : on_dark, cell.rect);
  }
  canvas.segments(on_dark, {.colour = white, .width = 1.0});
  canvas.segments(on_light, {.colour = black, .width = 1.0});
  canvas.segments(signs, {.colour = dark_grey, .width = 1.0});
}

// As many decimals as show three digits of the largest value and two of the differences.
std::string number_text(double value, const ColourMap& colours) {
  const double largest = std::max(std::abs(colours.scale().low), std::abs(colours.scale().high));
  const double range = colours.scale().high - colours.scale().low;
  const int decimals = std::clamp(
      std::max(2 - int(std::floor(std::log10(largest))), 1 - int(std::floor(std::log10(range)))), 0,
      6);
  return fmt::format("{:.{}f}", value, decimals);
}

// The values of one region alone.
std::vector<std::vector<double>> values_in(const Quantity& quantity, int region) {
  auto values = quantity.values;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < values[i].size(); ++j)
      if (quantity.regions[i][j] != region) values[i][j] = std::numeric_limits<double>::quiet_NaN();
  return values;
}

void draw_contours(Canvas& canvas, const Rect& inside, const Quantity& quantity, int region,
                   const ColourMap& colours, const HeatMapGrid& grid) {
  const auto values = values_in(quantity, region);
  for (const double level : colours.scale().ticks) {
    for (const Points& line : contour_lines(grid.x.centres, grid.y.centres, values, level)) {
      Points pixels;
      for (const auto& [x, y] : line)
        pixels.push_back({to_pixels(x, grid.x.axis, inside.x, inside.width),
                          to_pixels(y, grid.y.axis, inside.y, inside.height)});
      if (length_of(pixels) < shortest_contour * inside.width) continue;
      canvas.line(pixels, {.colour = ink_on(colours(level)), .width = 1.8});
    }
  }
}

void draw_number(Canvas& canvas, const Rect& cell, const std::string& text, Colour colour,
                 double text_size) {
  double size = 0.8 * text_size;
  const double width = canvas.text_width(text, size);
  const double room = 0.92 * cell.width;
  if (width > room) size *= room / width;
  const Rect box{cell.centre_x() - 0.53 * std::min(width, room), cell.centre_y() - 0.6 * size,
                 1.06 * std::min(width, room), 1.2 * size};
  canvas.fill(box, colour);  // keeps the hatching off the digits
  canvas.text(cell.centre_x(), cell.centre_y(), text, {.size = size, .colour = ink_on(colour)});
}

std::vector<Cell> cells_of(const Rect& inside, const Quantity& quantity, const HeatMapGrid& grid,
                           const std::function<Colour(double)>& colour) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < grid.x.centres.size(); ++i) {
    const double left = to_pixels(grid.x.edges[i], grid.x.axis, inside.x, inside.width);
    const double right = to_pixels(grid.x.edges[i + 1], grid.x.axis, inside.x, inside.width);
    for (std::size_t j = 0; j < grid.y.centres.size(); ++j) {
      const double bottom = to_pixels(grid.y.edges[j], grid.y.axis, inside.y, inside.height);
      const double top = to_pixels(grid.y.edges[j + 1], grid.y.axis, inside.y, inside.height);
      const double value = quantity.values[i][j];
      if (quantity.marks[i][j] == Mark::absent) continue;
      cells.push_back({{left, bottom, right - left, top - bottom},
                       std::isfinite(value) ? colour(value) : light_grey,
                       quantity.marks[i][j],
                       value});
    }
  }
  return cells;
}

// Light, so that lines stand out.
Colour branch_colour(std::size_t index) {
  static constexpr std::array<Colour, 5> colours{
      {{158, 202, 225}, {253, 190, 133}, {161, 217, 155}, {222, 190, 230}, {250, 225, 150}}};
  return colours[index % colours.size()];
}

std::string text_of(const std::string& branch) {
  if (branch == "sharp_oblate") return "oblate, sharp rim";
  return branch == "nested_spheres" ? "sphere in a sphere" : branch;
}

}  // namespace

void draw_heat_map(Canvas& canvas, const Rect& inside, const Quantity& quantity,
                   const ColourMap& colours, const HeatMapGrid& grid, double text_size) {
  const auto cells = cells_of(inside, quantity, grid, [&](double v) { return colours(v); });
  draw_cells(canvas, cells);
  if (grid.as_table) {
    for (const Cell& cell : cells) {
      if (!std::isfinite(cell.value)) continue;
      draw_number(canvas, cell.rect, number_text(cell.value, colours), cell.colour, text_size);
    }
  } else {
    std::set<int> regions;
    for (const auto& row : quantity.regions) regions.insert(row.begin(), row.end());
    regions.erase(-1);
    for (const int region : regions) draw_contours(canvas, inside, quantity, region, colours, grid);
  }
  Chart(canvas, inside, text_size, grid.x.axis, grid.y.axis);
  draw_colour_bar(canvas,
                  {inside.right() + 0.8 * text_size, inside.y, 0.9 * text_size, inside.height},
                  colours, "", text_size);
}

void draw_branch_map(Canvas& canvas, const Rect& inside, const Quantity& quantity,
                     const HeatMapGrid& grid, double text_size) {
  draw_cells(canvas, cells_of(inside, quantity, grid,
                              [](double branch) { return branch_colour(std::size_t(branch)); }));
  Chart(canvas, inside, text_size, grid.x.axis, grid.y.axis);
}

std::vector<LegendEntry> branch_legend(const std::vector<std::string>& branches) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < branches.size(); ++i)
    entries.push_back({[i](Canvas& canvas, const Rect& r) { canvas.fill(r, branch_colour(i)); },
                       text_of(branches[i])});
  return entries;
}

std::vector<LegendEntry> mark_legend(const std::vector<Quantity>& quantities, bool as_table) {
  const auto any = [&](Mark mark) {
    return std::ranges::any_of(quantities, [&](const Quantity& q) { return q.has(mark); });
  };
  const auto box = [](Mark mark, Colour colour) {
    return [mark, colour](Canvas& canvas, const Rect& r) {
      draw_cells(canvas, {{r, colour, mark, 0.0}});
    };
  };
  std::vector<LegendEntry> entries;
  if (any(Mark::unresolved))
    entries.push_back({box(Mark::unresolved, {190, 200, 205}), "unresolved"});
  if (any(Mark::failed)) entries.push_back({box(Mark::failed, light_grey), "failed"});
  if (any(Mark::not_found))
    entries.push_back({box(Mark::not_found, light_grey), "a lower state must exist"});
  if (any(Mark::absent)) {
    const auto frame = [](Canvas& canvas, const Rect& r) {
      canvas.line(r.outline(), {.colour = light_grey, .width = 1.5});
    };
    entries.push_back({frame, "not in the scan"});
  }
  if (!as_table) {
    entries.push_back(
        line_entry({.colour = black, .width = 1.5}, "contours at the ticks of the bar"));
  }
  return entries;
}

}  // namespace sbeh::picture
