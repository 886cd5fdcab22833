// The discrete mean curvature of a generating curve, and displacements along the normal.
#pragma once

#include "axisym/curve.h"

namespace sbeh::axisym {

/// H in P3 (nodes; H = tr B, −2 on the unit sphere) with (H ν, Z) = −(1, Div_C Z) for the test fields
/// Z = φ_i n_i, n_i the normal at node i: the curvature equation (H1) of the scheme, tested in the
/// normal direction. Empty when the curve is degenerate.
Field mean_curvature(const Nodes& X);

/// W₂ = ∫ H dS of a curve whose H is known.
double total_mean_curvature(const Nodes& X, const Field& H);

/// How well the nodes resolve the curve: the largest |B_ss| times the node spacing, B_ss = H − B_φφ.
double resolution(const Nodes& X, const Field& H);

/// The two principal curvatures of B at a point: B_ss = H − B_φφ and B_φφ; K is their product.
inline double gauss_curvature(double H, double B_phi) { return B_phi * (H - B_phi); }

/// Moves the curve by (a + bH) n to the area and volume asked for (Newton on a and b). Returns false, and leaves X as it was, when that does not converge to 1e-12
/// relative; on a sphere, where a and b are the same motion, only the area is met.
bool correct_area_volume(Nodes& X, double area, double volume);

}  // namespace sbeh::axisym
