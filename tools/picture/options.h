// What the command line says.
#pragma once

#include "studies/io/errors.h"

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

struct Options {
  std::filesystem::path directory;
  std::string branch;             ///< empty: the one of lowest energy at each point
  std::optional<Size> size;       ///< pixels; without it as large as the content asks for
  std::vector<std::string> only;  ///< names of the pictures wanted; empty: all
  double energy_shift = 12.566370614359172;  ///< 4π: minus the potential's minimum times the area

  bool wants(const std::string& picture) const;

  /// Of the picture in pixels; without `size` the usual one.
  double width(double usual) const { return size ? size->width : usual; }
  double height(double usual) const { return size ? size->height : usual; }

  /// The size of letters: for a picture of a given size in proportion to it.
  double text_size() const;

  /// "U + 4π" for the shift 4π, otherwise with the number.
  std::string energy_name() const;
};

}  // namespace sbeh::picture
