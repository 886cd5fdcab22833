// Surfaces of revolution from their profiles, P3 elements in the half-plane (r, z), with the order that lives on
// them.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/resolution.h"
#include "model/numerics/profile.h"

#include <Eigen/Core>

namespace sbeh::meshing {

using model::Profile;

/// A profile, of the points that `revolved` asks for, prepared for searching. Places on it are numbers t in [0, elements]: element ⌊t⌋ at
/// its own coordinate.
class ProfileCurve {
 public:
  explicit ProfileCurve(const Profile& profile);

  Eigen::Vector2d at(double t) const;
  double beta_at(double t) const;
  /// Place of the point of the curve nearest to (r, z).
  double nearest(const Eigen::Vector2d& x) const;
  /// Place up to which the surface of revolution has this fraction of its area, seen from the first
  /// node, to plotting accuracy.
  double at_area(double fraction) const;

 private:
  /// Nearest place within [low, high], which lies in one element.
  double nearest_between(double low, double high, const Eigen::Vector2d& x) const;

  Profile profile_;
  Eigen::Matrix2Xd samples_;  // equidistant in t, joints included
  Eigen::VectorXd area_;      // up to each sample, last = 1
};

struct RevolvedMesh {
  CurvedMesh mesh;
  Eigen::VectorXd beta;  ///< at the nodes; empty if the profile has none
};

/// The profile revolved about the z axis, all nodes on it, a vertex of the mesh at each pole; a
/// five-fold axis of the mesh along z as long as no new triangles are needed for good angles.
/// Outward whichever way the profile runs. Throws std::invalid_argument naming the node unless the points are
/// those of P3 elements: not finite, r < 0, r > 0 at a pole, r = 0 elsewhere, a number of nodes that fits no
/// elements, or β of another size.
RevolvedMesh revolved(const Profile& profile, const Resolution& resolution);

}  // namespace sbeh::meshing
