// Conjugate gradients for mass matrices, which are well conditioned: a few dozen iterations lead to rounding.
#pragma once

#include "surface3d/linear/sparse_pattern.h"

namespace sbeh::surface3d {

/// Solves with a symmetric positive definite matrix, whose diagonal preconditions; NaN where that fails.
Eigen::VectorXd solve_mass(const SparseMatrix& mass, const Eigen::VectorXd& rhs,
                           const Eigen::VectorXd& guess);
/// The same for three right-hand sides, the rows, for which the matrix is read once.
Eigen::Matrix3Xd solve_mass(const SparseMatrix& mass, const Eigen::Matrix3Xd& rhs,
                            const Eigen::Matrix3Xd& guess);

}  // namespace sbeh::surface3d
