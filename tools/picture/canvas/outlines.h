// Letters as shapes to fill: VTK's own way to these leaves out what is not Latin.
#pragma once

#include <string>

namespace sbeh::picture {

/// A line of text from the beginning of its base line, x to the right and y upwards, in units of the size of the letters.
struct Outlines {
  std::string path;  ///< in the operators of PDF: m, l, c
  double width = 0.0;
};

/// Throws std::runtime_error where no font is installed.
Outlines outlines_of(const std::string& text);

}  // namespace sbeh::picture
