#include "studies/states/profile_file.h"
#include "tools/picture/chart/legend.h"
#include "tools/picture/scan/quantity.h"
#include "tools/picture/scan/scan.h"
#include "tools/picture/section/cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace sbeh::picture {
namespace {

constexpr std::size_t most_volumes = 6;
constexpr std::size_t most_lengths = 7;
constexpr double widest_cell = 330.0;  // pixels, when the size is ours to choose
constexpr double widest_picture = 1600.0;
constexpr double highest_picture = 1600.0;
constexpr double largest_share = 0.86;  // of the cell's width, for the widest cut

const LineStyle ssh_style{.colour = red, .width = 1.7, .pattern = Pattern::dashed};

// Which cuts of a scan are shown, and in which row and column: rows are reduced volumes, columns are values of L; a
// larger scan is thinned out evenly. With a single L the reduced volumes stand side by side. Below follow the
// overlays, all L of one reduced volume each. Reduced volumes and L are given by their index in the scan.
// A state that is not at rest at the point, because it is at a fold with another L, say, is not shown.
struct CutMatrix {
  struct Cell {
    std::size_t row, column, volume, length;
    std::string remark;  // about a point that is not simply stationary
  };

  CutMatrix(const ScanGrid& of, const Options& options);

  const ScanGrid& scan;
  std::vector<std::size_t> volumes;  // with an overlay for each
  std::vector<std::string> row_titles, column_titles;
  std::vector<Cell> cells;
  std::size_t overlay_rows = 0;  // of at most as many cells as there are columns
  std::map<const PointResult*, Cut> cuts;
  Extent extent;
  FieldRanges fields;                 // of the cuts that are coloured
  std::map<Model, BranchMap> lowest;  // where there are several branches
  std::string title;

  Model coloured() const { return scan.has(Model::SBEH) ? Model::SBEH : Model::SSH; }
  std::size_t rows() const { return row_titles.size(); }
  std::size_t columns() const { return column_titles.size(); }
  // nullptr if there is none.
  const Cut* cut(Model model, std::size_t volume, std::size_t length) const {
    const auto found = cuts.find(scan.find(model, volume, length));
    return found == cuts.end() ? nullptr : &found->second;
  }
  std::string remark(std::size_t volume, std::size_t length) const;
  std::vector<double> half_heights() const;
};

// So many that their titles are legible.
std::size_t columns_that_fit(const Options& options) {
  constexpr double cell = 5.0, margins = 14.0;  // in letters' sizes
  const double room = options.width(widest_picture) / options.text_size() - margins;
  return std::size_t(std::max(1.0, room / cell));
}

CutMatrix::CutMatrix(const ScanGrid& of, const Options& options) : scan(of) {
  const std::size_t most = columns_that_fit(options), all_volumes = scan.reduced_volumes().size(),
                    all_lengths = scan.lengths().size();
  const auto lengths = evenly_spread(all_lengths, std::min(most_lengths, most));
  const bool is_row = all_lengths == 1;
  volumes = evenly_spread(all_volumes, is_row ? std::min(most_volumes, most) : most_volumes);
  for (const std::size_t volume : volumes)
    for (std::size_t length = 0; length < scan.lengths().size(); ++length)
      for (const Model model : {Model::SBEH, Model::SSH}) {
        const PointResult* point = scan.find(model, volume, length);
        if (!point || point->status != PointStatus::stationary
            || !std::filesystem::exists(scan.profile(*point)))
          continue;
        const Cut& cut = cuts[point] = mirrored(studies::read_profile(scan.profile(*point)));
        extent.include(cut);
        if (model == coloured()) fields.include(cut);
      }
  if (options.branch.empty())
    for (const Model model : {Model::SBEH, Model::SSH})
      if (auto map = lowest_branches(scan, model)) lowest.emplace(model, *map);

  for (std::size_t v = 0; v < volumes.size(); ++v) {
    row_titles.push_back(volume_title(scan.reduced_volumes()[volumes[v]]));
    for (std::size_t l = 0; l < lengths.size(); ++l)
      cells.push_back(
          {is_row ? l : v, is_row ? v : l, volumes[v], lengths[l], remark(volumes[v], lengths[l])});
  }
  for (const std::size_t l : lengths) column_titles.push_back(scan.length_title(l));
  if (is_row)
    row_titles.swap(column_titles);
  else if (scan.has(Model::SBEH))
    overlay_rows = (volumes.size() + columns() - 1) / columns();
  title = lowest.empty() ? "Cross sections" : "Cross sections of the lowest smooth states found";
  if (volumes.size() < all_volumes || lengths.size() < all_lengths)
    title += fmt::format(": {} of {} reduced volumes, {} of {} values of L", volumes.size(),
                         all_volumes, lengths.size(), all_lengths);
}

std::string CutMatrix::remark(std::size_t volume, std::size_t length) const {
  std::vector<std::string> remarks;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    if (!scan.has(model)) continue;
    const char* name = sbeh::name(model);
    const PointResult* point = scan.find(model, volume, length);
    const auto map = lowest.find(model);
    if (!point)
      remarks.push_back(fmt::format("no {}", name));
    else if (point->status != PointStatus::stationary)
      remarks.push_back(fmt::format("{} {}", name, sbeh::name(point->status)));
    else if (!cut(model, volume, length))
      remarks.push_back(fmt::format("no {} profile", name));
    else if (map != lowest.end() && !map->second.is_lowest(volume, length))
      remarks.push_back(fmt::format("{} not the lowest", name));
  }
  return fmt::format("{}", fmt::join(remarks, ", "));
}

