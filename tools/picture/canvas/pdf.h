// A page of PDF from the SVG that VTK writes: it writes PDF too, but without the letters that are not Latin. Text
// becomes outlines, so that the page needs no font.
#pragma once

#include <string>
#include <string_view>
#include <vector>

class vtkImageData;

namespace sbeh::picture {

/// An image of RGB with its lower left corner at (x, y), in the pixels of the SVG; below all else but the ground.
struct PageImage {
  vtkImageData* image;
  double x, y;
};

/// `width`: of the page in points, 1/72 of an inch. Knows what is in such an SVG: polygons, lines, text. Throws
/// std::runtime_error for a text that is no SVG.
std::string pdf_of(std::string_view svg, const std::vector<PageImage>& images, double width);

}  // namespace sbeh::picture
