// Model and material as numbers by name: how files that hold numbers alone say with what they were computed.
#pragma once

#include "studies/parameters/physics.h"

#include <Eigen/Core>

#include <map>
#include <string>

namespace sbeh::studies {

/// Adds `model`, its place in the list of models, and `material.NAME` for each parameter.
void write_physics(const Physics& physics, std::map<std::string, Eigen::VectorXd>& numbers);

/// Empty where the numbers do not say it. Parameters that they lack, of a version which did not know them, have
/// their defaults. Throws InputError, naming the file, for a model or parameter that this version does not know.
std::optional<Physics> physics_in(const std::map<std::string, Eigen::VectorXd>& numbers,
                                  const std::string& file);

}  // namespace sbeh::studies
