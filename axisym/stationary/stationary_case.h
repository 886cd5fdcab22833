// A stationary state that is asked for: all that it depends on.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/options.h"
#include "model/material.h"

namespace sbeh::axisym {

/// Where a state belongs: reduced volume and elastic constant of the one-constant approximation.
struct PlanePoint {
  double reduced_volume;
  double L;
};

struct StationaryCase {
  model::Model model = model::Model::SBEH;  ///< SBEH or SSH
  Branch branch = Branch::oblate;
  double reduced_volume = 0;  ///< 0 < V_r <= 1
  int interfaces =
      0;  ///< between phases of the order (domains.h); 0: the branch begins with a uniform one
  model::Material material{};
  Numerics numerics{};

  /// Of the one-constant approximation.
  double L() const { return material.L1; }
  PlanePoint at() const { return {reduced_volume, L()}; }

  bool operator==(const StationaryCase&) const = default;
};

}  // namespace sbeh::axisym
