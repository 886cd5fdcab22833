// Curvature of a curved mesh: B = −sym(P ∇n_h P) with the normals of the nodes as a field n_h of
// the mesh's own order. Unlike the triangles' second derivatives it knows of the kinks between
// them.
#pragma once

#include "meshing/curved_mesh.h"

#include <functional>

namespace sbeh::meshing {

/// A point of a curved triangle.
struct SurfacePoint {
  int triangle;
  double dS;                      ///< area this quadrature point stands for
  Eigen::Vector3d x;              ///< position
  Eigen::Vector3d n;              ///< unit normal, outward
  Eigen::Matrix3d B;              ///< shape operator −∇n, symmetric and tangential
  Eigen::VectorXd phi;            ///< shape functions of the triangle's nodes
  Eigen::Matrix3Xd surface_grad;  ///< their surface gradients, 3 x nodes of a triangle

  double H() const { return B.trace(); }                          ///< −2 on the unit sphere
  double K() const { return (H() * H() - B.squaredNorm()) / 2; }  ///< Gaussian curvature
};

/// Visits the quadrature points of this degree of all triangles.
void for_each_point(const CurvedMesh& mesh, int degree,
                    const std::function<void(const SurfacePoint&)>& visit);

/// H at the nodes: the mean over the triangles there.
Eigen::VectorXd node_mean_curvature(const CurvedMesh& mesh);

}  // namespace sbeh::meshing
