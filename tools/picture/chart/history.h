// Energies over time on a logarithmic axis.
#pragma once

#include "tools/picture/canvas/canvas.h"
#include "tools/picture/chart/axis.h"
#include "tools/picture/options.h"

#include <string>
#include <vector>

namespace sbeh::picture {

/// Points (log₁₀ t, value + shift), but those in the first millionth of the time.
Points over_time(const std::vector<double>& time, const std::vector<double>& value, double shift);

/// Of energies: linear as soon as one is not positive.
enum class EnergyScale { logarithmic, linear };
EnergyScale scale_for(const std::vector<Points>& curves);

/// As drawn: on a logarithmic scale log₁₀ of the values, those above 10^`floor`; without points too close to tell apart.
/// `height`: of all energies shown.
Points on_scale(const Points& curve, EnergyScale scale, double height, double floor = -1e300);

/// Axes about all curves, as drawn, their names with the units, with the same ticks for all panels of `length` pixels.
struct HistoryAxes {
  Axis time;
  Axis energy;
};

Range energies_of(const std::vector<Points>& curves);

HistoryAxes history_axes(const std::vector<Points>& curves, EnergyScale scale,
                         const std::string& energy_name, double length, const Options& options);

/// Histories over reduced volumes and values of L.
struct Histories {
  struct Curve {
    double reduced_volume, L;
    bool is_ssh, in_3d;
    Points points;  ///< see over_time
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
