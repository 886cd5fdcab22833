// The coupled step on one triangle.
#pragma once

#include "surface3d/mesh_equation.h"
#include "surface3d/weak_form.h"

namespace sbeh::surface3d {

/// V, p, H as in FlowPiece, but p padded from six numbers to the ten that each component of the others has.
namespace padded {
inline constexpr int V = FlowPiece::V, p = FlowPiece::p, H = p + 10, size = H + 10, tests = H;
}

/// The parts of the coupled step on a triangle.
struct ElementSystem {
  Eigen::Matrix<double, padded::tests, padded::size> flow;  // row: test function, column: unknown
  Eigen::Matrix<double, padded::tests, 1> rhs;
  /// What the multipliers meet: (ν, W) of (V4) and (P2), then (R, W) of the rigid motions R: three
  /// translations, three rotations about the axes.
  Eigen::Matrix<double, 30, 7> constraints;
  MeshEquation mesh;
};

/// What a triangle has of the old state.
struct ElementState {
  ElementNodes X, normals;
  ElementField beta, H;
};

/// Sums over the quadrature points, of the linear `flow_point` among others.
void assemble_element(const model::Material& material, const ElementState& old,
                      const StepParameters& step, ElementSystem& out);

}  // namespace sbeh::surface3d
