// Energies over time on logarithmic axes.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/chart/axis.h"
#include "tools/picture/options.h"

#include <string>
#include <vector>

namespace sbeh::picture {

/// Points (log₁₀ t, log₁₀(value + shift)); those where either is not positive are left out, so are points
/// too close to tell apart and those in the first millionth of the time.
Points log_log(const std::vector<double>& time, const std::vector<double>& value, double shift);

/// Axes about all curves, with the same decades for all panels.
struct HistoryAxes {
  Axis time;
  Axis energy;
};

HistoryAxes history_axes(const std::vector<Points>& curves, const std::string& energy_name);

/// Histories over reduced volumes and values of L.
struct Histories {
  struct Curve {
    double reduced_volume, L;
    bool is_ssh, in_3d;
    Points points;
  };
  std::vector<double> reduced_volumes{}, lengths{};
  std::vector<Curve> curves{};
  bool sbeh = false, ssh = false, sbeh_3d = false, ssh_3d = false;  ///< what the legend has
};

struct HistoryLayout {
  std::size_t columns;
  double width;            ///< of the picture, when it is ours to choose
  double height_by_width;  ///< of a panel
  double gap;              ///< right of each panel, in text sizes
  double above_legend;     ///< the same
};

/// A panel per reduced volume with a colour per L; SSH is dashed, marks are in 3D. Writes DIR/energy.png and .svg.
void draw_histories(Canvas& canvas, const Options& options, const Histories& all,
                    const HistoryLayout& layout);

}  // namespace sbeh::picture
