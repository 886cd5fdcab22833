// What the command line says.
#pragma once

#include "studies/io/errors.h"
#include "studies/report/result_units.h"
#include "tools/picture/canvas/canvas.h"
#include "tools/picture/canvas/palette.h"
#include "tools/picture/canvas/view.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::picture {

/// What the user gave is of no use; one sentence.
using studies::InputError;

struct Size {
  int width = 0;
  int height = 0;
};

/// What a surface or a cut is coloured by.
enum class Field { order, curvature };
constexpr auto names(Field) { return std::array{"order", "curvature"}; }
constexpr Palette palette_of(Field field) {
  return field == Field::order ? order_palette : curvature_palette;
}
constexpr studies::Dimension dimension_of(Field field) {
  return field == Field::order ? studies::dimension::none : studies::dimension::curvature;
}
constexpr const char* title_of(Field field) {
  return field == Field::order ? "order β" : "mean curvature H";
}

inline constexpr double usual_text = 20.0;             // pixels
inline constexpr double pixels_per_mm = 300.0 / 25.4;  // on paper

struct Options {
  std::filesystem::path directory;
  std::string branch;              ///< empty: the one of lowest energy at each point
  std::optional<Size> size;        ///< pixels; without it as large as the content asks for
  std::optional<double> width_mm;  ///< of the page; a picture for paper
  std::optional<double> height_mm;
  std::vector<Format> formats;      ///< empty: PNG and, of pictures without surfaces, SVG
  std::vector<std::string> panels;  ///< of a diagram, in this order; empty: the usual ones
  std::vector<View> views;          ///< of surfaces; empty: the usual ones
  std::vector<double> frames;       ///< times; empty: spread over those there are
  std::vector<std::string> only;    ///< names of the pictures wanted; empty: all
  std::optional<Field> field;  ///< without it by the order, by the curvature where that is uniform
  std::optional<Palette> palette;
  std::optional<Range> scale;                ///< of the colours; without it that of the data
  double energy_shift = 12.566370614359172;  ///< 4π: minus the potential's minimum times the area
  std::optional<studies::ResultUnits>
      units;  ///< of what is drawn; without, numbers are as in the tables

  bool wants(const std::string& picture) const;

  Field field_for(const Range& orders) const;

  std::vector<View> views_or(const std::vector<View>& usual) const {
    return views.empty() ? usual : views;
  }

  /// Of the picture in pixels; without `size` the usual one.
  double width(double usual) const {
    return width_mm ? *width_mm * pixels_per_mm : size ? size->width : usual;
  }
  double height(double usual) const {
    return height_mm ? *height_mm * pixels_per_mm : size ? size->height : usual;
  }
  bool has_size() const { return size || width_mm; }

  /// The size of letters: for a picture of a given size in proportion to it, 8 points on paper.
  double text_size() const;
  double unit() const { return text_size() / usual_text; }  ///< of widths of lines

  Output output(const std::vector<Format>& usual = Output().formats) const;

  /// "U + 4π" for the shift 4π, otherwise with the number; of physical energies "U + 4πE₀".
  std::string energy_name() const;

  /// What a number of the tables is multiplied by to be drawn; of a state with that L.
  double factor(const studies::Dimension& dimension, std::optional<double> L = {}) const {
    return units ? units->scales(L).factor(dimension) : 1.0;
  }
  /// With the unit in which it is drawn.
  std::string titled(const std::string& name, const studies::Dimension& dimension) const {
    return units ? units->titled(name, dimension) : name;
  }
  /// " s", to stand behind a number; nothing where it is as in the tables.
  std::string unit_after(const studies::Dimension& dimension) const;
};

}  // namespace sbeh::picture
