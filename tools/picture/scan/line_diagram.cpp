#include "tools/picture/chart/legend.h"
#include "tools/picture/chart/panels.h"
#include "tools/picture/scan/quantity.h"
#include "tools/picture/scan/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

const LineStyle sbeh_style{.colour = {0, 84, 159}, .width = 2.4};
const LineStyle ssh_style{.colour = red, .width = 2.4, .pattern = Pattern::dashed};

// One curve: a quantity along the parameter that varies.
struct Series {
  Quantity quantity;
  LineStyle style;
  std::string name{};

  double value(std::size_t i) const {
    return quantity.values.size() > 1 ? quantity.values[i][0] : quantity.values[0][i];
  }
  Mark mark(std::size_t i) const {
    return quantity.marks.size() > 1 ? quantity.marks[i][0] : quantity.marks[0][i];
  }
  bool is_saddle(std::size_t i) const {
    return quantity.saddles.size() > 1 ? quantity.saddles[i][0] : quantity.saddles[0][i];
  }
  int region(std::size_t i) const {
    return quantity.regions.size() > 1 ? quantity.regions[i][0] : quantity.regions[0][i];
  }
};

struct Panel {
  std::string title;
  std::vector<Series> series;
};

// Of the lowest of several branches, or of the one that was chosen.
std::vector<Panel> panels_of(const ScanGrid& scan, const Options& options) {
  const auto lowest_of = [&](Model model) {
    return options.branch.empty() ? lowest_branches(scan, model) : std::optional<BranchMap>();
  };
  const auto of_models =
      [&](Quantity (*quantity)(const ScanGrid&, Model, const std::optional<BranchMap>&)) {
        std::vector<Series> all;
        for (const Model model : {Model::SSH, Model::SBEH})
          if (scan.has(model))
            all.push_back({in_units(quantity(scan, model, lowest_of(model)), scan, options),
                           model == Model::SBEH ? sbeh_style : ssh_style, sbeh::name(model)});
        return all;
      };
  const bool ordered = scan.has(Model::SBEH), both = ordered && scan.has(Model::SSH);
  std::vector<std::string> names = options.panels;
  if (names.empty()) {
    if (!both)
      fmt::print("diagram: only one model, so the energy itself in place of the energy gap\n");
    names.emplace_back(both ? "gap" : "energy");
    if (ordered) names.emplace_back("order");
    names.emplace_back("curvature");
  }
  std::vector<Panel> panels;
  for (const std::string& name : names) {
    if (name == "gap" && both) {
      const Quantity gap = in_units(energy_gap(scan, lowest_of(Model::SBEH)), scan, options);
      panels.push_back({gap.title, {{gap, {.colour = black, .width = 2.4}}}});
    } else if (name == "energy") {
      panels.push_back({options.titled("energy U", studies::dimension::energy), of_models(energy)});
    } else if (name == "order" && ordered) {
      panels.push_back({"smallest order β",
                        {{smallest_order(scan, lowest_of(Model::SBEH)), sbeh_style, "SBEH"}}});
    } else if (name == "curvature") {
      panels.push_back({options.titled("largest |H|", studies::dimension::curvature),
                        of_models(largest_curvature)});
    } else {
      throw InputError(fmt::format("--panels {}: the scan has not what that needs", name));
    }
  }
  return panels;
}

// Some room on either side, so that no marker is cut.
Axis roomy_axis(double low, double high, double length, double spacing, const char* title) {
  const double room = high > low ? 0.06 * (high - low) : 0.05 * std::abs(high) + 1e-12;
  return exact_axis(low - room, high + room, length, spacing, title);
}

Axis value_axis(const Panel& panel, double length, double spacing) {
  Range range;
  for (const Series& series : panel.series) range.include(series.quantity.range());
  if (range.empty()) range = {0.0, 1.0};
  return roomy_axis(range.low, range.high, length, spacing, "");
}

