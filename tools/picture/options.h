// What the command line says.
#pragma once

#include "studies/io/errors.h"
#include "tools/picture/chart/colours.h"

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
constexpr const char* title_of(Field field) {
  return field == Field::order ? "order β" : "mean curvature H";
}

struct Options {
  std::filesystem::path directory;
  std::string branch;             ///< empty: the one of lowest energy at each point
  std::optional<Size> size;       ///< pixels; without it as large as the content asks for
  std::vector<std::string> only;  ///< names of the pictures wanted; empty: all
  std::optional<Field> field;  ///< without it by the order, by the curvature where that is uniform
  std::optional<Palette> palette;
  std::optional<Range> scale;                ///< of the colours; without it that of the data
  double energy_shift = 12.566370614359172;  ///< 4π: minus the potential's minimum times the area

  bool wants(const std::string& picture) const;

  Field field_for(const Range& orders) const;
  ColourMap colours(Palette usual, const Range& data, double white_share = 0.0) const;

  /// Of the picture in pixels; without `size` the usual one.
  double width(double usual) const { return size ? size->width : usual; }
  double height(double usual) const { return size ? size->height : usual; }

  /// The size of letters: for a picture of a given size in proportion to it.
  double text_size() const;

  /// "U + 4π" for the shift 4π, otherwise with the number.
  std::string energy_name() const;
};

}  // namespace sbeh::picture
