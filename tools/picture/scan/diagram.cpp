#include "tools/picture/scan/diagram_lines.h"
#include "tools/picture/scan/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_table_cells = 30;

Quantity quantity_of(const std::string& panel, const ScanGrid& scan, Model model,
                     const std::optional<BranchMap>& lowest) {
  const bool both = scan.has(Model::SBEH) && scan.has(Model::SSH);
  if (panel == "gap" && both) return energy_gap(scan, lowest);
  if (panel == "energy") return energy(scan, model, lowest);
  if (panel == "order" && model == Model::SBEH) return smallest_order(scan, lowest);
  if (panel == "curvature") return largest_curvature(scan, model, lowest);
  throw InputError(fmt::format("--panels {}: the scan has not what that needs", panel));
}

// Those that the user asks for, or all that say something new.
std::vector<std::string> panels_of(const ScanGrid& scan, const Options& options,
                                   const std::optional<BranchMap>& lowest) {
  if (!options.panels.empty()) return options.panels;
  std::vector<std::string> panels;
  if (lowest) panels.emplace_back("lowest");
  const bool ordered = scan.has(Model::SBEH), both = ordered && scan.has(Model::SSH);
  panels.emplace_back(both ? "gap" : "energy");
  if (!both)
    fmt::print("diagram: no {} rows, so the energy itself in place of the energy gap\n",
               ordered ? "SSH" : "SBEH");
  if (ordered) panels.emplace_back("order");
  panels.emplace_back("curvature");
  return panels;
}

struct DiagramPanel {
  Quantity quantity;
  ColourMap colours;
};

// What the picture shows: panels in their order; the map of branches is one without a quantity.
struct Contents {
  std::vector<std::optional<DiagramPanel>> panels{};
  bool as_table;
  std::optional<BranchMap> branches{};
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
  const Model model = scan.has(Model::SBEH) ? Model::SBEH : Model::SSH;
  Contents c{.as_table = scan.reduced_volumes().size() * scan.lengths().size() <= most_table_cells};
  if (options.branch.empty()) c.branches = lowest_branches(scan, options.directory, model);
  std::vector<Quantity> marked;
  for (const std::string& panel : panels_of(scan, options, c.branches)) {
    if (panel == "lowest") {
      if (!c.branches) throw InputError("--panels lowest: the scan has one branch alone");
      c.panels.emplace_back();
      marked.push_back(c.branches->quantity);
      continue;
    }
    Quantity quantity = quantity_of(panel, scan, model, c.branches);
    marked.push_back(quantity);
    const ColourMap colours = chosen_colours(options, quantity.palette, quantity.range());
    c.panels.emplace_back(DiagramPanel{std::move(quantity), colours});
  }
  if (options.scale && std::ranges::count_if(c.panels, &std::optional<DiagramPanel>::has_value) > 1)
    throw InputError("--scale is that of one quantity: choose it by --panels");
  // A table's cells are full of numbers: there only the map of branches has lines.
  const bool maps = std::ranges::any_of(c.panels, [](const auto& panel) { return !panel; });
  if (model == Model::SBEH && (maps || !c.as_table))
    c.lines = diagram_lines(options.directory, options.branch);
  std::erase_if(c.lines, [&](const DiagramLine& line) { return !is_within(line, scan); });
  const auto add = [&](std::vector<LegendEntry> entries) {
    c.legend.insert(c.legend.end(), entries.begin(), entries.end());
  };
  if (maps) add(branch_legend(*c.branches));
  add(legend_of(c.lines));
  add(mark_legend(marked, c.as_table || std::size_t(maps) == c.panels.size()));
  return c;
}

void draw_heat_maps(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  const Contents contents = contents_of(scan, options);
  const double text = options.text_size();
  const auto bar_of = [&](const std::optional<DiagramPanel>& panel) {  // with its numbers
    return panel ? 1.7 * text + colour_bar_margin(canvas, panel->colours, false, text) : 0.0;
  };
  double bars = 0.0;
  for (const auto& panel : contents.panels) bars += bar_of(panel);
  const auto count = double(contents.panels.size());
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

  canvas.start(width, height, options.unit());
  double x = left;
  for (const auto& panel : contents.panels) {
    const Rect inside{x, below, inner_width, inner_height};
    if (panel)
      draw_heat_map(canvas, inside, panel->quantity, panel->colours, grid, text);
    else
      draw_branch_map(canvas, inside, *contents.branches, grid, text);
    if (!panel || !grid.as_table) draw_diagram_lines(canvas, inside, contents.lines, grid);
    const std::string& title = panel ? panel->quantity.title : contents.branches->quantity.title;
    require_room(inside, 0.7 * canvas.text_width(title, text) - gap, 0.0);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, title,
                {.size = fitted_size(canvas, {title}, inner_width + gap, text)});
    x += inner_width + bar_of(panel) + gap;
    grid.y.axis.title.clear();  // the next one has no numbers on its axis
    std::ranges::fill(grid.y.axis.labels, "");
  }
  draw_legend(canvas, contents.legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "diagram", options.output());
}

}  // namespace

void draw_diagram_picture(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  if ((scan.reduced_volumes().size() == 1) != (scan.lengths().size() == 1))
    draw_line_diagram(canvas, scan, options);
  else
    draw_heat_maps(canvas, scan, options);
}

}  // namespace sbeh::picture
