// A surface in space, rendered into an image.
#pragma once

#include "meshing/curved_mesh.h"
#include "tools/picture/chart/colours.h"

#include <vtkSmartPointer.h>

class vtkImageData;

namespace sbeh::picture {

/// Where the eye is, seen from the middle of the surface, and what is up.
struct View {
  Eigen::Vector3d from;
  Eigen::Vector3d up;
};

enum class Edges { shown, hidden };

/// Image of `pixels` width, and as much height unless `pixels_high` says otherwise. The surface is coloured
/// by `values`, one per node, and may show the edges of its triangles; `half_width` is the length from
/// the middle of the image to its left or right side.
vtkSmartPointer<vtkImageData> render(const meshing::CurvedMesh& mesh, const Eigen::VectorXd& values,
                                     const ColourMap& colours, const View& view, double half_width,
                                     int pixels, Edges edges = Edges::shown, int pixels_high = 0);

}  // namespace sbeh::picture
