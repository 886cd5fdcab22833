// The branches of one line of a diagram, and what is special on them.
#pragma once

#include "axisym/diagram/trace.h"
#include "studies/diagram/diagram_input.h"

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// How near to a loss of symmetry the last state is of a branch that comes back there, in V_r.
inline constexpr double near_return = 0.01;

struct DiagramBranch {
  std::string
      name;  ///< oblate, prolate; pear of what leaves a prolate, stomatocyte an oblate; further ones with a number
  std::string from;     ///< that it leaves, empty where it comes from the sphere
  double start_volume;  ///< V_r where it leaves; of those from the sphere where it is entered
  std::optional<double>
      end_volume;  ///< within near_return of which it comes back to a symmetric shape
  axisym::Line line;
  axisym::Trace trace;
};

/// Where the branches of the bilayer couple begin: those with H₀ = 0, on which no moment acts.
std::vector<DiagramBranch> classical_diagram_branches(const DiagramInput& input);

/// All at one value: the symmetric ones, and what leaves them. `classical` is looked at for the bilayer couple alone; else
/// oblates and prolates are found near the sphere.
std::vector<DiagramBranch> branches_at(const DiagramInput& input, double value,
                                       const std::vector<DiagramBranch>& classical);

}  // namespace sbeh::studies
