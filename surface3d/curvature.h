// The discrete curvature of a surface, and displacements along the normal.
#pragma once

#include "surface3d/surface.h"

#include <optional>

namespace sbeh::surface3d {

/// H in P3 (nodes; H = tr B, −2 on the unit sphere) with (H ν, Z) = −(1, Div_C Z) for the test fields
/// Z = φ_i n_i, n_i the normal at node i: the curvature equation (H1) of the scheme, tested in the
/// normal direction. Empty when the surface is degenerate.
Field mean_curvature(const Triangulation& mesh, const Nodes& X, const Nodes& node_normals);
/// The H of the same equation for other positions: (H ν, Z) = −(∇_C position, ∇_C Z) on the surface X.
Field mean_curvature(const Triangulation& mesh, const Nodes& X, const Nodes& node_normals,
                     const Nodes& position);

/// The L2 projection of the normals into (P3)³, of unit length at the nodes; empty when it fails.
Nodes projected_normals(const Triangulation& mesh, const Nodes& X);

/// What the scheme knows of the curvature of a surface.
struct Curvature {
  Nodes node_normals;  // 3 x nodes, unit, see node_normals()
  Nodes normals;       // 3 x nodes, unit, see projected_normals()
  Field H;             // nodes, see mean_curvature()
};
/// Empty when the surface is degenerate.
std::optional<Curvature> curvature_of(const Triangulation& mesh, const Nodes& X);

/// B at a point, 2 x 2 in the frame: the deviator of −sym(P ∇_C n P), n the projected normals on the
/// element, with the scheme's own H as its trace.
model::ShapeOperator<double> shape_operator(const SurfacePoint& p, const ElementNodes& normals,
                                            double H);

/// Moves the surface by (a + bH) n to the area and volume asked for (Newton on a and b). Returns false,
/// and leaves X as it was, when that does not converge to 1e-12 relative; on a sphere, where a and b
/// are the same motion, only the area is met.
bool correct_area_volume(const Triangulation& mesh, Nodes& X, double area, double volume);

}  // namespace sbeh::surface3d
