// Rectangles, lines and texts at pixel positions: what stands between and beside the charts.
// Everything is given to VTK as shapes: GL2PS as Debian builds it leaves images out of an SVG.
#pragma once

#include "tools/picture/canvas/canvas.h"

#include <vtkContextItem.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::picture {

class Layer : public vtkContextItem {
 public:
  static Layer* New();

  void fill(const Rect& rect, Colour colour);
  void line(const Points& points, const LineStyle& style);
  void segments(const Points& ends, const LineStyle& style);
  void text(double x, double y, const std::string& text, const TextStyle& style);

  bool has_ink() const { return !lines_.empty() || !texts_.empty(); }

  /// Fills first, then lines, then texts.
  bool Paint(vtkContext2D* painter) override;

 private:
  struct Line {
    std::vector<float> points;
    LineStyle style;
    bool joined;  // otherwise a segment between each two points
  };
  struct Text {
    float x;
    float y;
    std::string text;
    TextStyle style;
  };

  void add_line(const Points& points, const LineStyle& style, bool joined);

  std::map<unsigned, std::vector<float>> quads_;  // by colour: one call draws many
  std::vector<Line> lines_;
  std::vector<Text> texts_;
};

}  // namespace sbeh::picture
