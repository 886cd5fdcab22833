// Surfaces of revolution from their profiles, with the order that lives on them.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/profile_curve.h"
#include "meshing/shapes.h"

namespace sbeh::meshing {

struct RevolvedMesh {
  CurvedMesh mesh;
  Eigen::VectorXd beta;  ///< at the nodes; empty if the profile has none
};

/// The profile revolved about the z axis, all nodes on it, a vertex of the mesh at each pole; a
/// five-fold axis of the mesh along z as long as no new triangles are needed for good angles.
/// Outward whichever way the profile runs. Throws std::invalid_argument for a profile that is none
/// (see validate).
RevolvedMesh revolved(const Profile& profile, const Resolution& resolution);

}  // namespace sbeh::meshing
