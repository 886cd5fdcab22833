// The coupled step on one triangle.
#pragma once

#include "surface3d/curvature.h"
#include "surface3d/weak_form.h"

#include <array>

namespace sbeh::surface3d {

/// Where the unknowns of the flow on a triangle stand: V_x V_y V_z, p (six, padded to ten), H, ten numbers
/// each. The test functions W, q stand in the rows of the same numbers; those of H are zero.
namespace local {
inline constexpr int V = 0, p = 30, H = 40, size = 50;
}

/// Of (Y1) and (H1) on a triangle.
struct MeshMatrices {
  using Scalar = Eigen::Matrix<double, 10, 10>;
  std::array<Scalar, 3> normal_mass;  ///< (ν_k φ_a, φ_b)
  Scalar stiffness;                   ///< (∇φ_a, ∇φ_b)
};

/// The parts of the coupled step on a triangle.
struct ElementSystem : MeshMatrices {
  Eigen::Matrix<double, local::size, local::size> flow;  // row: test function, column: unknown
  Eigen::Matrix<double, local::size, 1> rhs;
  /// What the multipliers meet: (ν, W), then (R, W) of the rigid motions R: three translations, three
  /// rotations about the axes.
  Eigen::Matrix<double, 30, 7> constraints;
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
