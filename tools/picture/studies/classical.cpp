#include "axisym/shooting/seifert_shooting.h"
#include "studies/seifert/seifert.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/section/cut.h"
#include "tools/picture/studies/studies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace sbeh::picture {
namespace {

using axisym::Branch;

struct BranchCurve {
  Branch branch;
  LineStyle style;
};
const std::vector<BranchCurve> branch_curves{
    {Branch::oblate, {.colour = {0, 84, 159}, .width = 2.6}},
    {Branch::prolate, {.colour = {213, 94, 0}, .width = 2.6, .pattern = Pattern::dashed}},
    {Branch::stomatocyte, {.colour = {0, 158, 115}, .width = 2.6, .pattern = Pattern::dash_dotted}},
};

// Points (V_r, F/8πκ) by witness and branch, V_r ascending; witnesses in the order of the file.
struct Branches {
  std::vector<std::string> witnesses;
  std::map<std::pair<std::string, Branch>, Points> points;
  Points saddles;  // those with directions of falling energy among shapes without an axis
};

Branches read_branches(const std::filesystem::path& file) {
  Branches all;
  for (const auto& [witness, shape, modes] : studies::read_rows(studies::branch_columns(), file)) {
    if (std::ranges::find(all.witnesses, witness) == all.witnesses.end())
      all.witnesses.push_back(witness);
    all.points[{witness, shape.branch}].push_back({shape.reduced_volume, shape.energy});
    if (modes.negative_directions.value_or(0) > 0)
      all.saddles.push_back({shape.reduced_volume, shape.energy});
  }
  for (auto& [key, points] : all.points) std::ranges::sort(points);
  if (all.points.empty())
    throw InputError(file.string() + " has no rows; run `sbeh seifert` again.");
  return all;
}

// What the special points are called in a picture, and whose shapes stand beside the name.
struct Meaning {
  const char *name, *text;
  std::vector<Branch> shapes;
};
const std::vector<Meaning> meanings{
    {"prolate_oblate", "equal energy", {Branch::prolate, Branch::oblate}},
    {"oblate_stomatocyte", "equal energy", {Branch::oblate, Branch::stomatocyte}},
    {"stomatocyte_fold", "fold", {Branch::stomatocyte}},
    {"oblate_symmetry_loss", "loses its symmetry", {Branch::oblate}},
    {"oblate_self_contact", "poles touch", {Branch::oblate}}};

struct Special {
  std::string letter, text;
  std::array<double, 2> at;
  std::vector<Cut> shapes{};
};

// Shot anew: the tables have none. A fold is no place to shoot at, so next to it.
std::optional<Cut> shape_at(Branch branch, double reduced_volume) {
  constexpr double aside = 1e-3;
  for (const double volume : {reduced_volume, reduced_volume - aside}) {
    try {
      const axisym::ClassicalShape shape =
          axisym::shoot_branch(branch, std::vector<double>{volume}).front();
      Eigen::Matrix2Xd profile = shape.profile;
      if (branch == Branch::stomatocyte && profile(1, 0) > 0) profile.row(1) *= -1;
      return mirrored({profile, axisym::Field::Zero(profile.cols())});
    } catch (const std::exception&) {  // not on the branch, or too ill conditioned
    }
  }
  return {};
}

// By ascending reduced volume: a, b, c …
std::vector<Special> special_points(const std::filesystem::path& file) {
  std::vector<studies::PointRow> rows = studies::read_rows(studies::point_columns(), file);
  std::ranges::sort(rows, {}, [](const auto& row) { return row.point.reduced_volume; });
  std::vector<Special> points;
  for (const studies::PointRow& row : rows) {
    Special point{std::string(1, char('a' + points.size())),
                  row.name,
                  {row.point.reduced_volume, row.point.energy}};
    const auto meaning =
        std::ranges::find_if(meanings, [&](const Meaning& m) { return row.name == m.name; });
    if (meaning != meanings.end()) {
      point.text = meaning->text;
      for (const Branch branch : meaning->shapes)
        if (auto cut = shape_at(branch, row.point.reduced_volume))
          point.shapes.push_back(std::move(*cut));
    }
    points.push_back(std::move(point));
  }
  return points;
}

// Where m ≥ 1 changes its sign: that of m = 0 is a special point already.
std::vector<Special> limits_of_stability(const std::filesystem::path& file) {
  std::vector<Special> limits;
  if (!std::filesystem::exists(file)) return limits;
  for (const auto& row : studies::read_rows(studies::classical_threshold_columns(), file))
    if (row.m > 0 && std::isfinite(row.point.error))
      limits.push_back(
          {"m = " + std::to_string(row.m), "", {row.point.reduced_volume, row.point.energy}});
  return limits;
}

constexpr double mark = 0.5;  // size of a special point, in text sizes

// What points are called whose marks lie on each other: "a, b".
struct Label {
  std::string text;
  double width;
  Points points;  // in pixels

