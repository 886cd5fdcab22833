// Images among the drawings of a canvas.
#pragma once

#include "tools/picture/canvas/canvas.h"

class vtkImageData;

namespace sbeh::picture {

/// Puts the image with its lower left corner at (x, y), pixel by pixel; in an SVG it is embedded as PNG.
void draw_image(Canvas& canvas, vtkImageData* image, double x, double y);

}  // namespace sbeh::picture
