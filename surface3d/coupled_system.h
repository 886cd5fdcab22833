// The coupled step of model/equations.md as sparse linear systems.
//
// `monolithic`: all of V, p, H, Y, λ at once. `split`: the nodes move along their normals by the normal
// part of τV. With this displacement in the curvature equation (H1), tested along the node normals,
// V, p, H, λ stand alone; the tangential part of Y follows from (H1), tested tangentially, with these V
// and H, and then the normal part, but little different from that of τV, from (Y1). Both schemes have the
// same states of rest, and differ in motion by the order of the method in τ. Both are cut from the same
// element matrices.
//
// The mesh does not jump to its own equilibrium within one step, but moves there at a finite rate: with
// θ = τ/(τ + mesh_relaxation_time) the right-hand side of (H1) is −θ(∇_C X, ∇_C Z) + (1 − θ)(H ν, Z), H that
// of the old surface. (X are the positions from which the displacement Y counts: the old ones but for
// two-step methods, and H is theirs on the old surface.) Along the normals this is nothing new; Y/τ has a
// limit for τ → 0, and errors in time are those of a smooth motion.
//
// Without friction the rigid motions R cost nothing: six more multipliers make (R, V) = 0.
//
// Under a global area constraint the same element matrices are restricted: to velocities and test
// fields along the node normals, one speed v for each node, and to a number as pressure.
#pragma once

#include "surface3d/element_system.h"
#include "surface3d/system_layout.h"

#include <array>
#include <vector>

namespace sbeh::surface3d {

/// Not much below the time steps: where the mesh settles within one step, two-step methods, which
/// extrapolate it, do not.
inline constexpr double mesh_relaxation_time = 0.02;

struct LinearSystem {
  SparseMatrix matrix;
  Eigen::VectorXd rhs;
};

/// The positions from which the displacement Y counts, 3 x nodes, and their curvature on the surface of
/// the step, see mean_curvature.
struct Origin {
  const Nodes& X;
  const Field& H;
};

/// What a step keeps besides the equations at points.
struct Constraints {
  double area_rate;    ///< (A₀ − A)/(τA) of (P1)
  double volume_rate;  ///< (V₀ − V)/τ of (P2)
  bool keep_volume;  ///< false on a sphere, where a constant p and λ are one unknown: then λ = 0
};

/// Assembles the systems of a step; keeps their structure and memory.
class CoupledSystem {
 public:
  CoupledSystem(const Triangulation& mesh, const model::Material& material, Scheme scheme,
                model::AreaConstraint area = model::AreaConstraint::local);

  /// Fills the systems from the old state; elements in parallel, sums in a fixed order.
  void assemble(const Triangulation& mesh, const State& old, const Curvature& curvature,
                const Origin& from, double tau, const Constraints& constraints);

  /// V, p, H, when monolithic Y, and λ; or, under a global area constraint, v, H, Y, λ and p.
  const LinearSystem& flow() const { return flow_; }
  /// The tangential part of Y by two components for each node, symmetric and positive definite; only when
  /// split. The right-hand side lacks what depends on the flow, see motion_rhs.
  const LinearSystem& motion() const { return motion_; }
  /// The whole right-hand side of `motion`, for a solution of `flow`.
  Eigen::VectorXd motion_rhs(const Eigen::VectorXd& flow) const;

  Scheme scheme() const { return scheme_; }
  // Parts of a solution of `flow`:
  Nodes velocity(const Eigen::VectorXd& flow) const;   // 3 x nodes
  Field pressure(const Eigen::VectorXd& flow) const;   // P2 nodes
  Field curvature(const Eigen::VectorXd& flow) const;  // nodes
  double lambda(const Eigen::VectorXd& flow) const { return flow[first_multiplier()]; }
  /// Y, 3 x nodes, NaN where the surface is too degenerate for (Y1); `motion` is not read when monolithic.
  Nodes displacement(const Eigen::VectorXd& flow, const Eigen::VectorXd& motion) const;
  /// Multiplies the displacements of these solutions by a factor.
  void scale_displacements(double factor, Eigen::VectorXd& flow, Eigen::VectorXd& motion) const;

 private:
  struct ElementMesh;
  struct Piece;
  void cut_flow(const ElementMesh& mesh, bool keep_volume, const ElementSystem& element,
                Piece& piece) const;
  void cut_monolithic(const ElementMesh& mesh, const ElementSystem& element, Piece& piece) const;
  void cut_split(const ElementMesh& mesh, const ElementSystem& element, Piece& piece) const;
  void set_frames(const Nodes& n);
  void add_flow(int e, const ElementMesh& mesh, Piece& piece);
  void add_motion(int e, const ElementMesh& mesh, const ElementSystem& element);
  bool along_normals() const { return area_ == model::AreaConstraint::global; }
  // Where H and λ begin among the unknowns of the flow:
  int first_curvature() const;
  int first_displacement() const;  // when monolithic
  Field normal_speed(const Eigen::VectorXd& flow) const;
  /// Calls visit(nodes of the triangle, its matrices, its part of the sum), and adds the parts up.
  template <class Sum, class Visit>
  void add_up(Sum& sum, Visit&& visit) const;
  int first_multiplier() const;

  model::Material material_;
  Scheme scheme_;
  model::AreaConstraint area_;
  int nodes_, quadratic_nodes_, multipliers_;
  SparsePattern flow_pattern_, motion_pattern_;
  LinearSystem flow_, motion_;
  double tau_ = 0;
  Eigen::VectorXd total_area_rate_;  // by element, under a global area constraint
  Nodes normals_;                    // 3 x nodes, of the old surface
  std::array<Nodes, 2> tangents_;    // 3 x nodes, unit, orthogonal to each other and to the normals
  // Of (Y1) for displacements along the node normals: (n_b·ν φ_b, φ_a).
  SparseMatrix normal_flux_;
  std::vector<MeshMatrices> mesh_matrices_;  // by element, when split
};

}  // namespace sbeh::surface3d
