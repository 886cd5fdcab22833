// Where the entries of element matrices go in a sparse matrix.
#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace sbeh::surface3d {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct LinearSystem {
  SparseMatrix matrix;
  Eigen::VectorXd rhs;
};

/// The structure of a square matrix that is a sum over elements, found once and filled many times.
class SparsePattern {
 public:
  using Mask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

  /// unknowns: local unknowns x elements, the global index of each; couples: local x local, which
  /// entries (row, column) of an element matrix can be other than zero. The last `common` local unknowns
  /// are the same in all elements: their entries among themselves are part of the structure, but `add`
  /// leaves them out, so that elements without a node in common add to different numbers. `places`, where
  /// there are any: of each element the column of `unknowns` that is its own, −1: it has no part in the matrix.
  SparsePattern(int size, Eigen::MatrixXi unknowns, Mask couples, int common = 0,
                std::vector<int> places = {});

  int size() const { return size_; }
  int elements() const { return int(unknowns_.cols()); }

  /// A matrix of this structure, all zero.
  SparseMatrix zero() const;
  /// A system of this structure, or one that is to become that, is all zero then.
  void set_zero(LinearSystem& system) const;

  /// A += the matrix (local x local) of an element; what the mask excludes is left out, and what the
  /// common unknowns have among themselves.
  template <class Local>
  void add(int element, const Local& local, SparseMatrix& A) const {
    const int* position = positions_.data() + std::size_t(place(element)) * pairs_.size();
    double* values = A.valuePtr();
    for (const auto& [i, j] : pairs_) values[*position++] += local(i, j);
  }
  /// rhs += the vector of an element, but for the common unknowns.
  template <class Local>
  void add(int element, const Local& local, Eigen::VectorXd& rhs) const {
    for (int i = 0; i < int(unknowns_.rows()) - common_; ++i)
      rhs[unknowns_(i, place(element))] += local[i];
  }

 private:
  struct Pair {
    int row, column;
  };
  void leave_out_common_pairs();
  int place(int element) const { return places_.empty() ? element : places_[std::size_t(element)]; }

  int size_, common_;
  std::vector<int> places_;
  Eigen::MatrixXi unknowns_;
  std::vector<Pair> pairs_;     // the entries of an element matrix that are added
  std::vector<int> positions_;  // pairs x elements: where they are in the values of the matrix
  std::vector<int> row_start_, columns_;
};

}  // namespace sbeh::surface3d
