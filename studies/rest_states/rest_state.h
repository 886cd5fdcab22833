// One rest state by Newton's method, and what is to be said of it.
#pragma once

#include "studies/rest_states/rest_row.h"
#include "studies/rest_states/rest_start.h"
#include "surface3d/stationary/eigenmodes.h"
#include "surface3d/stationary/stationary.h"

#include <memory>
#include <string>

namespace sbeh::studies {

/// With the system linearised at the state.
struct RestState {
  std::shared_ptr<const surface3d::Triangulation> mesh;
  surface3d::StationaryState state{};
  surface3d::Nodes normals{};
  std::shared_ptr<surface3d::NewtonSystem> system{};
  double moved = 0;       ///< largest distance of a node from where it started
  std::string failure{};  ///< why there is none
};
RestState rest_state_from(const StatesInput& input, const axisym::PlanePoint& at,
                          const RestStart& start,
                          const surface3d::NewtonOptions& options = {.keeps_factors = true});

/// A state that its triangles do not resolve, on new ones that do: about as many, or more of them, up to twice as many.
RestState on_new_triangles(const StatesInput& input, const axisym::PlanePoint& at,
                           const RestState& state);

/// A state at which the system is linearised, on a mesh that lives on.
struct SeenState {
  const surface3d::NewtonSystem& system;
  std::shared_ptr<const surface3d::Triangulation> mesh;
  const surface3d::StationaryState& state;
  const surface3d::Nodes& normals;
  axisym::PlanePoint at;
};

/// Whether the triangles do for the surface.
bool resolved_by(const surface3d::Triangulation& mesh, const surface3d::Nodes& X);

RestMeasures measures_of(const SeenState& seen, const model::Material& material);

/// The row's values and status, but for the error; its files in a folder, under its number.
void measure(const StatesInput& input, const SeenState& seen, const std::filesystem::path& folder,
             RestRow& row);

/// A row without measures.
RestRow row_at(const StatesInput& input, const StatePlace& place);

/// The difference from the state that `coarser`, with a quarter of the triangles, leads to: errors of fourth order are a
/// fifteenth of it, but now and then its own errors are no larger. Not known where that is no state, or another one: one with other negative
/// directions, or, `on_path`, farther away than another branch next to its branching point would be.
double energy_error(const StatesInput& input, const RestRow& row, const RestStart& coarser,
                    bool on_path = false);

/// The same on a path, with a quarter of the state's own triangles, or half of them where these have no such state.
double energy_error_on_path(const StatesInput& input, const RestRow& row, const SeenState& seen);

/// The whole row of a place, and its files.
RestRow rest_row(const StatesInput& input, const StatePlace& place,
                 const std::filesystem::path& folder);

}  // namespace sbeh::studies
