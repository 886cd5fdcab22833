// The coupled step on one triangle.
#pragma once

#include "surface3d/mesh_equation.h"
#include "surface3d/weak_form.h"

namespace sbeh::surface3d {

/// The parts of the coupled step on a triangle.
struct ElementSystem {
  static constexpr int tests = FlowPiece::H, unknowns = FlowPiece::Y;
  /// In the order of FlowPiece; row: test function W, q, column: unknown V, p, H.
  Eigen::Matrix<double, tests, unknowns> flow;
  Eigen::Matrix<double, tests, 1> rhs;
  /// What the multipliers meet: (ν, W_n) of (V4) and (P2), then (R, W) of the rigid motions R: three
  /// translations, three rotations about the axes.
  Eigen::Matrix<double, 30, 7> constraints;
  Eigen::Matrix<double, 30, 1> moment;  ///< W_n in (V13) and (P3), with an area difference
  MeshEquation mesh;
};

/// What a triangle has of the old state.
struct ElementState {
  ElementNodes X, node_normals, projected_normals;
  ElementField beta, H, order_force;
};

/// Sums over the quadrature points; `area_rate` is (A₀ − A)/(τA), the drift correction of (P1), which has not what the order does to the
/// area of lipids.
void assemble_element(const model::Material& material, const ElementState& old, double area_rate,
                      ElementSystem& out);

}  // namespace sbeh::surface3d
