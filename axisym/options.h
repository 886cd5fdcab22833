// What a user may choose of the numerics: the mesh of the generating curve and the time steps.
#pragma once

#include "model/time/step_control.h"

namespace sbeh::axisym {

/// How the axisymmetric solvers discretise. Defaults hold the stationary energies of the paper's
/// scan to 1e-7 relative under halving of both the elements and the steps.
struct Numerics : model::TimeControl {
  int elements = 48;
  double grading = 0.5;

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;

  bool operator==(const Numerics&) const = default;
};

/// The table of its parameters.
template <model::maybe_const<Numerics> N>
void for_each_parameter(N& numerics, auto&& visit) {
  using P = model::Parameter;
  visit(P{"elements", model::between(8, 4096), "P3 elements from pole to pole"}, numerics.elements);
  visit(P{"grading", model::between(0, 4), "how strongly elements gather where curvature is large"},
        numerics.grading);
  for_each_parameter(static_cast<model::const_as<model::TimeControl, N>&>(numerics), visit);
}

inline void Numerics::validate() const {
  model::check_parameters(*this);
  TimeControl::validate();
}

}  // namespace sbeh::axisym
