// Panels of equal size in a picture: as many side by side as have room, the others in rows below.
#pragma once

#include "tools/picture/options.h"

#include <cstddef>

namespace sbeh::picture {

/// Lengths in pixels.
struct PanelNeeds {
  std::size_t count = 1;
  std::size_t most_columns = 1;
  double usual_width = 0.0;    ///< of the picture for each column, where no size is asked for
  double least_picture = 0.0;  ///< of the picture, there
  double least_width = 0.0;    ///< between the axes, below which a panel is put into the next row
  double height_by_width = 1.0;
  double side = 0.0;                                         ///< margin of each row, to its left
  double left = 0.0, right = 0.0, below = 0.0, above = 0.0;  ///< margins of each panel
  double bottom = 0.0, top = 0.0;                            ///< of the picture
};

struct PanelGrid {
  std::size_t columns = 1, rows = 1;
  double width = 0.0, height = 0.0;      ///< of the picture
  Rect inside(std::size_t panel) const;  ///< between the axes
  bool begins_row(std::size_t panel) const { return panel % columns == 0; }

  PanelNeeds needs{};
  double inner_width = 0.0, inner_height = 0.0;
};

/// In rows panels are flatter, so that a column of them fits on a page.
PanelGrid arranged(const PanelNeeds& needs, const Options& options);

}  // namespace sbeh::picture
