// A stationary state that is asked for: all that it depends on.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/options.h"
#include "model/material.h"

namespace sbeh::axisym {

struct StationaryCase {
  model::Model model = model::Model::SBEH;  ///< SBEH or SSH
  Branch branch = Branch::oblate;
  double reduced_volume = 0;  ///< 0 < V_r <= 1
  model::Material material{};
  Numerics numerics{};

  /// Of the one-constant approximation.
  double L() const { return material.L1; }

  bool operator==(const StationaryCase&) const = default;
};

}  // namespace sbeh::axisym
