// The first state of an axisymmetric evolution.
#pragma once

#include "axisym/flow.h"
#include "studies/evolution/relax_input.h"

namespace sbeh::studies {

/// The state and the area and volume that the input asks to start from, and the material (of a scan's
/// row: its L). Throws OutputError or std::invalid_argument when the start cannot be made.
struct RelaxStart {
  axisym::State state;
  axisym::Target target;
  model::Material material;
};
RelaxStart start_of(const RelaxInput& input);

}  // namespace sbeh::studies
