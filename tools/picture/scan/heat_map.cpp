#include "tools/picture/scan/heat_map.h"

#include "tools/picture/scan/contours.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr double hatch_distance = 9.0;  // pixels at the usual size of letters
constexpr double dot_distance = 14.0, dot_size = 2.2;
// Of the width: shorter pieces, at the rugged edges of regions and in corners, are only noise.
constexpr double shortest_contour = 0.12;

double to_pixels(double value, const Axis& axis, double origin, double length) {
  return origin + axis.share(value) * length;
}

// The ends of parallel lines at 45° through the rectangle, or at −45°.
void add_hatch(Points& ends, const Rect& r, double unit, bool falling = false) {
  const double distance = std::min(unit * hatch_distance, 0.7 * std::min(r.width, r.height));
  for (double c = 0.5 * distance; c < r.width + r.height; c += distance) {
    // From the left or upper edge to the lower or right edge: x − r.x + (r.top − y) = c.
    const double from = std::max(0.0, c - r.height), to = std::min(r.width, c);
    for (const double x : {from, to})
      ends.push_back({r.x + x, falling ? r.y + (c - x) : r.top() - (c - x)});
  }
}

// On a lattice that goes on from cell to cell, one at least in each.
void add_dots(Points& ends, const Rect& r, double unit) {
  const double distance = unit * dot_distance, half = 0.5 * unit * dot_size;
  const auto first = [&](double edge) { return distance * std::ceil(edge / distance); };
  const auto add = [&](double x, double y) {
    ends.insert(ends.end(), {{x - half, y}, {x + half, y}});
  };
  if (std::min(r.width, r.height) < distance) return add(r.centre_x(), r.centre_y());
  for (double x = first(r.x); x < r.right(); x += distance)
    for (double y = first(r.y); y < r.top(); y += distance) add(x, y);
}

void add_cross(Points& ends, const Rect& r) {
  const double half = 0.32 * std::min(r.width, r.height);
  const double x = r.centre_x(), y = r.centre_y();
  ends.insert(
      ends.end(),
      {{x - half, y - half}, {x + half, y + half}, {x - half, y + half}, {x + half, y - half}});
}

void add_polygon(Points& ends, const Points& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k)
    ends.insert(ends.end(), {corners[k], corners[(k + 1) % corners.size()]});
}

void add_diamond(Points& ends, const Rect& r) {
  const double half = 0.32 * std::min(r.width, r.height);
  const double x = r.centre_x(), y = r.centre_y();
  add_polygon(ends, {{x - half, y}, {x, y + half}, {x + half, y}, {x, y - half}});
}

