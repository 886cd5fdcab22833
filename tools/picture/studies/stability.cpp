#include "studies/stability/stability.h"

#include "tools/picture/chart/legend.h"
#include "tools/picture/chart/panels.h"
#include "tools/picture/studies/studies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace sbeh::picture {
namespace {

using studies::Verdict;

const char* const volume_axis = "reduced volume Vᵣ";

struct Look {
  Verdict verdict;
  const char* meaning;
  Marker marker;
  Colour colour;
};
constexpr std::array<Look, 4> looks{
    Look{Verdict::stays, "stays: the perturbation decays", Marker::full, {0, 84, 159}},
    Look{Verdict::leaves, "leaves: it grows", Marker::hollow, {214, 28, 28}},
    Look{Verdict::undecided, "undecided", Marker::diamond, {90, 90, 90}},
    Look{Verdict::failed, "failed", Marker::cross, {90, 90, 90}},
};

using studies::StabilityKey;
using Run = studies::StabilityResult;
using Panels = std::map<std::tuple<model::Model, axisym::Branch, int, int>,  // and l, m
                        std::vector<Run>>;

// Rates over κ(2/3), or in units of their own: `reduced_rate` and `mode_rate` are then these.
Panels read_panels(const std::filesystem::path& file, const model::Material& material,
                   const Options& options) {
  Panels panels;
  for (Run& run : studies::read_rows(studies::stability_columns(), file)) {
    const double kappa = material.with_L1(run.key.L).kappa(model::full_order),
                 unit = options.units ? options.factor(studies::dimension::rate, run.key.L)
                                      : 1 / kappa;
    run.reduced_rate *= kappa * unit;
    run.mode_rate *= unit;
    panels[{run.key.model, run.key.branch, run.key.l, run.key.m}].push_back(run);
  }
  if (panels.empty()) throw InputError(file.string() + ": has no rows yet.");
  return panels;
}

std::vector<double> values_of(const std::vector<Run>& runs, double StabilityKey::*member) {
  std::set<double> all;
  for (const Run& run : runs) all.insert(run.key.*member);
  return {all.begin(), all.end()};
}

// Of the rate shown; NaN where not known.
double error_of(const Run& run) {
  return run.growth ? run.growth->error * run.reduced_rate / run.growth->rate : studies::not_known;
}

std::string goal_of(const Run& run) {
  return run.verdict == Verdict::leaves && !run.end_state.empty() ? "to " + run.end_state : "";
}

const Look& look_of(const Run& run) {
  const auto* at = std::ranges::find(looks, run.verdict, &Look::verdict);
  return at == looks.end() ? looks.back() : *at;
}

std::string signed_text(double value) {
  const double size = std::abs(value);
  return (value < 0.0 ? "−" : "+")
       + (size < 10.0 ? fmt::format("{:.3f}", size) : fmt::format("{:.4g}", size));
}

bool is_known_by_modes_alone(const Run& run) { return !run.growth && std::isfinite(run.mode_rate); }

std::string rate_text(const Run& run) {
  if (run.growth) return signed_text(run.reduced_rate);
  if (!is_known_by_modes_alone(run)) return "no rate";
  return fmt::format("({})", signed_text(run.mode_rate));
}

// A marker per run with its rate below.
void draw_map(Canvas& canvas, const Rect& inside, const std::vector<Run>& runs, double text) {
  const GridAxis x = table_axis(values_of(runs, &StabilityKey::reduced_volume), volume_axis),
                 y = table_axis(values_of(runs, &StabilityKey::L), "elastic constant L");
  Chart chart(canvas, inside, text, x.axis, y.axis);
  for (const Run& run : runs) {
    const double across = share_of(x, run.key.reduced_volume), up = share_of(y, run.key.L);
    const Look& look = look_of(run);
    chart.markers({{x.axis.low + across * (x.axis.high - x.axis.low),
                    y.axis.low + up * (y.axis.high - y.axis.low)}},
                  look.marker, look.colour, 0.9 * text);
    const double px = inside.x + across * inside.width, py = inside.y + up * inside.height;
    canvas.text(px, py - 1.1 * text, rate_text(run), {.size = 0.8 * text, .colour = look.colour});
    canvas.text(px, py + 1.1 * text, goal_of(run), {.size = 0.75 * text, .colour = look.colour});
  }
}

// Rates over V_r, with their uncertainty and the zero line.
void draw_rates(Canvas& canvas, const Rect& inside, const std::vector<Run>& runs,
                const std::string& title, double text) {
  Range rates{0.0, 0.0};
  for (const Run& run : runs)
    if (std::isfinite(run.reduced_rate)) {
      const double error = std::isfinite(error_of(run)) ? error_of(run) : 0.0;
      rates.include({run.reduced_rate - error, run.reduced_rate + error});
    }
  const double room = 0.12 * rates.width() + 1e-6;
  const auto volumes = values_of(runs, &StabilityKey::reduced_volume);
  const double side = 0.1 * std::max(volumes.back() - volumes.front(), 0.05);
  const double left = volumes.front() - side, right = volumes.back() + side;
  const Axis x = exact_axis(left, right, inside.width, 4.0 * text, volume_axis);
  const bool any = rates.width() > 0.0;
  const Axis y =
      any ? exact_axis(rates.low - room, rates.high + room, inside.height, 3.0 * text, title)
          : Axis{.low = -1.0, .high = 1.0, .title = title};
  Chart chart(canvas, inside, text, x, y);
  chart.curve({{left, 0.0}, {right, 0.0}},
              {.colour = dark_grey, .width = 1.2, .pattern = Pattern::dashed});
  Points line;
  const auto end_line = [&] {
    chart.curve(std::exchange(line, {}), {.colour = {170, 170, 170}, .width = 1.6});
  };
  for (const Run& run : runs) {
    if (std::isfinite(run.reduced_rate))
      line.push_back({run.key.reduced_volume, run.reduced_rate});
    else
      end_line();
  }
  end_line();
  for (const Run& run : runs) {
    const Look& look = look_of(run);
    const double volume = run.key.reduced_volume, error = error_of(run);
    if (!std::isfinite(run.reduced_rate)) {  // it has no place on the axis of rates
      const std::string verdict = fmt::format("{}, no rate", name(run.verdict));
      const double size = 0.75 * text;
      canvas.text(inside.x + x.share(volume) * inside.width,
                  inside.y + 0.5 * canvas.text_width(verdict, size) + 0.4 * text, verdict,
                  {.size = size, .colour = look.colour, .upward = true});
      continue;
    }
    const double rate = run.reduced_rate;
    if (std::isfinite(error))
      chart.curve({{volume, rate - error}, {volume, rate + error}},
                  {.colour = look.colour, .width = 1.6});
    chart.markers({{volume, rate}}, look.marker, look.colour, 0.8 * text);
    canvas.text(inside.x + x.share(volume) * inside.width,
                inside.y + y.share(rate) * inside.height + 1.1 * text, goal_of(run),
                {.size = 0.75 * text, .colour = look.colour});
  }
}

std::vector<LegendEntry> legend_of(const Panels& panels) {
  std::vector<LegendEntry> entries;
  for (const Look& look : looks) {
    const bool used = std::ranges::any_of(panels, [&](const auto& panel) {
      return std::ranges::any_of(
          panel.second, [&](const Run& run) { return look_of(run).verdict == look.verdict; });
    });
    if (used) entries.push_back(marker_entry(look.marker, look.colour, look.meaning));
  }
  const auto in_parentheses = [](const auto& panel) {
    return values_of(panel.second, &StabilityKey::L).size() > 1
        && std::ranges::any_of(panel.second, is_known_by_modes_alone);
  };
  if (std::ranges::any_of(panels, in_parentheses))
    entries.push_back({[](Canvas& canvas, const Rect& r) {
                         canvas.text(r.centre_x(), r.centre_y(), "(…)", {.size = 0.8 * r.height});
                       },
                       "by the modes alone"});
  return entries;
}

constexpr double least_picture = 820.0;

// Rates stand side by side in a map.
double least_width(const Canvas& canvas, const Panels& panels, double text) {
  double letters = 0.0;
  for (const auto& [key, runs] : panels)
    if (values_of(runs, &StabilityKey::L).size() > 1)
      letters =
          std::max(letters, 3.0 * double(values_of(runs, &StabilityKey::reduced_volume).size()));
  return std::max(letters * text, canvas.text_width(volume_axis, text));
}

}  // namespace

