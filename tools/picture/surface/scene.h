// A surface in space, rendered into a picture.
#pragma once

#include "meshing/curved_mesh.h"
#include "tools/picture/canvas/view.h"
#include "tools/picture/chart/colours.h"

namespace sbeh::picture {

enum class Edges { shown, hidden };

/// The largest distance of a node from the middle of all.
double radius_of(const meshing::CurvedMesh& mesh);

/// Renders the surface into the whole pixels of a cell. It is coloured by `values`, one per node, and may show the
/// edges of its triangles; `half_width` is the length from the middle of the cell to its left or right side.
void draw_surface(Canvas& canvas, const Rect& cell, const meshing::CurvedMesh& mesh,
                  const Eigen::VectorXd& values, const ColourMap& colours, const View& view,
                  double half_width, Edges edges = Edges::hidden);

}  // namespace sbeh::picture
