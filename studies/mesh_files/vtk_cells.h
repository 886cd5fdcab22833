// The cells of VTK, from its XML files and from the legacy ones.
#pragma once

#include "studies/mesh_files/mesh_file.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// The numbers of its points may be anything: of a damaged file.
struct VtkCell {
  int type = 0;
  std::vector<long> points;
};

/// Faces by the numbers which their cells have in the file; curved triangles when the first face is one. Points and
/// lines are left out with a note. Throws InputError that names the cell which is no face, lacks a point, or is
/// of another order than the others.
MeshFile mesh_of(const Eigen::Matrix3Xd& points, const std::vector<VtkCell>& cells,
                 const std::string& file);

}  // namespace sbeh::studies