void draw_stability(Canvas& canvas, const Options& options) {
  const Panels panels =
      read_panels(options.directory / "stability.csv",
                  studies::read_stability(options.directory / "run.toml").material, options);
  const std::string rate =
      options.units ? options.titled("rate", studies::dimension::rate) : "rate/κ";
  const double text = options.text_size();
  const auto legend = legend_of(panels);
  const double room = options.width(least_picture) - 2.0 * text,
               legend_at = legend_height(canvas, legend, room, text);
  const PanelGrid grid = arranged({.count = panels.size(),
                                   .most_columns = 3,
                                   .usual_width = 560.0,
                                   .least_picture = least_picture,
                                   .least_width = least_width(canvas, panels, text),
                                   .left = 5.8 * text,
                                   .right = 1.2 * text,
                                   .below = below_axis(text),
                                   .above = 2.8 * text,
                                   .bottom = 1.6 * text + legend_at,
                                   .top = 2.2 * text},
                                  options);
  canvas.start(grid.width, grid.height, options.unit());
  canvas.text(0.5 * grid.width, grid.height - 1.2 * text,
              options.units
                  ? options.titled("Rates in 3D", studies::dimension::rate) + ", marks by the modes"
                  : "Rates in 3D over κ(2/3), marks by the modes",
              {.size = 1.1 * text});
  std::size_t i = 0;
  for (const auto& [key, runs] : panels) {
    const Rect inside = grid.inside(i++);
    const auto& [model, branch, l, m] = key;
    canvas.text(inside.centre_x(), inside.top() + 1.2 * text,
                fmt::format("{} {}, l = {}, m = {}", name(model), name(branch), l, m),
                {.size = text});
    if (values_of(runs, &StabilityKey::L).size() > 1)
      draw_map(canvas, inside, runs, text);
    else
      draw_rates(canvas, inside, runs, rate, text);
  }
  draw_legend(canvas, legend, {0.5 * (grid.width - room), 0.6 * text, room, legend_at}, text);
  canvas.write(options.directory / "stability", options.output());
}

}  // namespace sbeh::picture
