#include "surface3d/linear/bordered.h"

#include <algorithm>

namespace sbeh::surface3d {

void set_bordered(const SparseMatrix& A, const Eigen::MatrixXd& B, const Eigen::VectorXd& D,
                  SparseMatrix& bordered) {
  const Eigen::Index n = A.rows(), m = B.cols();
  bordered.resize(n + m, n + m);
  bordered.resizeNonZeros(A.nonZeros() + n * m + D.size());
  std::copy_n(A.outerIndexPtr(), n + 1, bordered.outerIndexPtr());
  std::copy_n(A.innerIndexPtr(), A.nonZeros(), bordered.innerIndexPtr());
  std::copy_n(A.valuePtr(), A.nonZeros(), bordered.valuePtr());
  Eigen::Index position = A.nonZeros();
  for (Eigen::Index k = 0; k < m; ++k) {
    for (Eigen::Index i = 0; i < n; ++i, ++position) {
      bordered.innerIndexPtr()[position] = int(i);
      bordered.valuePtr()[position] = B(i, k);
    }
    if (k < D.size()) {
      bordered.innerIndexPtr()[position] = int(n + k);
      bordered.valuePtr()[position++] = D[k];
    }
    bordered.outerIndexPtr()[n + k + 1] = int(position);
  }
}

}  // namespace sbeh::surface3d
