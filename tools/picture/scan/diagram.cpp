#include "tools/picture/chart/panels.h"
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

  const std::string& title(std::size_t panel) const {
    return panels[panel] ? panels[panel]->quantity.title : branches->quantity.title;
  }
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
  if (options.branch.empty()) c.branches = lowest_branches(scan, model);
  std::vector<Quantity> marked;
  for (const std::string& panel : panels_of(scan, options, c.branches)) {
    if (panel == "lowest") {
      if (!c.branches) throw InputError("--panels lowest: the scan has one branch alone");
      c.panels.emplace_back();
      marked.push_back(c.branches->quantity);
      continue;
    }
    Quantity quantity = in_units(quantity_of(panel, scan, model, c.branches), scan, options);
    marked.push_back(quantity);
    const ColourMap colours = chosen_colours(options, quantity.palette, quantity.range());
    c.panels.emplace_back(DiagramPanel{std::move(quantity), colours});
  }
  if (options.scale && std::ranges::count_if(c.panels, &std::optional<DiagramPanel>::has_value) > 1)
    throw InputError("--scale is that of one quantity: choose it by --panels");
  // A table's cells are full of numbers: there only the map of branches has lines.
  const bool maps = std::ranges::any_of(c.panels, [](const auto& panel) { return !panel; });
  if (model == Model::SBEH && (maps || !c.as_table)) c.lines = diagram_lines(scan, options.branch);
  if (maps || !c.as_table)
    for (DiagramLine& line : stability_lines(scan, model, options.branch))
      c.lines.push_back(std::move(line));
  std::erase_if(c.lines, [&](const DiagramLine& line) { return !is_within(line, scan); });
  const auto add = [&](std::vector<LegendEntry> entries) {
    c.legend.insert(c.legend.end(), entries.begin(), entries.end());
  };
  if (maps) add(branch_legend(*c.branches));
  add(legend_of(c.lines));
  add(mark_legend(marked, c.as_table || std::size_t(maps) == c.panels.size()));
  return c;
}

const char* const volume_axis = "reduced volume Vᵣ";

// The legend stands below all panels, the colour bar of each to its right.
PanelGrid panels_for(const Canvas& canvas, const ScanGrid& scan, const Contents& contents,
                     const Options& options) {
  constexpr double letters_in_a_cell = 1.6;
  const double text = options.text_size(), gap = 1.8 * text;
  PanelNeeds needs{.count = contents.panels.size(),
                   .most_columns = contents.panels.size(),
                   .usual_width = 533.0,
                   .least_width = canvas.text_width(volume_axis, text),
                   .height_by_width = 1.15,
                   .side = 5.2 * text,
                   .right = gap,
                   .below = below_axis(text),
                   .above = 2.6 * text};
  if (contents.as_table)
    needs.least_width = std::max(needs.least_width,
                                 letters_in_a_cell * text * double(scan.reduced_volumes().size()));
  double bar = 0.0;  // with its numbers
  for (std::size_t i = 0; i < contents.panels.size(); ++i) {
    needs.least_width =
        std::max(needs.least_width, 0.75 * canvas.text_width(contents.title(i), text) - gap);
    if (const auto& panel = contents.panels[i])
      bar = std::max(bar, 1.7 * text + colour_bar_margin(canvas, panel->colours, false, text));
  }
  needs.right += bar;
  const double width = arranged(needs, options).width;
  if (!contents.legend.empty())
    needs.bottom = 0.8 * text + legend_height(canvas, contents.legend, width - 2.0 * text, text);
  return arranged(needs, options);
}

void draw_heat_maps(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  const Contents contents = contents_of(scan, options);
  const double text = options.text_size();
  const PanelGrid panels = panels_for(canvas, scan, contents, options);
  HeatMapGrid grid{.as_table = contents.as_table};
  grid.x = grid.as_table
             ? table_axis(scan.reduced_volumes(), volume_axis)
             : distance_axis(scan.reduced_volumes(), volume_axis, panels.inner_width, 3.2 * text);
  grid.y = grid.as_table
             ? table_axis(scan.lengths(), scan.length_axis())
             : distance_axis(scan.lengths(), scan.length_axis(), panels.inner_height, 3.0 * text);
  HeatMapGrid inner = grid;  // without numbers on the axis that the first in the row has
  inner.y.axis.title.clear();
  std::ranges::fill(inner.y.axis.labels, "");

  canvas.start(panels.width, panels.height, options.unit());
  for (std::size_t i = 0; i < contents.panels.size(); ++i) {
    const auto& panel = contents.panels[i];
    const Rect inside = panels.inside(i);
    const HeatMapGrid& shown = panels.begins_row(i) ? grid : inner;
    if (panel)
      draw_heat_map(canvas, inside, panel->quantity, panel->colours, shown, text);
    else
      draw_branch_map(canvas, inside, *contents.branches, shown, text);
    if (!panel || !grid.as_table) draw_diagram_lines(canvas, inside, contents.lines, shown, text);
    const std::string& title = contents.title(i);
    require_room(inside, 0.7 * canvas.text_width(title, text) - 1.8 * text, 0.0);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, title,
                {.size = fitted_size(canvas, {title}, inside.width + 1.8 * text, text)});
  }
  draw_legend(canvas, contents.legend,
              {text, 0.4 * text, panels.width - 2.0 * text, panels.needs.bottom - 0.8 * text},
              text);
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