  std::array<double, 2> middle() const {
    std::array<double, 2> sum{};
    for (const auto& [x, y] : points) sum = {sum[0] + x, sum[1] + y};
    return {sum[0] / double(points.size()), sum[1] / double(points.size())};
  }
};

// Its place, as far as can be from `occupied`, all in pixels.
std::array<double, 2> free_place(const Label& label, const Points& occupied, double distance) {
  const std::array<double, 2> point = label.middle();
  const double half = 0.5 * label.width;
  std::array<double, 2> best = point;
  double farthest = -1.0;
  constexpr int directions = 16;
  for (int k = 0; k < directions; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / directions;
    const std::array<double, 2> place{point[0] + (distance + half) * std::cos(angle),
                                      point[1] + distance * std::sin(angle)};
    double nearest = 1e300;
    for (const auto& [x, y] : occupied)
      nearest =
          std::min(nearest, std::hypot(std::max(std::abs(place[0] - x) - half, 0.0), place[1] - y));
    if (nearest > farthest) {
      farthest = nearest;
      best = place;
    }
  }
  return best;
}

// Letters, or what else they are called, beside the points.
void draw_letters(Canvas& canvas, const std::vector<Special>& special, const Branches& all,
                  const Rect& inside, const Axis& x, const Axis& y, double text) {
  const auto pixel = [&](const std::array<double, 2>& at) {
    return std::array{inside.x + x.share(at[0]) * inside.width,
                      inside.y + y.share(at[1]) * inside.height};
  };
  Points occupied;
  for (const auto& [key, points] : all.points)
    for (std::size_t i = 1; i < points.size(); ++i)
      for (const double share : {0.0, 0.25, 0.5, 0.75})
        occupied.push_back(pixel({points[i - 1][0] + share * (points[i][0] - points[i - 1][0]),
                                  points[i - 1][1] + share * (points[i][1] - points[i - 1][1])}));
  std::vector<Label> labels;
  for (const Special& point : special) {
    const auto at = pixel(point.at);
    occupied.push_back(at);
    const bool together = !labels.empty()
                       && std::hypot(at[0] - labels.back().points.back()[0],
                                     at[1] - labels.back().points.back()[1])
                              < mark * text;
    if (!together) labels.push_back({});
    Label& label = labels.back();
    label.text += (together ? ", " : "") + point.letter;
    label.points.push_back(at);
    label.width = canvas.text_width(label.text, text);
  }
  for (const Label& label : labels) {
    const auto [at_x, at_y] = free_place(label, occupied, 1.1 * text);
    canvas.text(at_x, at_y, label.text, {.size = text});
    for (const double share : {-0.5, 0.0, 0.5})
      occupied.push_back({at_x + share * label.width, at_y});
  }
}

constexpr double key_line = 2.3;  // in text sizes

// With the branches below it.
double least_height(const std::vector<Special>& special, double text) {
  return (key_line * double(special.size()) + 5.0) * text;
}

// Letters, shapes and names in the corner above the branches, which is empty.
void draw_key(Canvas& canvas, const std::vector<Special>& special, const Rect& inside,
              double text) {
  constexpr double line = key_line, shape = 2.2, letters = 0.85;  // in text sizes
  const double scale = 0.6 * text;  // pixels per radius of the sphere of equal area
  double width = 0.0;
  for (const Special& point : special)
    width = std::max(width, canvas.text_width(point.text, letters * text));
  const double left = inside.right() - width - (1.4 + 2 * shape) * text;
  require_room({0.0, 0.0, inside.right() - left, inside.height}, 0.0, least_height(special, text));
  double y = inside.top() - 0.5 * line * text;
  for (const Special& point : special) {
    canvas.text(left, y, point.letter, {.size = text});
    for (std::size_t k = 0; k < point.shapes.size(); ++k)
      draw_cuts(canvas,
                {left + (0.6 + shape * double(k)) * text, y - 0.65 * line * text, shape * text,
                 1.3 * line * text},
                scale, {{.cut = &point.shapes[k], .style = {.colour = dark_grey, .width = 1.6}}});
    canvas.text(left + (0.9 + 2 * shape) * text, y, point.text,
                {.size = letters * text, .align = Align::left});
    y -= line * text;
  }
}

}  // namespace

