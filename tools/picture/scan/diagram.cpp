#include "tools/picture/scan/diagram_lines.h"
#include "tools/picture/scan/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_table_cells = 30;

std::vector<Quantity> quantities_of(const ScanGrid& scan, const std::optional<BranchMap>& lowest) {
  const Model model = scan.has(Model::SBEH) ? Model::SBEH : Model::SSH;
  std::vector<Quantity> all;
  if (scan.has(Model::SBEH) && scan.has(Model::SSH)) {
    all.push_back(energy_gap(scan, lowest));
  } else {
    fmt::print("diagram: no {} rows, so the energy itself in place of the energy gap\n",
               model == Model::SBEH ? "SSH" : "SBEH");
    all.push_back(energy(scan, model, lowest));
  }
  if (model == Model::SBEH) all.push_back(smallest_order(scan, lowest));
  all.push_back(largest_curvature(scan, model, lowest));
  return all;
}

// What the picture shows: the map of branches where there are several, then the quantities.
struct Contents {
  std::vector<Quantity> quantities;
  bool as_table;
  std::optional<BranchMap> branches{};
  std::vector<ColourMap> colours{};  // of the quantities
  std::vector<DiagramLine> lines{};
  std::vector<LegendEntry> legend{};
};

// Whether any of its points is among the scan's.
bool is_within(const DiagramLine& line, const ScanGrid& scan) {
  const auto between = [](double value, const std::vector<double>& values) {
    return value >= values.front() && value <= values.back();
  };
  return std::ranges::any_of(line.points, [&](const auto& point) {
    return between(point[0], scan.reduced_volumes()) && between(point[1], scan.lengths());
  });
}

Contents contents_of(const ScanGrid& scan, const Options& options) {
  const bool ordered = scan.has(Model::SBEH);
  Contents c{.quantities = {},
             .as_table = scan.reduced_volumes().size() * scan.lengths().size() <= most_table_cells};
  if (options.branch.empty())
    c.branches = lowest_branches(scan, options.directory, ordered ? Model::SBEH : Model::SSH);
  c.quantities = quantities_of(scan, c.branches);
  for (const Quantity& quantity : c.quantities)
    c.colours.emplace_back(quantity.palette, quantity.range());
  // A table's cells are full of numbers: there only the map of branches has lines.
  if (ordered && (c.branches || !c.as_table))
    c.lines = diagram_lines(options.directory, options.branch);
  std::erase_if(c.lines, [&](const DiagramLine& line) { return !is_within(line, scan); });
  const auto add = [&](std::vector<LegendEntry> entries) {
    c.legend.insert(c.legend.end(), entries.begin(), entries.end());
  };
  if (c.branches) add(branch_legend(*c.branches));
  add(legend_of(c.lines));
  std::vector<Quantity> panels = c.quantities;
  if (c.branches) panels.push_back(c.branches->quantity);
  add(mark_legend(panels, c.as_table));
  return c;
}

void draw_heat_maps(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  const Contents contents = contents_of(scan, options);
  const double text = options.text_size();
  double bars = 0.0;  // the width that all bars take with their numbers
  for (const ColourMap& colours : contents.colours)
    bars += 1.7 * text + colour_bar_margin(canvas, colours, false, text);
  const auto count = double(contents.quantities.size() + (contents.branches ? 1 : 0));
  const double width = options.width(533.0 * count);
  const double left = 5.2 * text, gap = 1.8 * text;
  const double inner_width = (width - left - bars - gap * count) / count;
  const double legend_at = legend_height(canvas, contents.legend, width - 2.0 * text, text);
  const double below = below_axis(text) + (contents.legend.empty() ? 0.0 : 0.8 * text + legend_at),
               above = 2.6 * text;
  const double height = options.height(below + above + 1.15 * inner_width);
  const double inner_height = height - below - above;

  const char *volume = "reduced volume Vᵣ", *constant = "elastic constant L";
  HeatMapGrid grid{.as_table = contents.as_table};
  grid.x = grid.as_table ? table_axis(scan.reduced_volumes(), volume)
                         : distance_axis(scan.reduced_volumes(), volume, inner_width, 3.2 * text);
  grid.y = grid.as_table ? table_axis(scan.lengths(), constant)
                         : distance_axis(scan.lengths(), constant, inner_height, 3.0 * text);

  canvas.start(width, height);
  double x = left;
  // A panel with its lines and title; the next one stands beyond `room` and has no numbers on its axis.
  const auto panel = [&](const std::string& title, double room, bool numbers, auto&& draw) {
    const Rect inside{x, below, inner_width, inner_height};
    draw(inside);
    if (!numbers) draw_diagram_lines(canvas, inside, contents.lines, grid);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, title, {.size = text});
    x += inner_width + room + gap;
    grid.y.axis.title.clear();
    std::ranges::fill(grid.y.axis.labels, "");
  };
  if (contents.branches)
    panel(contents.branches->quantity.title, 0.0, false, [&](const Rect& inside) {
      draw_branch_map(canvas, inside, *contents.branches, grid, text);
    });
  for (std::size_t i = 0; i < contents.quantities.size(); ++i)
    panel(contents.quantities[i].title,
          1.7 * text + colour_bar_margin(canvas, contents.colours[i], false, text), grid.as_table,
          [&](const Rect& inside) {
            draw_heat_map(canvas, inside, contents.quantities[i], contents.colours[i], grid, text);
          });
  draw_legend(canvas, contents.legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "diagram");
}

}  // namespace

void draw_diagram_picture(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  if ((scan.reduced_volumes().size() == 1) != (scan.lengths().size() == 1))
    draw_line_diagram(canvas, scan, options);
  else
    draw_heat_maps(canvas, scan, options);
}

}  // namespace sbeh::picture
