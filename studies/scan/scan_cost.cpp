#include "studies/scan/scan_cost.h"

#include "studies/scan/scan_stack.h"

#include <algorithm>

namespace sbeh::studies {

namespace {

// Whether states are followed to the material from where their branches are sure.
bool is_followed_to(const model::Material& m) {
  return m.spontaneous_curvature != 0 || m.area_difference.is_there() || !m.flexoelectric.vanishes()
      || m.has_lipid_density();
}

}  // namespace

// Measured on one core of 2026: a branch is entered at every reduced volume, followed to what the material has, and from there in L,
// which SSH's states do not know. Lines between stable and unstable states are looked for along both.
double seconds_of(const ScanInput& input) {
  if (!input.axes.empty()) {
    double seconds = 0;
    for (const ScanLayer& layer : layers_of(input)) seconds += seconds_of(layer.input);
    return seconds;
  }
  if (input.method != Method::newton) return 0.5 * double(point_count(input));
  const auto volumes = double(input.reduced_volume.size());
  if (input.interfaces > 0)
    return double(input.branches.size())
         * (2 + double(point_count(input)) * (0.3 + 0.05 * input.modes));
  const auto branches = double(input.branches.size());
  const double entered = is_followed_to(input.material) ? 0.075 : 0.035;
  constexpr double traced = 2;  // of all branches of a material
  double seconds = input.beyond_fold ? 0.75 * volumes : 0;
  if (input.further
      || std::ranges::find(input.branches, axisym::Branch::pear) != input.branches.end())
    seconds += traced;
  for (const model::Model model : input.models) {
    const double lengths = model == model::Model::SSH ? 1 : double(input.L.size());
    seconds += branches * volumes * (entered + 0.004 * lengths);
    if (input.modes > 0)
      seconds +=
          branches * (0.0022 * (input.modes + 1) * volumes * lengths + 0.018 * (volumes + lengths));
  }
  return seconds;
}

}  // namespace sbeh::studies