// Of the highest cut in each row, overlays included.
std::vector<double> CutMatrix::half_heights() const {
  std::vector<double> halves(rows() + overlay_rows, 0.2 * extent.half_height);
  const auto include = [&](std::size_t row, const Cut& cut) {
    halves[row] = std::max(halves[row], cut.half_height);
  };
  for (std::size_t v = 0; v < volumes.size(); ++v)
    for (std::size_t length = 0; length < scan.lengths().size(); ++length)
      for (const Model model : {Model::SBEH, Model::SSH})
        if (const Cut* shown = cut(model, volumes[v], length)) {
          include(rows() == 1 ? 0 : v, *shown);
          if (overlay_rows > 0) include(rows() + v / columns(), *shown);
        }
  return halves;
}

std::vector<LegendEntry> legend_of(const CutMatrix& matrix, const CutColours& colours,
                                   double text_size) {
  const ScanGrid& scan = matrix.scan;
  std::vector<LegendEntry> entries{coloured_line_entry(
      colours.map, 0.32 * text_size,
      fmt::format("{}, coloured by {}", name(matrix.coloured()), colours.title))};
  if (matrix.coloured() == Model::SBEH && scan.has(Model::SSH))
    entries.push_back(line_entry(ssh_style, "SSH"));
  if (matrix.overlay_rows > 0) {
    const std::size_t last = scan.lengths().size() - 1;
    entries.push_back(
        line_entry(style_by_length(0, last + 1), "all: SBEH from " + scan.length_title(0)));
    entries.push_back(line_entry(style_by_length(last, last + 1), "to " + scan.length_title(last)));
  }
  return entries;
}

// Where everything stands; all in pixels.
struct Layout {
  double text = 0.0;                 // size of letters
  std::vector<std::string> title{};  // in lines
  double left = 0.0;                 // margin of the row titles
  double right = 0.0;                // margin of the colour bar
  double legend = 0.0;
  double remarks = 0.0;  // room for a line below each cell of the matrix
  double cell_width = 0.0;
  double scale = 0.0;  // pixels per unit of length
  double width = 0.0;
  double height = 0.0;
  std::vector<Rect> rows;  // of the matrix, then the overlays

  Rect cell(double column, std::size_t row) const {
    return {left + column * cell_width, rows[row].y, cell_width, rows[row].height};
  }
};

constexpr double title_size = 1.15, title_line = 1.5;  // in letters' sizes

