#include "surface3d/linear/sparse_pattern.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace sbeh::surface3d {

namespace {
// For each row the (element, local row) that contribute to it.
struct Contribution {
  int element, local;
};
std::vector<std::vector<Contribution>> contributions_of(int size, const Eigen::MatrixXi& unknowns) {
  std::vector<std::vector<Contribution>> rows(static_cast<std::size_t>(size));
  for (int e = 0; e < unknowns.cols(); ++e)
    for (int i = 0; i < unknowns.rows(); ++i) rows[std::size_t(unknowns(i, e))].push_back({e, i});
  return rows;
}
}  // namespace

SparsePattern::SparsePattern(int size, Eigen::MatrixXi unknowns, Mask couples, int common,
                             std::vector<int> places)
    : size_(size), common_(common), places_(std::move(places)), unknowns_(std::move(unknowns)) {
  const int locals = int(unknowns_.rows());
  std::vector<int> first_pair;  // of each local row
  std::vector<int> order(
      static_cast<std::size_t>(locals));  // what is near in memory one after the other
  std::iota(order.begin(), order.end(), 0);
  if (elements() > 0)
    std::ranges::sort(order, {}, [&](int j) { return std::pair(unknowns_(j, 0), j); });
  for (int i = 0; i < locals; ++i) {
    first_pair.push_back(int(pairs_.size()));
    for (const int j : order)
      if (couples(i, j)) pairs_.push_back({i, j});
  }
  first_pair.push_back(int(pairs_.size()));

  positions_.resize(pairs_.size() * std::size_t(elements()));
  row_start_.push_back(0);
  std::vector<int> place(std::size_t(size), -1);  // of a column in the current row
  std::vector<int> columns;
  const auto rows = contributions_of(size, unknowns_);
  for (int row = 0; row < size; ++row) {
    const auto& contributions = rows[std::size_t(row)];
    columns.clear();
    for (const auto& [e, i] : contributions)
      for (int k = first_pair[std::size_t(i)]; k < first_pair[std::size_t(i) + 1]; ++k)
        columns.push_back(unknowns_(pairs_[std::size_t(k)].column, e));
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    const int start = row_start_.back();
    for (std::size_t k = 0; k < columns.size(); ++k)
      place[std::size_t(columns[k])] = start + int(k);
    for (const auto& [e, i] : contributions)
      for (int k = first_pair[std::size_t(i)]; k < first_pair[std::size_t(i) + 1]; ++k)
        positions_[std::size_t(e) * pairs_.size() + std::size_t(k)] =
            place[std::size_t(unknowns_(pairs_[std::size_t(k)].column, e))];
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    row_start_.push_back(int(columns_.size()));
  }
  if (common_ > 0) leave_out_common_pairs();
}

void SparsePattern::leave_out_common_pairs() {
  const int first = int(unknowns_.rows()) - common_;
  const auto is_common = [&](const Pair& pair) {
    return pair.row >= first && pair.column >= first;
  };
  std::size_t kept = 0;
  for (std::size_t k = 0; k < positions_.size(); ++k)
    if (!is_common(pairs_[k % pairs_.size()])) positions_[kept++] = positions_[k];
  positions_.resize(kept);
  std::erase_if(pairs_, is_common);
}

SparseMatrix SparsePattern::zero() const {
  SparseMatrix A(size_, size_);
  A.resizeNonZeros(Eigen::Index(columns_.size()));
  std::copy(row_start_.begin(), row_start_.end(), A.outerIndexPtr());
  std::copy(columns_.begin(), columns_.end(), A.innerIndexPtr());
  std::fill_n(A.valuePtr(), columns_.size(), 0.);
  return A;
}

void SparsePattern::set_zero(LinearSystem& system) const {
  if (system.matrix.rows() == 0) system.matrix = zero();
  std::fill_n(system.matrix.valuePtr(), system.matrix.nonZeros(), 0.);
  system.rhs.setZero(size_);
}

}  // namespace sbeh::surface3d
