// One time step of the ALE scheme: velocity, pressure, curvature and mesh motion, then the order.
#pragma once

#include "model/material.h"
#include "surface3d/coupled_system.h"
#include "surface3d/surface.h"

#include <memory>

namespace sbeh::surface3d {

/// The area and volume that a run keeps.
struct Target {
  double area;
  double volume;
};

/// What a step computes besides the next state.
struct StepFields {
  Nodes V;        // 3 x nodes, velocity on the old surface
  Nodes Y;        // 3 x nodes, displacement of the mesh
  Field H;        // nodes, curvature of the next surface as the scheme knows it
  Field p;        // P2 nodes, surface pressure
  double lambda;  ///< volume multiplier
};

/// Rates of dissipation: dU/dt = −(friction + order + viscous).
struct Dissipation {
  double friction = 0;  ///< ∫ γ_∥|PV|² + γ_⊥(V·ν)² dS
  double order = 0;     ///< ∫ (3/2)(M + μξ²/2) β̇² dS
  double viscous = 0;   ///< ∫ (η/2)|σ(V)|² dS
  double total() const { return friction + order + viscous; }
};

/// Result of a step; `ok` is false when a linear solve failed or the new surface is degenerate, and
/// then nothing else holds.
struct StepResult {
  bool ok = false;
  State state;
  StepFields fields;
  Dissipation dissipation;
};

/// First-order semi-implicit step (coupled step, then the order with its velocity, so that a step
/// is a function of position and order alone). Keeps its matrices between steps.
class TimeStepper {
 public:
  TimeStepper(std::shared_ptr<const Triangulation> mesh, const model::Material& material,
              model::Model model, Scheme scheme = Scheme::split);
  ~TimeStepper();
  TimeStepper(TimeStepper&&) noexcept;
  TimeStepper& operator=(TimeStepper&&) noexcept;

  /// Advances by tau > 0.
  StepResult step(const State& old, const Target& target, double tau);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace sbeh::surface3d