struct MarkLook {
  Mark mark;
  Marker marker;
  const char* meaning;
};
// All but the first and the second stand at the lower edge: they have no value.
constexpr MarkLook mark_looks[] = {{Mark::none, Marker::full, nullptr},
                                   {Mark::limit, Marker::circle, "limit: the neck has closed"},
                                   {Mark::unresolved, Marker::plus, "unresolved"},
                                   {Mark::failed, Marker::cross, "failed"},
                                   {Mark::not_found, Marker::diamond, "a lower state must exist"},
                                   {Mark::singular, Marker::hollow, "no smooth shape"}};

// The curve is broken where the branch changes.
void draw_series(Chart& chart, const Series& series, const std::vector<double>& x, const Axis& y,
                 double marker) {
  Points line;
  Points saddles;
  std::map<Mark, Points> marked;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double value = series.value(i);
    const bool shown = std::isfinite(value);
    if (shown && series.is_saddle(i))
      saddles.push_back({x[i], value});
    else
      marked[series.mark(i)].push_back({x[i], shown ? value : y.low + 0.03 * (y.high - y.low)});
    if (!shown || (i > 0 && series.region(i) != series.region(i - 1)))
      chart.curve(std::exchange(line, {}), series.style);
    if (shown) line.push_back({x[i], value});
  }
  chart.curve(line, series.style);
  for (const MarkLook& look : mark_looks)
    chart.markers(marked[look.mark], look.marker, series.style.colour, marker);
  chart.markers(saddles, Marker::dotted, series.style.colour, marker);
}

std::vector<LegendEntry> legend_of(const std::vector<Panel>& panels) {
  std::vector<LegendEntry> entries;
  for (const Series& series : panels.back().series)
    if (!series.name.empty()) entries.push_back(line_entry(series.style, series.name));
  std::ranges::reverse(entries);
  const auto any = [&](auto&& has) {
    return std::ranges::any_of(panels, [&](const Panel& panel) {
      return std::ranges::any_of(panel.series, has, &Series::quantity);
    });
  };
  for (const MarkLook& look : mark_looks)
    if (look.meaning && any([&](const Quantity& quantity) { return quantity.has(look.mark); }))
      entries.push_back(marker_entry(look.marker, dark_grey, look.meaning));
  if (any(&Quantity::has_saddle))
    entries.push_back(marker_entry(Marker::dotted, dark_grey, "no minimum in 3D"));
  return entries;
}

}  // namespace

void draw_line_diagram(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  const bool over_volume = scan.lengths().size() == 1;
  const std::vector<double>& parameter = over_volume ? scan.reduced_volumes() : scan.lengths();
  const std::vector<Panel> panels = panels_of(scan, options);
  const auto legend = legend_of(panels);
  constexpr double least_letters = 12.0;
  const double text = options.text_size();
  const std::string title = over_volume ? "reduced volume Vᵣ" : scan.length_axis();
  PanelNeeds needs{.count = panels.size(),
                   .most_columns = panels.size(),
                   .usual_width = 533.0,
                   .least_width = std::max(canvas.text_width(title, text), least_letters * text),
                   .height_by_width = 0.85,
                   .left = 4.6 * text,
                   .right = 1.2 * text,
                   .below = below_axis(text),
                   .above = 2.4 * text,
                   .top = 2.2 * text};
  const double room = arranged(needs, options).width - 2.0 * text,
               legend_at = legend_height(canvas, legend, room, text);
  needs.bottom = 0.8 * text + legend_at;
  const PanelGrid grid = arranged(needs, options);
  const Axis x =
      roomy_axis(parameter.front(), parameter.back(), grid.inner_width, 3.5 * text, title.c_str());

  canvas.start(grid.width, grid.height, options.unit());
  canvas.text(0.5 * grid.width, grid.height - 1.4 * text,
              over_volume ? scan.length_title(0) : volume_title(scan.reduced_volumes()[0]),
              {.size = 1.15 * text});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Rect inside = grid.inside(i);
    const Axis y = value_axis(panels[i], inside.height, 3.0 * text);
    Chart chart(canvas, inside, text, x, y);
    for (const Series& series : panels[i].series)
      draw_series(chart, series, parameter, y, 0.6 * text);
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text, panels[i].title, {.size = text});
  }
  draw_legend(canvas, legend, {text, 0.4 * text, room, legend_at}, text);
  canvas.write(options.directory / "diagram", options.output());
}

}  // namespace sbeh::picture
