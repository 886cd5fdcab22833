// How the mesh moves, and what its curvature is: (Y1) and (H1) of model/equations.md on a triangle.
//
//   ( Y·ν, G ) − τ ( V_n·ν, G ) = 0                                                (Y1)
//   ( H ν, Z ) + ( ∇_C Y, ∇_C Z ) = −θ ( ∇_C x̂, ∇_C Z ) + (1 − θ) ( Ĥ ν, Z )      (H1)
//
// x̂ are the positions from which the displacement Y counts (the old ones but for two-step methods), Ĥ is
// their curvature on the old surface (`from`, `H_from`), and θ is that of model/mesh_motion.h: the mesh does not jump to its
// own equilibrium within one step, but moves there at a finite rate. Along the normals this is nothing new;
// Y/τ has a limit for τ → 0, and errors in time are those of a smooth motion.
//
// Without Y, tested along the node normals, (H1) is the curvature of given positions: see curvature.cpp.
#pragma once

#include "model/numerics/contraction.h"
#include "surface3d/system_layout.h"

#include <array>

namespace sbeh::surface3d {

/// What the mesh equations read of a triangle besides its forms.
struct MovingTriangle {
  int e;
  double tau;
  ElementNodes X, node_normals;  ///< of the old surface
  ElementNodes from;             ///< the positions from which Y counts
  ElementField H_from;           ///< their curvature
};

/// The forms that (Y1) and (H1) are made of, as MeshSums has them. Fields are given by their nodes, results by the nodes of the
/// test functions.
struct MeshEquation {
  using Scalar = Eigen::Matrix<double, 10, 10>;  // row: test function, column: unknown
  std::array<Scalar, 3> normal_mass;             ///< (ν_k φ_b, φ_a)
  Scalar stiffness;                              ///< (∇φ_b, ∇φ_a)

  Eigen::Matrix<double, 1, 10> normal_flux(const ElementNodes& W) const;  ///< (W·ν, G)
  /// ( H ν, Z ) + ( ∇_C Y, ∇_C Z ): the left-hand side of (H1).
  ElementNodes mesh_force(const ElementField& H, const ElementNodes& Y) const;
  /// The right-hand side of (H1).
  ElementNodes mesh_drive(const MovingTriangle& t) const;
  /// Both as they stand, in the rows G and Z of the flow.
  void set_rows(const MovingTriangle& t, FlowPiece& piece) const;

  // (H1) tested with Z = φ_a t_a, t unit vectors at the nodes:
  Scalar normal_mass_along(const ElementNodes& t) const;  ///< (φ_b ν, φ_a t_a)
  /// (∇(φ_b u_b), ∇(φ_a t_a))
  Scalar stiffness_between(const ElementNodes& t, const ElementNodes& u) const;
};

/// Sums over the quadrature points.
class MeshSums {
 public:
  void add(const SurfacePoint& x, const Shapes& phi);
  MeshEquation equation() const;

 private:
  model::BlockMatrix<10, 1, 4> sums_;  // the normal masses, the stiffness
};

}  // namespace sbeh::surface3d
