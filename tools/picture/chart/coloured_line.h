// A curve of a chart with one colour per point, which VTK's own line plot cannot show.
#pragma once

#include "tools/picture/canvas/canvas.h"

#include <vtkPlotLine.h>

#include <vector>

namespace sbeh::picture {

class ColouredLine : public vtkPlotLine {
 public:
  static ColouredLine* New();

  /// As many as the table has rows.
  void set_colours(const std::vector<Colour>& colours);

  /// Draws the pieces between the middles of the pieces first: they close the gaps at the joints.
  bool Paint(vtkContext2D* painter) override;

 private:
  std::vector<unsigned char> colours_;  // red, green, blue, opacity of each point
};

}  // namespace sbeh::picture
