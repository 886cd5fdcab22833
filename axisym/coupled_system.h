// The coupled step of model/equations.md as a band matrix with a border.
//
// Under a global area constraint the same element matrices are restricted: to velocities and test
// fields along the node normals, and to a number as pressure, which joins λ in the border.
#pragma once

#include "axisym/curve.h"
#include "axisym/weak_form.h"
#include "model/numerics/area_volume.h"
#include "model/numerics/band_matrix.h"

#include <optional>
#include <vector>

namespace sbeh::axisym {

using model::Target;

/// What a step computes besides the next state.
struct StepFields {
  Nodes V;        // 2 x nodes, velocity on the old surface
  Nodes Y;        // 2 x nodes, displacement of the mesh
  Field H;        // nodes, curvature of the next surface as the scheme knows it
  Field p;        // 2 elements + 1, surface pressure; with lipid_density that of (V3) over n/n(2/3)
  double lambda;  ///< volume multiplier
  double moment;  ///< c of the area difference
};

/// Assembles and solves the system of a step; keeps its memory.
class CoupledSystem {
 public:
  CoupledSystem(const model::Material& material, model::AreaConstraint area, int elements);

  /// Assembles and factors. H: mean curvature of the old surface. Without a target its area (lipid_area) and volume are kept. False
  /// when the matrix is singular.
  [[nodiscard]] bool prepare(const State& old, const Field& H, const std::optional<Target>& target,
                             double tau);
  /// Solves what is prepared, less `lipids` (lipid_load) on the right of (P1).
  [[nodiscard]] bool solve(const Field& lipids, StepFields& out);

 private:
  // A number that multiplies a constraint: its column, the row of the constraint and what that equals.
  struct Multiplier {
    Eigen::VectorXd column, row;
    double rhs = 0;
    double diagonal = 0;
    void set_zero(Eigen::Index size);
  };

  void assemble(const State& old, const Field& H, const StepParameters& step);
  void set_moment(const Nodes& X, const Field& H, double tau, double area);
  void pin(int i);
  void pin_what_is_not_free();
  [[nodiscard]] bool solve_with(const Eigen::VectorXd& rhs, StepFields& out) const;

  model::Material material_;
  model::AreaConstraint area_;
  int elements_;
  Nodes normals_;  // at the nodes of the old curve
  model::BandMatrix matrix_;
  Eigen::VectorXd rhs_;
  Multiplier lambda_, p_, moment_;              // p only under a global area constraint
  std::vector<const Multiplier*> multipliers_;  // those that are there
  Nodes X_;                                     // of the old curve
  double tau_ = 0;
};

}  // namespace sbeh::axisym
