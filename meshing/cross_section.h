// Where a plane cuts a curved surface.
#pragma once

#include "meshing/curved_mesh.h"

#include <vector>

namespace sbeh::meshing {

/// A closed curve, its first point repeated at its end.
struct CrossSection {
  Eigen::Matrix3Xd points;  // 3 x n, on the curved triangles to rounding
  Eigen::VectorXd values;   // n, of the field there
};

/// The curves in which the plane through `point` cuts the surface, with a field given at the nodes. Each
/// triangle gives some ten points across. The plane must contain no edge of the mesh: planes in general
/// position do not.
std::vector<CrossSection> cross_section(const CurvedMesh& mesh, const Eigen::VectorXd& field,
                                        const Eigen::Vector3d& point,
                                        const Eigen::Vector3d& normal);

}  // namespace sbeh::meshing
