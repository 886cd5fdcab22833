// A symmetric matrix with a few dense rows and columns around it.
#pragma once

#include "surface3d/linear/sparse_pattern.h"

namespace sbeh::surface3d {

/// The lower half of [A B; Bᵀ 0], all of A included: n x n, B n x m. Its structure is that of A and m.
void set_bordered(const SparseMatrix& A, const Eigen::MatrixXd& B, SparseMatrix& bordered);

}  // namespace sbeh::surface3d
