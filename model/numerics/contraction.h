// The generic contraction Bᵀ D B: from pointwise derivatives of a weak form to element matrices.
//
// A weak form is a pointwise function from data d (values and derivatives of the unknowns at a
// point) to coefficients g of the same values and derivatives of the test functions. With d = B u,
// B the shape functions, the element residual is ∫ Bᵀ g and its derivative ∫ Bᵀ (∂g/∂d) B.
#pragma once

#include <Eigen/Core>

#include <array>

namespace sbeh::model {

/// One entry of the pointwise data: which element unknowns it reads, through which shape values.
template <int Count>
struct DataRow {
  int first;            ///< the first of the Count consecutive element unknowns it reads
  const double* shape;  ///< Count numbers: φ_i or one of its derivatives at the point
};
template <int Count>
using ShapeMap = Eigen::Map<const Eigen::Matrix<double, Count, 1>>;

/// matrix += weight · Bᵀ D B.  D: data x data, row = test, column = unknown.
template <int Count, std::size_t Data, class Derivative, class Matrix>
void add_matrix(const std::array<DataRow<Count>, Data>& B, const Derivative& D, double weight,
                Matrix& matrix) {
  for (std::size_t j = 0; j < Data; ++j)
    for (std::size_t i = 0; i < Data; ++i) {
      const double value = weight * D(Eigen::Index(i), Eigen::Index(j));
      if (value == 0) continue;
      const Eigen::Matrix<double, Count, 1> test = value * ShapeMap<Count>(B[i].shape);
      for (int b = 0; b < Count; ++b)
        matrix.col(B[j].first + b).template segment<Count>(B[i].first) += B[j].shape[b] * test;
    }
}

/// vector += weight · Bᵀ g.  g: data.
template <int Count, std::size_t Data, class Coefficients, class Vector>
void add_vector(const std::array<DataRow<Count>, Data>& B, const Coefficients& g, double weight,
                Vector& vector) {
  for (std::size_t i = 0; i < Data; ++i)
    vector.template segment<Count>(B[i].first) +=
        weight * g[Eigen::Index(i)] * ShapeMap<Count>(B[i].shape);
}

}  // namespace sbeh::model
