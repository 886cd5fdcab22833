// The coupled step of model/equations.md as sparse linear systems.
//
// Momentum, (P1), (P2) are the same in both schemes; how the mesh equations join them is said in
// monolithic.h and split.h. Both schemes have the same states of rest, and differ in motion by the order of
// the method in τ. Both are cut from the same element matrices.
//
// Six more multipliers keep the friction of V from having a resultant or a moment; where there is none, they
// make (R, V) = 0 for the rigid motions R.
//
// Under a global area constraint the same element matrices are restricted: to velocities and test
// fields along the node normals, one speed v for each node, and to a number as pressure.
#pragma once

#include "surface3d/curvature.h"
#include "surface3d/element_system.h"
#include "surface3d/monolithic.h"
#include "surface3d/options.h"
#include "surface3d/split.h"

#include <variant>

namespace sbeh::surface3d {

/// The positions from which the displacement Y counts, 3 x nodes, and their curvature on the surface of
/// the step, see curvature_of.
struct Origin {
  const Nodes& X;
  const Field& H;
};

/// What a step keeps besides the equations at points.
struct Constraints {
  double
      area_rate;  ///< (A₀ − A)/(τA) of (P1); A₀ and A in its numerator are those of lipids_and_volume
  double volume_rate;  ///< (vol₀ − vol)/τ of (P2)
  bool keep_volume;  ///< false on a sphere, where a constant p and λ are one unknown: then λ = 0
  double area;       ///< A of (P3)
};

/// Assembles the systems of a step; keeps their structure and memory. Of matrices each rank has the part of its
/// own triangles.
class CoupledSystem {
 public:
  CoupledSystem(const Triangulation& mesh, const model::Material& material, Scheme scheme,
                model::AreaConstraint area = model::AreaConstraint::local);

  /// Fills the systems from the old state, with h of (V12); elements in parallel, sums in a fixed order.
  void assemble(const Triangulation& mesh, const State& old, const Curvature& curvature,
                const Field& order_force, const Origin& from, double tau,
                const Constraints& constraints);

  /// From now on: less this load (lipid_load) on the right of (P1).
  void set_lipids(const Field& load);
  /// From the next assembly on: with another potential.
  void set_material(const model::Material& material) { material_ = material; }

  /// V, p, H, when monolithic Y, λ and what keeps the friction, with an area difference c; or, under a global area
  /// constraint, v, H, Y, λ, c and p.
  const LinearSystem& flow() const { return flow_; }
  /// Of the mesh, where Y is not one of the flow's unknowns; else empty. The right-hand side lacks what
  /// depends on the flow, see motion_rhs.
  const LinearSystem& motion() const;
  /// The whole right-hand side of `motion`, for a solution of `flow`.
  Eigen::VectorXd motion_rhs(const Eigen::VectorXd& flow) const;

  // Parts of a solution of `flow`:
  Nodes velocity(const Eigen::VectorXd& flow) const;   // 3 x nodes
  Field pressure(const Eigen::VectorXd& flow) const;   // P2 nodes
  Field curvature(const Eigen::VectorXd& flow) const;  // nodes
  double lambda(const Eigen::VectorXd& flow) const { return flow[layout_.lambda]; }
  /// Y, 3 x nodes, NaN where the surface is too degenerate for (Y1).
  Nodes displacement(const Eigen::VectorXd& flow, const Eigen::VectorXd& motion) const;
  /// Multiplies the displacements of these solutions by a factor.
  void scale_displacements(double factor, Eigen::VectorXd& flow, Eigen::VectorXd& motion) const;

 private:
  bool along_normals() const { return area_ == model::AreaConstraint::global; }
  bool has_displacement() const;
  void set_flow(const ElementSystem& element, bool keep_volume, FlowPiece& piece) const;
  void add_flow(int e, const ElementNodes& normals, FlowPiece& piece);
  void set_multipliers(const Constraints& constraints);
  void set_diagonal(int multiplier, double value);
  void set_moment(double W2, const Constraints& constraints, const Nodes& way, double tau);

  model::Material material_;
  model::AreaConstraint area_;
  int nodes_, quadratic_nodes_, multipliers_;
  Ranks ranks_;
  std::variant<Monolithic, Split> scheme_;
  FlowLayout layout_;
  LinearSystem flow_;
  Field lipids_;                     // what is subtracted of it, empty: nothing
  bool has_moment_;                  // of an area difference
  Eigen::VectorXd total_area_rate_;  // by element, under a global area constraint
  Nodes node_normals_;               // 3 x nodes, of the old surface
};

}  // namespace sbeh::surface3d