// Fills `at.rows` from the top, and the height if that is ours to choose.
void stack_rows(Layout& at, const CutMatrix& matrix, const Options& options) {
  at.rows.clear();
  const double gap = 1.3 * at.text;
  const double titles = (4.4 + title_line * (double(at.title.size()) - 1.0)) * at.text,
               overlay_title = 1.7 * at.text, separator = 0.6 * at.text;
  const double bottom = at.legend + 0.8 * at.text;
  const std::vector<double> halves = matrix.half_heights();
  const auto count = double(halves.size());
  const auto overlays = double(matrix.overlay_rows);
  const double fixed = titles + overlays * overlay_title + (overlays > 0.0 ? separator : 0.0)
                     + bottom + count * gap + double(matrix.rows()) * at.remarks;
  double sum = 0.0;
  for (const double half : halves) sum += 2.0 * half;
  const double room = options.height(options.unit() * highest_picture) - fixed;
  at.scale = std::min(largest_share * at.cell_width / (2.0 * matrix.extent.half_width),
                      std::max(room, 5.0 * at.text) / sum);
  at.height = options.height(fixed + sum * at.scale);
  const double spare = (at.height - fixed - sum * at.scale) / count;

  double y = at.height - titles;
  for (std::size_t row = 0; row < halves.size(); ++row) {
    if (row == matrix.rows()) y -= separator;
    if (row >= matrix.rows()) y -= overlay_title;
    const double height =
        2.0 * halves[row] * at.scale + gap + spare + (row < matrix.rows() ? at.remarks : 0.0);
    y -= height;
    at.rows.push_back({0.0, y, at.width, height});
  }
}

Layout layout_of(const Canvas& canvas, const CutMatrix& matrix, const Options& options,
                 const CutColours& colours, const std::vector<LegendEntry>& entries) {
  Layout at;
  at.text = options.text_size();
  double title = 0.0;
  for (std::size_t row = 0; row < matrix.rows(); ++row)
    title = std::max(title, canvas.text_width(matrix.row_titles[row], at.text));
  at.left = title + 1.8 * at.text;
  at.right = 3.6 * at.text + colour_bar_margin(canvas, colours.map, true, at.text);
  const double margins = at.left + at.right;
  const auto columns = double(matrix.columns());
  at.width = options.width(std::min(widest_picture, margins + columns * widest_cell));
  at.cell_width = (at.width - margins) / columns;
  if (std::ranges::any_of(matrix.cells, [](const auto& cell) { return !cell.remark.empty(); }))
    at.remarks = 0.7 * at.text;
  const auto stack = [&] {
    const double room = at.width - 2.0 * at.text;
    at.title = in_lines(canvas, matrix.title, room, title_size * at.text);
    at.legend = legend_height(canvas, entries, room, at.text);
    stack_rows(at, matrix, options);
  };
  stack();
  if (options.has_size()) return at;

  // High cuts leave narrower cells; title and legend want some width all the same.
  double needed = 2.0 * matrix.extent.half_width * at.scale / largest_share;
  for (const std::string& column_title : matrix.column_titles)
    needed = std::max(needed, canvas.text_width(column_title, at.text) + at.text);
  at.width = std::max(margins + columns * needed, 40.0 * at.text);
  at.cell_width = (at.width - margins) / columns;
  stack();
  return at;
}

void draw_cell(Canvas& canvas, const CutMatrix& matrix, const CutMatrix::Cell& of, const Layout& at,
               const CutColours& colours) {
  const Cut* coloured = matrix.cut(matrix.coloured(), of.volume, of.length);
  const Cut* ssh = matrix.cut(Model::SSH, of.volume, of.length);
  Rect cell = at.cell(double(of.column), of.row);
  cell.y += at.remarks;
  cell.height -= at.remarks;
  std::vector<CutLine> lines;
  if (coloured)
    lines.push_back({.cut = coloured, .colours = &colours, .style = {.width = coloured_width}});
  if (ssh && ssh != coloured) lines.push_back({.cut = ssh, .style = ssh_style});
  if (!lines.empty()) draw_cuts(canvas, cell, at.scale, lines);
  canvas.text(cell.centre_x(), cell.y, of.remark,
              {.size = fitted_size(canvas, {of.remark}, 0.94 * cell.width, 0.8 * at.text),
               .colour = dark_grey});
}

