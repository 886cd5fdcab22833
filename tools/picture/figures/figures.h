// The paper's figures 1 to 4, from the tables that `sbeh figures` leaves (studies/figures/tables.h).
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/options.h"

namespace sbeh::picture {

/// The energies of the oblates over time, a panel per reduced volume, from DIR/energy.csv.
void draw_figure_energy(Canvas& canvas, const Options& options);

/// The stationary oblates in space and cuts through them, from DIR/shapes.csv and DIR/cuts.csv.
void draw_figure_shapes(Canvas& canvas, const Options& options);

/// The shapes of SBEH above those of SSH at the same instants, from DIR/evolution.csv.
void draw_figure_evolution(Canvas& canvas, const Options& options);

/// Energy, W₂ and standard deviation of the order over time, from DIR/measures.csv.
void draw_figure_measures(Canvas& canvas, const Options& options);

}  // namespace sbeh::picture
