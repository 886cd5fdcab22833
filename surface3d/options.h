// What a user may choose of the numerics of the 3D solver.
#pragma once

#include "meshing/resolution.h"
#include "model/names.h"
#include "model/time/step_control.h"

#include <array>

namespace sbeh::surface3d {

enum class Integrator {
  multi_step,  ///< third order, near rest second, for one solve a step, see model/time/multi_step.h
  two_step,    ///< second order, likewise
  step_doubling,  ///< three solves a step, see model/time/step_doubling.h
  variational     ///< the energy falls in any step; first order, a few dear solves: variational/
};
constexpr auto names(Integrator) {
  return std::array{"multi-step", "two-step", "step-doubling", "variational"};
}

/// How the mesh equations join the flow, see monolithic.h and split.h.
enum class Scheme { split, monolithic };
constexpr auto names(Scheme) { return std::array{"split", "monolithic"}; }

/// How a step solves its linear systems.
enum class Factorisation {
  lagged,     ///< factors of an earlier step, refactored when that is cheaper
  every_step  ///< the reference: exact solutions
};
constexpr auto names(Factorisation) { return std::array{"lagged", "every-step"}; }

/// How the 3D solver steps in time. The mesh is chosen with the start.
struct Numerics : model::TimeControl {
  Numerics() {
    tolerance = 1e-4;
    first_step = 1e-5;
  }
  Integrator integrator = Integrator::multi_step;
  Scheme scheme = Scheme::split;
  Factorisation factorisation = Factorisation::lagged;
  double solver_tolerance = 1e-5;
  bool remesh = false;
  int most_triangles = 5120;

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;

  bool operator==(const Numerics&) const = default;
};

/// The table of its parameters.
template <model::maybe_const<Numerics> N>
void for_each_parameter(N& numerics, auto&& visit) {
  using P = model::Parameter;
  for_each_parameter(static_cast<model::const_as<model::TimeControl, N>&>(numerics), visit);
  visit(P{"integrator", {}, "multi-step and two-step need extrapolate = true"},
        numerics.integrator);
  visit(P{"scheme", {}, "of the coupled step, see surface3d/README.md"}, numerics.scheme);
  visit(P{"factorisation", {}, "how a step solves its linear systems"}, numerics.factorisation);
  visit(P{"solver_tolerance", model::between(1e-12, 1e-2), "of the linear systems"},
        numerics.solver_tolerance);
  visit(P{"remesh", {}, "make new triangles where they do not resolve the surface"},
        numerics.remesh);
  visit(P{"most_triangles", model::between(meshing::fewest_triangles, meshing::most_triangles),
          "never more than so many"},
        numerics.most_triangles);
}

}  // namespace sbeh::surface3d
