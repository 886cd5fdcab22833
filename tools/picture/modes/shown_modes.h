// Which modes a picture shows, and how: a cell each, m across, parities and then more m below.
#pragma once

#include "studies/modes/modes.h"
#include "tools/picture/chart/colours.h"
#include "tools/picture/options.h"

#include <algorithm>
#include <string>
#include <vector>

namespace sbeh::picture {

/// How far a picture displaces at the most, of the largest displacement 1.
inline constexpr double shown_amplitude = 0.15;
/// Less where half of a radius would be lost: a neck does not close.
double amplitude_of(const studies::StateMode& mode);

struct ShownMode {
  studies::StateMode mode;
  std::size_t column, row;  ///< from the left and from the top
};

/// What numbers are multiplied by, and what stands behind them.
struct ShownUnit {
  double factor;
  std::string unit;
};

/// The first mode of each m and parity. Throws InputError where the folder has none.
struct ShownModes {
  explicit ShownModes(const Options& options);

  std::vector<ShownMode> modes;
  std::size_t columns = 0, rows = 0;
  bool by_order = false;   ///< coloured by the change of the order, otherwise by the displacement
  ColourMap colours;       ///< of values over their largest: −1 … 1
  ShownUnit energy, rate;  ///< of eigenvalues and rates

  const axisym::Field& field(const studies::StateMode& mode) const {
    return by_order ? mode.b : mode.u;
  }
  /// What its values are divided by.
  double largest(const studies::StateMode& mode) const {
    return std::max(field(mode).cwiseAbs().maxCoeff(), 1e-300);
  }
  std::string title() const;
};

/// What a cell has above its shape: the mode, its eigenvalue and rate.
std::vector<std::string> words_of(const ShownModes& all, const studies::StateMode& mode);

/// The room above a shape for these.
double height_of_words(const ShownModes& all, double text);
/// They stand at the top of the cell, an unstable one's eigenvalue in red.
void draw_words(Canvas& canvas, const Rect& cell, const ShownModes& all,
                const studies::StateMode& mode, double text);

}  // namespace sbeh::picture
