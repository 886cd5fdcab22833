// What VTK paints in a picture, in its order: the ground, layers of plain shapes, images.
#pragma once

#include "tools/picture/canvas/canvas.h"

#include <vtkContextItem.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

namespace sbeh::picture {

/// The white ground, on which one unit is one pixel: VTK stretches a picture by one pixel over its width
/// and its height, which blurs letters and, with smoothed edges, shows their upper edge once more below.
class Ground : public vtkContextItem {
 public:
  static Ground* New();
  bool Paint(vtkContext2D* painter) override;
};

/// Rectangles, lines and texts at pixel positions: what stands between and beside the charts. They are given to
/// VTK as shapes: GL2PS as Debian builds it leaves images out of an SVG.
class Layer : public vtkContextItem {
 public:
  static Layer* New();

  void add_fill(const Rect& rect, Colour colour);
  /// `joined`: otherwise a segment between each two points.
  void add_line(const Points& points, const LineStyle& style, bool joined);
  void add_text(double x, double y, const std::string& text, const TextStyle& style);
  bool has_only_fills() const { return lines_.empty() && texts_.empty(); }

  /// Fills first, then lines, then texts.
  bool Paint(vtkContext2D* painter) override;

 private:
  struct Line {
    std::vector<float> points;
    LineStyle style;
    bool joined;
  };
  struct Text {
    float x, y;
    std::string text;
    TextStyle style;
  };
  std::map<unsigned, std::vector<float>> quads_;  // by colour: one call draws many
  std::vector<Line> lines_;
  std::vector<Text> texts_;
};

class Image : public vtkContextItem {
 public:
  static Image* New();
  bool Paint(vtkContext2D* painter) override;

  vtkSmartPointer<vtkImageData> image;
  double x = 0.0, y = 0.0;
};

}  // namespace sbeh::picture
