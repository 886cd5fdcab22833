// The surface from which Newton's method goes to a rest state.
#pragma once

#include "studies/rest_states/states_input.h"
#include "surface3d/stationary/newton_system.h"

#include <memory>
#include <string>

namespace sbeh::studies {

struct RestStart {
  std::shared_ptr<const surface3d::Triangulation> mesh;  ///< none where there is no start
  surface3d::State state;
  std::string failure{};  ///< why there is none
  /// Of these triangles and of any material, where there is one already: another one must order its unknowns anew.
  std::shared_ptr<surface3d::NewtonSystem> system{};
};

/// With about so many triangles; 0: as many as the file has, or as the input says. A file's own triangles are made anew for
/// another number. Throws InputError, OutputError, and std::invalid_argument where a perturbation is too large.
RestStart rest_start(const StatesInput& input, const axisym::PlanePoint& at, int triangles = 0);

/// A surface on about so many other triangles; says why where there are none.
RestStart remeshed_start(const surface3d::Triangulation& mesh, const surface3d::State& state,
                         const model::Material& material, int triangles);

/// As rest_start, with so few triangles that there may be none: it then says why.
RestStart coarser_start(const StatesInput& input, const axisym::PlanePoint& at, int triangles);

}  // namespace sbeh::studies
