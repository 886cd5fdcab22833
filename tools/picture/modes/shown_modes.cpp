#include "tools/picture/modes/shown_modes.h"

#include "axisym/curve.h"
#include "tools/picture/chart/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_columns = 6;
constexpr double line = 1.25, least_cell = 10.0;  // of the text

std::string signed_text(const char* letter, double value) {
  return fmt::format("{} = {}", letter, with_minus(fmt::format("{:.3g}", value)));
}

ShownUnit shown_in(const Options& options, const studies::Dimension& dimension) {
  return {options.factor(dimension), options.unit_after(dimension)};
}

std::filesystem::path file_of(const Options& options, const studies::ModeKey& key) {
  return options.directory / "modes" / (stem(key) + ".vtu");
}

}  // namespace

double amplitude_of(const studies::StateMode& mode) {
  const axisym::Nodes n = axisym::node_normals(mode.state.X);
  double amplitude = shown_amplitude;
  for (Eigen::Index i = 0; i < mode.u.size(); ++i) {
    const double r = mode.state.X(0, i), inward = std::abs(mode.u[i] * n(0, i));
    if (r > 1e-6 && inward > 0.0) amplitude = std::min(amplitude, 0.5 * r / inward);
  }
  return amplitude;
}

ShownModes::ShownModes(const Options& options)
    : colours(chosen_colours(options, Palette::cividis, {-1.0, 1.0})),
      energy(shown_in(options, studies::dimension::energy)),
      rate(shown_in(options, studies::dimension::rate)) {
  const std::filesystem::path table = options.directory / "modes.csv";
  const double room = options.has_size() ? options.width(0.0) - 9.0 * options.text_size() : 1e300;
  std::set<int> ms;
  std::set<axisym::Parity> parities;
  std::vector<studies::ModeKey> keys;
  for (const studies::ModeRow& row : studies::read_rows(studies::mode_columns(), table)) {
    if (row.key.number != 1 || !exists(file_of(options, row.key))) continue;
    keys.push_back(row.key);
    ms.insert(row.key.m);
    parities.insert(row.key.parity);
  }
  if (keys.empty()) throw InputError(table.string() + ": has no rows with a file in modes/.");
  columns = std::clamp<std::size_t>(std::size_t(room / (least_cell * options.text_size())), 1,
                                    std::min(most_columns, ms.size()));
  rows = parities.size() * ((ms.size() + columns - 1) / columns);
  for (const studies::ModeKey& key : keys) {
    const auto at = std::size_t(std::distance(ms.begin(), ms.find(key.m)));
    const auto parity = std::size_t(std::distance(parities.begin(), parities.find(key.parity)));
    modes.push_back({studies::read_mode(file_of(options, key)), at % columns,
                     at / columns * parities.size() + parity});
  }
  by_order = has_free_order(modes.front().mode.model) && options.field != Field::curvature;
}

std::string ShownModes::title() const {
  return by_order ? "change of the order, over its largest" : "displacement, over its largest";
}

std::vector<std::string> words_of(const ShownModes& all, const studies::StateMode& mode) {
  const studies::ModeKey& key = mode.key;
  std::string title = fmt::format("m = {}", key.m);
  if (key.parity != axisym::Parity::none) title += fmt::format(", {}", name(key.parity));
  if (mode.eigenvalue < 0.0) title += ", unstable";
  std::vector<std::string> words{
      title, signed_text("λ", all.energy.factor * mode.eigenvalue) + all.energy.unit};
  if (std::isfinite(mode.rate))
    words.back() += ",  " + signed_text("σ", all.rate.factor * mode.rate) + all.rate.unit;
  if (all.by_order)
    words.push_back(fmt::format("max |b| = {:.2g} max |u|", mode.b.cwiseAbs().maxCoeff()));
  return words;
}

double height_of_words(const ShownModes& all, double text) {
  return ((all.by_order ? 3.0 : 2.0) * line + 0.4) * text;
}

void draw_words(Canvas& canvas, const Rect& cell, const ShownModes& all,
                const studies::StateMode& mode, double text) {
  const std::vector<std::string> words = words_of(all, mode);
  const double size = fitted_size(canvas, words, 0.96 * cell.width, 0.9 * text);
  for (std::size_t i = 0; i < words.size(); ++i)
    canvas.text(cell.centre_x(), cell.top() - (double(i) + 0.5) * line * text, words[i],
                {.size = i == 0 ? std::min(text, size / 0.9) : size,
                 .colour = i == 1 && mode.eigenvalue < 0.0 ? red
                         : i == 0                          ? black
                                                           : dark_grey});
}

}  // namespace sbeh::picture