// In the corner of the cell, off its number.
void add_small_square(Points& ends, const Rect& r) {
  const double side = 0.3 * std::min(r.width, r.height), x = r.x + 0.3 * side, y = r.y + 0.3 * side;
  add_polygon(ends, {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

struct Cell {
  Rect rect;
  Colour colour;
  Mark mark;
  double value;
  bool striped = false;
  bool dotted = false;
};

constexpr Colour without_value{205, 205, 205};

void draw_cells(Canvas& canvas, const std::vector<Cell>& cells) {
  Points hatch, stripes, signs, on_dark, on_light, dots_on_dark, dots_on_light;
  for (const Cell& cell : cells) {
    canvas.fill(cell.rect, cell.colour);
    if (cell.striped) add_hatch(stripes, cell.rect, canvas.unit(), true);
    if (cell.mark == Mark::unresolved) add_hatch(hatch, cell.rect, canvas.unit());
    if (cell.mark == Mark::singular) add_hatch(stripes, cell.rect, canvas.unit(), true);
    if (cell.mark == Mark::failed) add_cross(signs, cell.rect);
    if (cell.mark == Mark::not_found) add_diamond(signs, cell.rect);
    const bool is_light = ink_on(cell.colour).red == 0;
    if (cell.dotted) add_dots(is_light ? dots_on_light : dots_on_dark, cell.rect, canvas.unit());
    if (cell.mark == Mark::limit) add_small_square(is_light ? on_light : on_dark, cell.rect);
  }
  canvas.segments(stripes, {.colour = dark_grey, .width = 1.2});
  canvas.segments(hatch, {.colour = {150, 150, 150}, .width = 1.0});
  canvas.segments(signs, {.colour = dark_grey, .width = 1.0});
  canvas.segments(on_dark, {.colour = white, .width = 1.2});
  canvas.segments(on_light, {.colour = black, .width = 1.2});
  canvas.segments(dots_on_dark, {.colour = white, .width = dot_size});
  canvas.segments(dots_on_light, {.colour = black, .width = dot_size});
}

// As many decimals as show three digits of the largest value and two of the differences.
std::string number_text(double value, const ColourMap& colours) {
  const double largest = std::max(std::abs(colours.scale().low), std::abs(colours.scale().high));
  const double range = colours.scale().high - colours.scale().low;
  const int decimals = std::clamp(
      std::max(2 - int(std::floor(std::log10(largest))), 1 - int(std::floor(std::log10(range)))), 0,
      6);
  return with_minus(fmt::format("{:.{}f}", value, decimals));
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
    for (const Points& line : contours_of_cells(grid.x, grid.y, values, level)) {
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
  double width = canvas.text_width(text, size);
  const double room = 0.92 * cell.width;
  if (width > room) {
    size *= room / width;
    width = room;
  }
  canvas.fill({cell.centre_x() - 0.5 * width, cell.centre_y() - 0.5 * size, width, size}, colour);
  canvas.text(cell.centre_x(), cell.centre_y(), text, {.size = size, .colour = ink_on(colour)});
}

struct Look {
  Colour colour;
  bool striped = false;
};

std::vector<Cell> cells_of(const Rect& inside, const Quantity& quantity, const HeatMapGrid& grid,
                           const std::function<Look(double)>& look_of) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < grid.x.centres.size(); ++i) {
    const double left = to_pixels(grid.x.edges[i], grid.x.axis, inside.x, inside.width);
    const double right = to_pixels(grid.x.edges[i + 1], grid.x.axis, inside.x, inside.width);
    for (std::size_t j = 0; j < grid.y.centres.size(); ++j) {
      const double bottom = to_pixels(grid.y.edges[j], grid.y.axis, inside.y, inside.height);
      const double top = to_pixels(grid.y.edges[j + 1], grid.y.axis, inside.y, inside.height);
      const double value = quantity.values[i][j];
      if (quantity.marks[i][j] == Mark::absent) continue;
      // Under its neighbours: between two that only touch the ground would be seen.
      constexpr double over = 0.4;
      const Look look = std::isfinite(value) ? look_of(value) : Look{without_value};
      cells.push_back({{left, bottom, std::min(right + over, inside.right()) - left,
                        std::min(top + over, inside.top()) - bottom},
                       look.colour,
                       quantity.marks[i][j],
                       value,
                       look.striped,
                       quantity.saddles[i][j]});
    }
  }
  return cells;
}

// Light, so that lines stand out, and of different lightness. Limits are striped, in the colour of the branch they are
// limits of.
Look look_of_branch(const std::string& branch) {
  if (branch == "oblate") return {{126, 172, 214}};
  if (branch == "prolate") return {{252, 222, 168}};
  if (branch == "sharp_oblate") return {{126, 172, 214}, true};
  return {{104, 164, 132}, branch == "nested_spheres"};
}

std::string text_of(const std::string& branch) {
  if (branch == "sharp_oblate") return "oblate, sharp rim";
  return branch == "nested_spheres" ? "sphere in a sphere" : branch;
}

}  // namespace

void draw_heat_map(Canvas& canvas, const Rect& inside, const Quantity& quantity,
                   const ColourMap& colours, const HeatMapGrid& grid, double text_size) {
  const auto cells = cells_of(inside, quantity, grid, [&](double v) { return Look{colours(v)}; });
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

void draw_branch_map(Canvas& canvas, const Rect& inside, const BranchMap& map,
                     const HeatMapGrid& grid, double text_size) {
  draw_cells(canvas, cells_of(inside, map.quantity, grid, [&](double branch) {
               return look_of_branch(map.names[std::size_t(branch)]);
             }));
  Chart(canvas, inside, text_size, grid.x.axis, grid.y.axis);
}

std::vector<LegendEntry> branch_legend(const BranchMap& map) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < map.names.size(); ++i) {
    const auto shows = [&](const auto& row) {
      return std::ranges::find(row, double(i)) != row.end();
    };
    if (std::ranges::none_of(map.quantity.values, shows)) continue;
    const Look look = look_of_branch(map.names[i]);
    entries.push_back({[look](Canvas& canvas, const Rect& r) {
                         draw_cells(canvas, {{r, look.colour, Mark::none, 0.0, look.striped}});
                       },
                       text_of(map.names[i])});
  }
  return entries;
}

std::vector<LegendEntry> mark_legend(const std::vector<Quantity>& quantities, bool as_table) {
  const auto any = [&](Mark mark) {
    return std::ranges::any_of(quantities, [&](const Quantity& q) { return q.has(mark); });
  };
  constexpr std::pair<Mark, const char*> meanings[] = {
      {Mark::unresolved, "unresolved"},
      {Mark::failed, "failed"},
      {Mark::not_found, "a lower state must exist"},
      {Mark::singular, "no smooth shape"},
      {Mark::limit, "limit: the neck has closed"}};
  std::vector<LegendEntry> entries;
  for (const auto& [mark, meaning] : meanings)
    if (any(mark))
      entries.push_back({[mark = mark](Canvas& canvas, const Rect& r) {
                           draw_cells(canvas, {{r, without_value, mark, 0.0}});
                         },
                         meaning});
  if (std::ranges::any_of(quantities, &Quantity::has_saddle))
    entries.push_back({[](Canvas& canvas, const Rect& r) {
                         draw_cells(canvas, {{r, light_grey, Mark::none, 0.0, false, true}});
                       },
                       "no minimum in 3D"});
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
