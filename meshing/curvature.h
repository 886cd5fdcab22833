// Curvature of curved triangles, each as the smooth surface it is; edges between them count nothing.
#pragma once

#include "meshing/curved_mesh.h"

#include <functional>

namespace sbeh::meshing {

/// A point of a curved triangle.
struct SurfacePoint {
  int triangle;
  double dS;            ///< area this quadrature point stands for
  Eigen::Vector3d x;    ///< position
  Eigen::Vector3d n;    ///< unit normal, outward
  double H;             ///< trace of the shape operator B = −∇n, −2 on the unit sphere
  double K;             ///< its determinant, the Gaussian curvature
  Eigen::VectorXd phi;  ///< shape functions of the triangle's nodes
  Eigen::Matrix3Xd surface_grad;  ///< their surface gradients, 3 x nodes of a triangle
};

/// Visits the quadrature points of this degree of all triangles.
void for_each_point(const CurvedMesh& mesh, int degree,
                    const std::function<void(const SurfacePoint&)>& visit);

/// Integrals over the surface.
struct CurvatureIntegrals {
  double H = 0;          ///< W₂, −8π on the unit sphere
  double H_squared = 0;  ///< 16π on every sphere
  double K = 0;          ///< 4π up to the error of the elements
};
CurvatureIntegrals curvature_integrals(const CurvedMesh& mesh);

/// H at the nodes: the mean over the triangles there. For pictures; needs order >= 2.
Eigen::VectorXd node_mean_curvature(const CurvedMesh& mesh);

}  // namespace sbeh::meshing
