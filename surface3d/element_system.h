// The coupled step on one triangle.
#pragma once

#include "surface3d/mesh_equation.h"
#include "surface3d/weak_form.h"

namespace sbeh::surface3d {

/// Where the unknowns of the flow on a triangle stand: V_x V_y V_z, p (six, padded to ten), H, ten numbers
/// each. The test functions W and q stand in the rows of the numbers of V and p.
namespace local {
inline constexpr int V = 0, p = 30, H = 40, size = 50, tests = 40;
}

/// The parts of the coupled step on a triangle.
struct ElementSystem {
  Eigen::Matrix<double, local::tests, local::size> flow;  // row: test function, column: unknown
  Eigen::Matrix<double, local::tests, 1> rhs;
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