void draw_classical_diagram(Canvas& canvas, const Options& options) {
  const Branches all = read_branches(options.directory / "branches.csv");
  const std::vector<Special> special = special_points(options.directory / "points.csv");
  const double text = options.text_size();
  std::vector<LegendEntry> legend;
  legend.reserve(branch_curves.size() + 2);
  for (const BranchCurve& branch : branch_curves)
    legend.push_back(line_entry(branch.style, sbeh::name(branch.branch)));
  std::string others;
  for (std::size_t i = 1; i < all.witnesses.size(); ++i)
    others += (i > 1 ? ", " : "") + all.witnesses[i];
  if (!others.empty()) legend.push_back(marker_entry(Marker::hollow, dark_grey, others));
  legend.push_back(marker_entry(Marker::full, black, "special points"));
  if (!all.saddles.empty())
    legend.push_back(marker_entry(Marker::cross, dark_grey, "no minimum in 3D"));
  const std::vector<Special> limits =
      limits_of_stability(options.directory / "stability_lines.csv");
  if (!limits.empty())
    legend.push_back(marker_entry(Marker::diamond, black, "limit of stability in 3D"));

  const double width = options.width(1100.0);
  const double legend_at = legend_height(canvas, legend, width - 2.0 * text, text);
  const double below = below_axis(text) + 0.8 * text + legend_at;
  const double height = options.height(
      std::max(0.55 * width + 10.0 * text, below + 1.6 * text + least_height(special, text)));
  const Rect inside{5.2 * text, below, width - 6.8 * text, height - below - 1.6 * text};
  Range volumes, energies;
  for (const auto& [key, points] : all.points)
    for (const auto& [volume, energy] : points) {
      volumes.include(volume);
      energies.include(energy);
    }
  const Axis x =
      linear_axis(volumes.low, volumes.high, inside.width, 4.0 * text, "reduced volume Vᵣ");
  const Axis y = linear_axis(energies.low, energies.high, inside.height, 3.2 * text, "F / 8πκ");

  canvas.start(width, height, options.unit());
  Chart chart(canvas, inside, text, x, y);
  for (const BranchCurve& branch : branch_curves)
    for (std::size_t i = 0; i < all.witnesses.size(); ++i) {
      const auto at = all.points.find({all.witnesses[i], branch.branch});
      if (at == all.points.end()) continue;
      if (i == 0)
        chart.curve(at->second, branch.style);
      else
        chart.markers(at->second, Marker::hollow, branch.style.colour, 0.45 * text);
    }
  Points marked;
  marked.reserve(special.size());
  for (const Special& point : special) marked.push_back(point.at);
  chart.markers(marked, Marker::full, black, mark * text);
  chart.markers(all.saddles, Marker::cross, dark_grey, 0.7 * text);
  std::vector<Special> lettered = special;
  for (const Special& limit : limits) {
    chart.markers({limit.at}, Marker::diamond, black, 0.7 * text);
    lettered.push_back(limit);
  }
  draw_letters(canvas, lettered, all, inside, x, y, text);
  draw_key(canvas, special, inside, text);
  draw_legend(canvas, legend, {text, 0.4 * text, width - 2.0 * text, legend_at}, text);
  canvas.write(options.directory / "branches", options.output());
}

}  // namespace sbeh::picture
