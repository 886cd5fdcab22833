// A symmetric matrix with a few dense rows and columns around it.
#pragma once

#include "surface3d/linear/sparse_pattern.h"

namespace sbeh::surface3d {

/// The lower half of [A B; Bᵀ D], all of A included: n x n, B n x m, D diagonal, of no more than m entries, the others 0. Its
/// structure is that of A, m and the number of these.
void set_bordered(const SparseMatrix& A, const Eigen::MatrixXd& B, const Eigen::VectorXd& D,
                  SparseMatrix& bordered);

}  // namespace sbeh::surface3d