void draw_overlay(Canvas& canvas, const CutMatrix& matrix, std::size_t index, const Layout& at) {
  const std::size_t line = index / matrix.columns();
  const std::size_t in_line =
      std::min(matrix.volumes.size() - line * matrix.columns(), matrix.columns());
  const double column = double(index % matrix.columns()) + 0.5 * double(matrix.columns() - in_line);
  const Rect cell = at.cell(column, matrix.rows() + line);

  const std::size_t volume = matrix.volumes[index];
  const std::size_t count = matrix.scan.lengths().size();
  std::vector<CutLine> lines;
  const Cut* ssh = nullptr;
  for (std::size_t length = 0; length < count; ++length) {
    if (const Cut* cut = matrix.cut(Model::SBEH, volume, length))
      lines.push_back({.cut = cut, .style = style_by_length(length, count)});
    if (!ssh) ssh = matrix.cut(Model::SSH, volume, length);
  }
  if (ssh) lines.push_back({.cut = ssh, .style = ssh_style});
  if (!lines.empty()) draw_cuts(canvas, cell, at.scale, lines);
  const std::string title = volume_title(matrix.scan.reduced_volumes()[volume]);
  canvas.text(cell.centre_x(), cell.top() + 0.7 * at.text, title,
              {.size = fitted_size(canvas, {title}, 0.94 * cell.width, at.text)});
}

void draw_titles(Canvas& canvas, const CutMatrix& matrix, const Layout& at) {
  for (std::size_t line = 0; line < at.title.size(); ++line)
    canvas.text(0.5 * at.width, at.height - (1.4 + title_line * double(line)) * at.text,
                at.title[line], {.size = title_size * at.text});
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    canvas.text(at.left - 0.8 * at.text, at.rows[row].centre_y(), matrix.row_titles[row],
                {.size = at.text, .align = Align::right});
  }
  const double size =
      fitted_size(canvas, matrix.column_titles, at.cell_width - 0.6 * at.text, at.text);
  for (std::size_t column = 0; column < matrix.columns(); ++column)
    canvas.text(at.cell(double(column), 0).centre_x(), at.rows[0].top() + 0.8 * at.text,
                matrix.column_titles[column], {.size = size});
  if (matrix.overlay_rows > 0) {
    const double y = at.rows[matrix.rows() - 1].y - 0.1 * at.text;
    canvas.line({{at.text, y}, {at.left + double(matrix.columns()) * at.cell_width, y}},
                {.colour = light_grey, .width = 1.5});
    canvas.text(at.left - 0.8 * at.text, at.rows[matrix.rows()].centre_y(), "all L",
                {.size = at.text, .align = Align::right});
  }
}

}  // namespace

void draw_cuts_picture(Canvas& canvas, const ScanGrid& scan, const Options& options) {
  const CutMatrix matrix(scan, options);
  if (matrix.cuts.empty()) {
    fmt::print("no cuts: there is no profile of a stationary state in {}\n",
               (options.directory / "points").string());
    return;
  }
  const CutColours colours = colours_for(matrix.fields, options);
  const auto entries = legend_of(matrix, colours, options.text_size());
  const Layout at = layout_of(canvas, matrix, options, colours, entries);

  canvas.start(at.width, at.height, options.unit());
  draw_titles(canvas, matrix, at);
  for (const CutMatrix::Cell& cell : matrix.cells) draw_cell(canvas, matrix, cell, at, colours);
  if (matrix.overlay_rows > 0) {
    for (std::size_t i = 0; i < matrix.volumes.size(); ++i) draw_overlay(canvas, matrix, i, at);
  }
  draw_short_bar(canvas, at.width - at.right + 1.2 * at.text,
                 {at.rows.back().y, at.rows.front().top()}, colours.map, colours.title, at.text);
  draw_legend(canvas, entries, {at.text, 0.4 * at.text, at.width - 2.0 * at.text, at.legend},
              at.text);
  canvas.write(options.directory / "cuts", options.output());
}

}  // namespace sbeh::picture
