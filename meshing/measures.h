// Area and volume of a curved surface, their exact gradients, and scaling to what is asked for.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/triangle_mesh.h"
#include "model/numerics/area_volume.h"

namespace sbeh::meshing {

/// Area A = ∫ |X_1 × X_2|, by quadrature of degree 12 on each curved triangle.
double area(const CurvedMesh& mesh);

/// Enclosed volume V = (1/3) ∫ X·(X_1 × X_2), exact for the curved triangles; > 0 when outward.
double volume(const CurvedMesh& mesh);

/// The same for plain triangles.
double area(const TriangleMesh& mesh);
double volume(const TriangleMesh& mesh);

/// Centre of the area, (1/A) ∫ X.
Eigen::Vector3d centre(const CurvedMesh& mesh);

using model::reduced_volume;
double reduced_volume(const CurvedMesh& mesh);

/// Derivatives by the positions of the nodes, 3 x nodes, exact for `area` and `volume` above.
Eigen::Matrix3Xd area_gradient(const CurvedMesh& mesh);
Eigen::Matrix3Xd volume_gradient(const CurvedMesh& mesh);

/// Unit normals at the nodes, outward: the normalised sum of those of the curved triangles there;
/// 3 x nodes.
Eigen::Matrix3Xd node_normals(const CurvedMesh& mesh);
/// Unit normals at the points: the normalised sum of those of the triangles there, weighted by their areas;
/// 3 x points.
Eigen::Matrix3Xd point_normals(const TriangleMesh& mesh);

/// Moves every node by the same small distance along its normal and scales about the origin, so
/// that area and reduced volume are those asked for, to rounding. Returns false, and leaves the
/// mesh as it was, when there is no such distance up to a tenth of √(A/4π).
bool correct_area_volume(CurvedMesh& mesh, double area, double reduced_volume);

/// Scales about the origin to this area > 0.
void scale_to_area(CurvedMesh& mesh, double area);

}  // namespace sbeh::meshing
