// The coupled step of model/equations.md as sparse linear systems.
//
// `monolithic`: all of V, p, H, Y at once. `split`: Y = τV in the curvature equation (H1), tested along
// the node normals, leaves V, p, H; the mesh motion (Y1), (H1) with the velocity known follows. Both have
// the same states of rest, and differ by O(τ) in motion. Both come from the same element matrices.
#pragma once

#include "surface3d/curvature.h"
#include "surface3d/sparse_pattern.h"
#include "surface3d/weak_form.h"

#include <array>

namespace sbeh::surface3d {

enum class Scheme { split, monolithic };

/// A linear system without its border.
struct LinearSystem {
  SparseMatrix matrix;
  Eigen::VectorXd rhs;
};

/// Assembles the systems of a step; keeps their structure and memory.
class CoupledSystem {
 public:
  CoupledSystem(const Triangulation& mesh, Scheme scheme);

  /// Fills the systems from the old state; elements in parallel, sums in a fixed order.
  void assemble(const Triangulation& mesh, const model::Material& material, const State& old,
                const Curvature& curvature, const StepParameters& step);

  /// V, p, H and, when monolithic, Y.
  const LinearSystem& flow() const { return flow_; }
  /// η and Y; only when split. Its right-hand side lacks τ(V·ν, G).
  const LinearSystem& motion() const { return motion_; }
  /// (ν, W) over the unknowns of `flow`: the column of (V4) and the row of (P2).
  const Eigen::VectorXd& normal_flux() const { return normal_flux_; }
  /// −τ(V·ν, G) for a velocity, to be taken from the right-hand side of `motion`.
  Eigen::VectorXd minus_normal_motion(const Nodes& V) const;

  Scheme scheme() const { return scheme_; }
  Nodes velocity(const Eigen::VectorXd& flow) const;      // 3 x nodes
  Field pressure(const Eigen::VectorXd& flow) const;      // P2 nodes
  Field curvature(const Eigen::VectorXd& flow) const;     // nodes
  /// Of the solution of `motion`, or of `flow` when monolithic.
  Nodes displacement(const Eigen::VectorXd& solution) const;  // 3 x nodes
  int velocity_unknown(int node, int component) const { return 3 * node + component; }

 private:
  Scheme scheme_;
  int nodes_, quadratic_nodes_;
  SparsePattern flow_pattern_, motion_pattern_;
  LinearSystem flow_, motion_;
  Eigen::VectorXd normal_flux_;
  // −τ(V·ν, G) by element: 10 G x 30 V
  std::vector<Eigen::Matrix<double, 10, 30>> normal_motion_;
};

}  // namespace sbeh::surface3d
