// Branches of rest states in 3D, followed by their own length: each state, folds, and the branches that leave.
#pragma once

#include "studies/rest_states/rest_row.h"
#include "surface3d/stationary/path.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace sbeh::studies {

/// What is there of a row before it is measured.
struct FoundState {
  int path;  ///< 1: the first; in the order in which they are found
  RestPoint kind;
  int from;  ///< number of the state at which its path leaves, or near which it is found; 0: none
  const surface3d::PathSolution& point;
  std::shared_ptr<const surface3d::Triangulation> mesh;
  std::shared_ptr<surface3d::NewtonSystem> system{};  ///< of the mesh, where there is one
};
/// Takes the states one after the other; returns why a path must not be followed any further, empty where it may.
using TakeState = std::function<std::string(const FoundState&)>;

/// Follows the state of the input's one place, and with `switches` what leaves it, until all paths have left the range, or end, or
/// an interrupt. Where the triangles cease to resolve a path, the last state gets new ones, and more of them where these do not do. `number` of
/// the row that is to come is asked for. Empty, or why there is nothing to follow.
std::string follow_branches(const StatesInput& input,
                            std::shared_ptr<const surface3d::Triangulation> mesh,
                            const surface3d::StationaryState& start,
                            const std::function<int()>& number, const TakeState& take);

/// The parameter's value where a state lies on the way from the input's place to `to`, and the input there; without a way, itself.
double value_on_way(const StatesInput& input, double mu);
StatesInput input_on_way(const StatesInput& input, double mu);

}  // namespace sbeh::studies
