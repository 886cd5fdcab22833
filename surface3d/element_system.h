// The coupled step on one triangle.
#pragma once

#include "surface3d/curvature.h"
#include "surface3d/weak_form.h"

#include <array>

namespace sbeh::surface3d {

/// Where the unknowns of a triangle stand: V_x V_y V_z, p (six, padded to ten), H, Y_x Y_y Y_z, ten
/// numbers each. The test functions W, q, G, Z stand in the rows of the same numbers.
namespace local {
inline constexpr int V = 0, p = 30, H = 40, Y = 50, size = 80;
}

/// Matrix (row: test function, column: unknown), right-hand side, and what the multipliers meet:
/// (ν, W), then (R, W) of the rigid motions R: three translations, three rotations about the axes.
struct ElementSystem {
  Eigen::Matrix<double, local::size, local::size> matrix;
  Eigen::Matrix<double, local::size, 1> rhs;
  Eigen::Matrix<double, 30, 7> constraints;
};

/// What a triangle has of the old state; `from` are the positions from which Y counts.
struct ElementState {
  ElementNodes X, from, normals;
  ElementField beta, H;
};

/// Sum over the quadrature points of the linear `coupled_step_point`.
void assemble_element(const model::Material& material, const ElementState& old,
                      const StepParameters& step, ElementSystem& out);

}  // namespace sbeh::surface3d
