// The generic contraction Tᵀ D B: from pointwise derivatives of a weak form to element matrices.
//
// A weak form is a pointwise function from data d (values and derivatives of the unknowns at a
// point) to the factors g of values and derivatives of the test functions. With d = B u, B and T the
// shape functions of unknowns and tests, the element residual is ∫ Tᵀ g, its derivative ∫ Tᵀ (∂g/∂d) B.
#pragma once

#include <Eigen/Core>

#include <array>

namespace sbeh::model {

/// One entry of the pointwise data: which element unknowns it reads, through which shape values; or of
/// the factors: which tests it meets.
template <int Count>
struct DataRow {
  int first;            ///< the first of the Count consecutive element unknowns it reads, or tests
  const double* shape;  ///< Count numbers: φ_i or one of its derivatives at the point
};
template <int Count>
using ShapeMap = Eigen::Map<const Eigen::Matrix<double, Count, 1>>;

/// A matrix of Rows x Columns blocks of Count x Count, those that are met in memory one after the other,
/// and their columns filled up to whole vector registers: for sums of many outer products.
template <int Count, int Rows, int Columns>
class BlockMatrix {
 public:
  static constexpr int padded = (Count + 7) / 8 * 8;
  using Column = Eigen::Matrix<double, padded, 1>;
  static Column column(const double* shape, double weight) {
    Column filled;
    for (int a = 0; a < padded; ++a) filled[a] = a < Count ? weight * shape[a] : 0;
    return filled;
  }

  void set_zero() { met_.fill(false); }
  /// The block whose first row and column these are += test trialᵀ, of Count numbers or fewer.
  template <class Trial>
  void add_outer(int row, int column, const Column& test, const Trial& trial) {
    const std::size_t k = index(row / Count, column / Count);
    if (!met_[k]) blocks_[k].setZero();
    met_[k] = true;
    blocks_[k].template leftCols<Trial::RowsAtCompileTime>().noalias() += test * trial.transpose();
  }
  Eigen::Matrix<double, Count * Rows, Count * Columns> dense() const {
    Eigen::Matrix<double, Count * Rows, Count * Columns> all;
    for (int j = 0; j < Columns; ++j)
      for (int i = 0; i < Rows; ++i)
        if (met_[index(i, j)])
          all.template block<Count, Count>(Count * i, Count * j) =
              blocks_[index(i, j)].template topRows<Count>();
        else
          all.template block<Count, Count>(Count * i, Count * j).setZero();
    return all;
  }
  /// The symmetric matrix of which these are the blocks on its diagonal and above.
  auto symmetric() const {
    auto all = dense();
    for (int j = 0; j < Columns; ++j)
      for (int i = 0; i < j; ++i)
        all.template block<Count, Count>(Count * j, Count * i) =
            all.template block<Count, Count>(Count * i, Count * j).transpose();
    return all;
  }

 private:
  static constexpr std::size_t index(int i, int j) {
    return std::size_t(j) * std::size_t(Rows) + std::size_t(i);
  }
  std::array<Eigen::Matrix<double, padded, Count>, std::size_t(Rows* Columns)> blocks_;
  std::array<bool, std::size_t(Rows* Columns)> met_{};
};

/// A dense matrix as a sum of outer products in the same way.
template <int Count, class Matrix>
struct OuterProducts {
  Matrix& sum;
  static Eigen::Matrix<double, Count, 1> column(const double* shape, double weight) {
    return weight * ShapeMap<Count>(shape);
  }
  template <class Test, class Trial>
  void add_outer(int row, int column, const Test& test, const Trial& trial) {
    sum.template block<Count, Count>(row, column).noalias() += test * trial.transpose();
  }
};
template <int Count, class Matrix>
OuterProducts<Count, Matrix> outer_products(Matrix& matrix) {
  return {matrix};
}
template <int Count, int Rows, int Columns>
BlockMatrix<Count, Rows, Columns>& outer_products(BlockMatrix<Count, Rows, Columns>& matrix) {
  return matrix;
}

/// Which blocks of a matrix are added to: all, or those of a symmetric one on its diagonal and above.
enum class Blocks { all, upper };

/// matrix += weight · Tᵀ D B.  D: factors x data, row = test, column = unknown. Its zeros cost nothing, and
/// data that read the same unknowns are combined before they meet the test functions.
template <Blocks blocks = Blocks::all, int Count, std::size_t Factors, std::size_t Data,
          class Derivative, class Matrix>
void add_matrix(const std::array<DataRow<Count>, Factors>& T,
                const std::array<DataRow<Count>, Data>& B, const Derivative& D, double weight,
                Matrix& matrix) {
  using Shape = Eigen::Matrix<double, Count, 1>;
  std::array<std::size_t, Data> leader;  // the first data row of the same unknowns
  for (std::size_t j = 0; j < Data; ++j)
    for (leader[j] = 0; B[leader[j]].first != B[j].first;) ++leader[j];
  std::array<Shape, Data> trial;
  auto&& sum = outer_products<Count>(matrix);
  for (std::size_t i = 0; i < Factors; ++i) {
    std::array<bool, Data> met{};
    for (std::size_t j = 0; j < Data; ++j) {
      const double value = D(Eigen::Index(i), Eigen::Index(j));
      if (value == 0 || (blocks == Blocks::upper && B[j].first < T[i].first)) continue;
      const std::size_t k = leader[j];
      if (met[k])
        trial[k] += value * ShapeMap<Count>(B[j].shape);
      else
        trial[k] = value * ShapeMap<Count>(B[j].shape);
      met[k] = true;
    }
    const auto test = sum.column(T[i].shape, weight);
    for (std::size_t k = 0; k < Data; ++k)
      if (met[k]) sum.add_outer(T[i].first, B[k].first, test, trial[k]);
  }
}

/// vector += weight · Tᵀ g.  g: factors.
template <int Count, std::size_t Factors, class Coefficients, class Vector>
void add_vector(const std::array<DataRow<Count>, Factors>& T, const Coefficients& g, double weight,
                Vector& vector) {
  for (std::size_t i = 0; i < Factors; ++i)
    vector.template segment<Count>(T[i].first) +=
        weight * g[Eigen::Index(i)] * ShapeMap<Count>(T[i].shape);
}

}  // namespace sbeh::model
