// The discrete curvature of a surface, and displacements along the normal.
#pragma once

#include "surface3d/surface.h"

#include <optional>

namespace sbeh::surface3d {

/// What the scheme knows of the curvature of a surface; H = tr B in P3, −2 on the unit sphere.
struct Curvature {
  Nodes node_normals;  ///< 3 x nodes, unit, see node_normals()
  Nodes normals;       ///< 3 x nodes, L2 projection of the normals into P3, unit at the nodes
  Field H;             ///< nodes, by (H1) without Y: see curvature.cpp
  Field H_from;        ///< nodes, of the other positions; empty without any
  SparseMatrix mass;   ///< (φ_b, φ_a) on the surface
};
/// With the H of other positions on the surface, unless null. Empty when the surface is degenerate.
std::optional<Curvature> curvature_of(const Triangulation& mesh, const Nodes& X,
                                      const Nodes* from = nullptr);

/// B at a point, 2 x 2 in the frame: the deviator of −sym(P ∇_C n P), n the projected normals on the
/// element, with the scheme's own H as its trace.
model::ShapeOperator<double> shape_operator(const SurfacePoint& p, const ElementNodes& normals,
                                            double H);

/// W₂ = ∫ H dS of a surface whose H is known.
double total_mean_curvature(const Triangulation& mesh, const Nodes& X, const Field& H);

/// Moves the surface by (a + bH) n to the area and volume asked for (Newton on a and b). Returns false,
/// and leaves X as it was, when that does not converge to 1e-12 relative; on a sphere, where a and b
/// are the same motion, only the area is met.
bool correct_area_volume(const Triangulation& mesh, Nodes& X, double area, double volume);
/// The same where H is known, if only roughly.
bool correct_area_volume(const Triangulation& mesh, Nodes& X, const Field& H, double area,
                         double volume);

}  // namespace sbeh::surface3d
