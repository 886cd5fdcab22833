// The pictures of the classical diagram, of a comparison, of a study of stability and of rest states in 3D, each written as PNG and
// SVG into the folder of its tables. All throw InputError.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// branches: reduced energy over reduced volume, from branches.csv and points.csv of `sbeh seifert`. Curves of
/// the first witness, the others as marks on them, and the special points with their names and shapes.
void draw_classical_diagram(Canvas& canvas, const Options& options);

/// diagram: the lines of bifurcations.csv of `sbeh diagram` over V_r, with the shapes of shapes.csv.
void draw_phase_diagram(Canvas& canvas, const Options& options);

/// profiles: from profiles.csv of `sbeh compare`. Cross sections of all methods on top of each other, the 3D
/// solver's nodes as marks, and below them the distance from the first method over the arc length.
void draw_compared_profiles(Canvas& canvas, const Options& options);

/// histories: from histories.csv of `sbeh compare`. The energies of all methods over time, and below them how far they
/// are from the first.
void draw_compared_histories(Canvas& canvas, const Options& options);

/// stability: which axisymmetric states are stable in 3D, from stability.csv. Markers over (V_r, L), or rates
/// over V_r where there is one L.
void draw_stability(Canvas& canvas, const Options& options);

/// surfaces: the states of states.csv that were found, from their frames, with what is said of each.
void draw_rest_surfaces(Canvas& canvas, const Options& options);

/// branches: their energy and how far they are from an axis over what [follow] changes, minima solid, saddles dashed.
void draw_rest_branches(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
