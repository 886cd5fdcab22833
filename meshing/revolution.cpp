#include "meshing/revolution.h"

#include "meshing/even_mesh.h"

#include <cmath>

namespace sbeh::meshing {

using Eigen::Vector2d;
using Eigen::Vector3d;

RevolvedMesh revolved(const Profile& profile, const Resolution& resolution) {
  resolution.validate();
  Profile down = profile;  // from the north pole to the south pole
  validate(down);
  if (down.X(1, 0) < down.X(1, down.X.cols() - 1)) {
    down.X = down.X.rowwise().reverse().eval();
    down.beta = down.beta.reverse().eval();
  }
  const ProfileCurve curve(down);
  const auto in_plane = [](const Vector3d& x) { return Vector2d(std::hypot(x[0], x[1]), x[2]); };
  const auto turned = [](const Vector2d& rz, const Vector3d& x) -> Vector3d {
    const double rho = std::hypot(x[0], x[1]);
    if (rho == 0) return {rz[0], 0, rz[1]};
    return {rz[0] * (x[0] / rho), rz[0] * (x[1] / rho), rz[1]};
  };
  const Projection onto_profile = [&](const Vector3d& x) {
    return turned(curve.at(curve.nearest(in_plane(x))), x);
  };
  // The sphere's latitudes go where the surface has the same share of its area.
  const Projection from_sphere = [&](const Vector3d& d) {
    return turned(curve.at(curve.at_area((1 - d.z()) / 2)), d);
  };
  RevolvedMesh result{.mesh = even_mesh(resolution, from_sphere, onto_profile), .beta = {}};
  if (down.beta.size() == 0) return result;
  result.beta.resize(result.mesh.node_count());
  for (int i = 0; i < result.mesh.node_count(); ++i)
    result.beta[i] = curve.beta_at(curve.nearest(in_plane(result.mesh.nodes.col(i))));
  return result;
}

}  // namespace sbeh::meshing
