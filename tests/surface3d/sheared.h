// Star-shaped surfaces with good and with sheared triangles: the same shape under another mesh.
#pragma once

#include "meshing/shapes.h"

#include <Eigen/Geometry>

namespace sbeh::surface3d::test {

/// r(d) of a spheroid with semi-axes 1, 1, q and of the unit sphere with a harmonic Y_53.
inline meshing::RadialFunction spheroid_radius(double q) {
  return
      [=](const Eigen::Vector3d& d) { return 1 / Eigen::Vector3d(d.x(), d.y(), d.z() / q).norm(); };
}
inline meshing::RadialFunction y53_radius(double amplitude) {
  return [=](const Eigen::Vector3d& d) {
    return 1 + amplitude * meshing::spherical_harmonic(5, 3, d);
  };
}

/// All nodes are on the shape; their directions are those of an even mesh after a shear by `shear`
/// along x and a third of it along y, so that triangles have angles of 32, 21, 13, 8 degrees for a
/// shear of 0.6, 1, 1.5, 2 on the sphere.
inline meshing::CurvedMesh sheared(const meshing::RadialFunction& r, double shear, int triangles) {
  meshing::CurvedMesh mesh = meshing::star_shaped(r, {.triangles = triangles});
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 1) = shear;
  F(1, 2) = shear / 3;
  for (auto x : mesh.nodes.colwise()) {
    const Eigen::Vector3d d = (F * x.normalized()).normalized();
    x = r(d) * d;
  }
  return mesh;
}

}  // namespace sbeh::surface3d::test
