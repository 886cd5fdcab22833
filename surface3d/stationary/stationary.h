// Stationary states without an axis by Newton's method: critical points of the energy at fixed area and volume.
//
// The discrete Lagrangian is that of lagrangian.h, the surface in place of the curve of axisym/stationary. Six
// conditions, fewer where a state has an axis of its own, keep rigid motions out; the multipliers that hold them are
// errors of discretisation.
#pragma once

#include "surface3d/stationary/deflation.h"

#include <vector>

namespace sbeh::surface3d {

enum class NewtonStatus { converged, diverged, singular };

struct NewtonOptions {
  int most_iterations = 20;
  double tolerance = 1e-8;     ///< on the largest change of position and order
  double longest_step = 0.15;  ///< larger displacements are shortened to it
  double far = 3;              ///< a larger change leads nowhere
  /// Nodes move along the normals of the surface as it is, as long as changes fall fast; otherwise along those of the guess.
  bool renews_normals = true;
  /// Changes that are small shares of the ones before are made with the matrix of the first of them.
  bool keeps_factors = false;
  Eigen::VectorXd phase{};  ///< of what has left a state with an axis: see Holds
  KnownStates known{};      ///< to which the iteration is not to lead
};

struct NewtonResult {
  NewtonStatus status;
  StationaryState state;          ///< the last iterate
  Nodes normals;                  ///< along which its nodes moved last
  std::vector<double> changes{};  ///< the largest of each iteration
  int negative_directions = 0;    ///< in which the energy falls, at the last matrix
  int rigid_motions = 0;          ///< 6; 5 of a body of revolution, 3 of a sphere
};

/// Completes position and order to a guess: H from the surface, Λ from H, tension and pressure by least
/// squares on the force balance. Throws std::runtime_error where the surface is degenerate.
StationaryState guess_from(const Triangulation& mesh, const model::Material& material,
                           model::Model model, const State& shape);

/// Largest force (normal) or order residual per area of its node, ∫ |φ_i| dS, of the state at which the system is linearised: what
/// rigid motions are held by is left, an error of discretisation.
double residual_of(const NewtonSystem& system, const StationaryState& state);

/// Newton on the Lagrangian at the area and volume of `target`, starting from `guess`.
NewtonResult solve_stationary(NewtonSystem& system, const Target& target,
                              const StationaryState& guess, const NewtonOptions& options = {});

}  // namespace sbeh::surface3d
