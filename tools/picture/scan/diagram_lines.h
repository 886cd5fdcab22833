// The lines of a diagram over (reduced volume, L): folds, equal energies, and those between stable and unstable states, from
// a scan's tables.
#pragma once

#include "tools/picture/scan/heat_map.h"

#include <filesystem>

namespace sbeh::picture {

struct DiagramLine {
  std::string name;
  LineStyle style;
  Points points;        ///< (reduced volume, L)
  std::string label{};  ///< beside the line
};

/// From equal_energy.csv, and over L folds.csv and beyond_fold.csv, where they are there; lines of one point are left
/// out. `branch`: only what concerns it; empty: all. Throws InputError.
std::vector<DiagramLine> diagram_lines(const ScanGrid& scan, const std::string& branch);

/// From stability_lines.csv where it is there, of one model; neighbours on the scan's grid are joined.
std::vector<DiagramLine> stability_lines(const ScanGrid& scan, Model model,
                                         const std::string& branch);

/// Draws what of the lines is inside, each with a light border to stand out from any colour.
void draw_diagram_lines(Canvas& canvas, const Rect& inside, const std::vector<DiagramLine>& lines,
                        const HeatMapGrid& grid, double text_size);

/// An entry per name.
std::vector<LegendEntry> legend_of(const std::vector<DiagramLine>& lines);

}  // namespace sbeh::picture
