// One linearised stationary problem: assembled, factored, and solved for any right-hand side.
#pragma once

#include "surface3d/linear/direct_solver.h"
#include "surface3d/stationary/rigid_motions.h"

#include <optional>

namespace sbeh::surface3d {

/// A step in all unknowns; fields are nodal, `d` along the node normals.
struct Increment {
  Field d, Lambda, H, beta;
  double tension = 0, pressure = 0, moment = 0, chemical_potential = 0;
  double hold = 0;  ///< the force on what `Holds::amplitude` prescribes
};

/// What is kept besides area, volume and place: loads on the unknowns, orthogonal to which a state may move; empty: none.
struct Holds {
  Eigen::VectorXd amplitude{};
  /// Of the turn about an axis that a state has just left, as long as errors of the normals hide its own turn.
  Eigen::VectorXd phase{};

  bool operator==(const Holds& other) const;
};

/// Largest displacement or change of order in a step.
double largest_change(const Increment& step);

/// The state moves by scale · step along these normals.
void displace(const Increment& step, double scale, const Nodes& normals, StationaryState& state);

/// The Hessian of the Lagrangian, bordered by area, volume and rigid motions.
class NewtonSystem {
 public:
  NewtonSystem(const Triangulation& mesh, const model::Material& material, model::Model model);

  /// From the next linearisation on. Throws std::invalid_argument for a conserved order without its mean.
  void set_material(const model::Material& material);
  /// Assembles at a state that moves along these normals, and factors, unless that is what it did last. False when the matrix is
  /// singular or not finite.
  bool linearise(const StationaryState& state, const Nodes& normals, const Holds& holds = {});

  /// The Newton step towards `target`.
  bool newton_step(const Target& target, Increment& step) const;
  /// The step from another state nearby, with the factors that are there and the material that was set last.
  bool newton_step_from(const StationaryState& state, const Nodes& normals, const Target& target,
                        Increment& step);

  /// What moves under loads on all unknowns while what is constrained changes so: area, −volume, and where they are W₂ − cA/(π k_ad)
  /// and −∫(β − β̄)dS.
  bool respond(const Eigen::VectorXd& loads, const Eigen::VectorXd& change, Increment& step) const {
    return solve(loads, change, step);
  }
  /// The gradient with another material.
  Eigen::VectorXd gradient_with(const model::Material& material, const StationaryState& state,
                                const Nodes& normals);

  /// In how many directions that keep area and volume, rigid motions apart, the energy falls.
  int negative_directions() const;
  /// What is held as the turn about an axis included.
  int rigid_count() const { return int(rigid_.loads.cols()); }
  const RigidMotions& rigid() const { return rigid_; }
  const LagrangianDerivatives& derivatives() const { return derivatives_; }
  const StationaryLayout& layout() const { return layout_; }

  /// Overwrites loads on the unknowns (in columns) with what moves under them, area, volume and place kept.
  void respond(Eigen::Ref<Eigen::MatrixXd> loads) const;

 private:
  // Of what the factors are.
  struct Seen {
    StationaryState state;
    Nodes normals;
    Holds holds;
  };
  bool is_linearised(const StationaryState& state, const Nodes& normals, const Holds& holds) const;
  bool solve(Eigen::VectorXd rhs, const Eigen::VectorXd& miss, Increment& step) const;
  int borders() const {
    return derivatives_.multipliers() + rigid_count() + (has_amplitude_ ? 1 : 0);
  }

  model::Material material_;
  StationaryLayout layout_;
  LagrangianDerivatives derivatives_;
  LagrangianGradient others_;
  double moment_ = 0;  // of the state of linearise
  std::optional<Seen> seen_{};
  RigidMotions rigid_{};
  bool has_amplitude_ = false;
  SparseMatrix bordered_;
  DirectSolver solver_{Symmetry::symmetric};
};

}  // namespace sbeh::surface3d
