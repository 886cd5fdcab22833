// What a window shows as PNG, SVG and PDF.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/canvas/pdf.h"

#include <filesystem>
#include <vector>

class vtkRenderWindow;

namespace sbeh::picture {

/// Writes `stem`.png and so on, each under a temporary name first; throws std::runtime_error. `images` are those of the
/// window, which VTK leaves out of the SVG.
void write_picture(vtkRenderWindow* window, const std::vector<PageImage>& images,
                   const std::filesystem::path& stem, const Output& output);

}  // namespace sbeh::picture
