#include "surface3d/linear/direct_solver.h"

#include <dmumps_c.h>
#include <metis.h>
#include <smumps_c.h>

#include <cassert>
#include <cmath>
#include <vector>

namespace sbeh::surface3d {

namespace {

// A row with more entries than this is a multiplier's: eliminated last, and no part of the graph.
constexpr Eigen::Index dense_row = 1000;

// The place of each unknown in the order of elimination, counted from 1: nested dissection by METIS,
// a function of the structure alone.
std::vector<int> elimination_order(const SparseMatrix& matrix) {
  const SparseMatrix A = matrix + SparseMatrix(matrix.transpose());  // of symmetric structure
  const Eigen::Index n = A.rows();
  std::vector<int> number(std::size_t(n), -1);  // in the graph
  idx_t vertices = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    if (A.innerVector(i).nonZeros() <= dense_row) number[std::size_t(i)] = vertices++;
  std::vector<idx_t> start{0}, neighbours, order(std::size_t(vertices), 0), place(order);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (number[std::size_t(i)] < 0) continue;
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      if (entry.col() != i && number[std::size_t(entry.col())] >= 0)
        neighbours.push_back(number[std::size_t(entry.col())]);
    start.push_back(idx_t(neighbours.size()));
  }
  if (vertices > 0)
    METIS_NodeND(&vertices, start.data(), neighbours.data(), nullptr, nullptr, order.data(),
                 place.data());
  std::vector<int> positions;
  positions.reserve(number.size());
  int last = vertices;
  for (const int vertex : number)
    positions.push_back(1 + (vertex >= 0 ? place[std::size_t(vertex)] : last++));
  return positions;
}

}  // namespace

class DirectSolver::Factors {
 public:
  virtual ~Factors() = default;
  virtual bool factor(const SparseMatrix& A) = 0;
  virtual void solve(Eigen::Ref<Eigen::MatrixXd>& rhs) = 0;
  virtual double flops() const = 0;
  virtual double entries() const = 0;
  virtual int negative_eigenvalues() const = 0;
};

namespace {

template <class Number>
struct Library;
template <>
struct Library<double> {
  using Data = DMUMPS_STRUC_C;
  static void call(Data& data) { dmumps_c(&data); }
};
template <>
struct Library<float> {
  using Data = SMUMPS_STRUC_C;
  static void call(Data& data) { smumps_c(&data); }
};

}  // namespace

template <class Number>
class DirectSolver::Mumps : public Factors {
 public:
  explicit Mumps(Symmetry symmetry) : symmetric_(symmetry == Symmetry::symmetric) {
    id_.par = 1;
    id_.sym = symmetric_ ? 2 : 0;
    id_.comm_fortran = -987654;  // MPI_COMM_WORLD of the sequential library
    run(-1);
    for (const int stream : {1, 2, 3}) control(stream) = -1;
    control(4) = 0;    // silent
    control(6) = 0;    // no permutation by values: the analysis sees the structure alone
    control(7) = 1;    // our ordering
    control(14) = 60;  // per cent of memory more than estimated, for pivoting
  }
  ~Mumps() override { run(-2); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  bool factor(const SparseMatrix& A) override;
  void solve(Eigen::Ref<Eigen::MatrixXd>& rhs) override;

  double flops() const override { return double(id_.rinfog[2]); }
  double entries() const override {
    const int entries = id_.infog[28];
    return entries < 0 ? -1e6 * entries : entries;  // large numbers are given in millions
  }
  int negative_eigenvalues() const override { return id_.infog[11]; }

 private:
  // MUMPS's manual counts from 1.
  int& control(int i) { return id_.icntl[i - 1]; }
  bool run(int job) {
    id_.job = job;
    Library<Number>::call(id_);
    return id_.infog[0] >= 0;
  }
  bool stored(Eigen::Index row, Eigen::Index column) const { return !symmetric_ || column <= row; }
  void set_structure(const SparseMatrix& A);
  void set_values(const SparseMatrix& A);

  typename Library<Number>::Data id_{};
  bool symmetric_, analysed_ = false;
  std::vector<int> rows_, columns_, order_;
  std::vector<Number> values_;
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> rhs_;
};

template <class Number>
void DirectSolver::Mumps<Number>::set_structure(const SparseMatrix& A) {
  rows_.clear();
  columns_.clear();
  for (Eigen::Index i = 0; i < A.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      if (stored(i, entry.col())) {
        rows_.push_back(int(i) + 1);
        columns_.push_back(int(entry.col()) + 1);
      }
  values_.resize(rows_.size());
  id_.n = int(A.rows());
  id_.nnz = MUMPS_INT8(rows_.size());
  id_.irn = rows_.data();
  id_.jcn = columns_.data();
  id_.a = values_.data();
  order_ = elimination_order(A);
  id_.perm_in = order_.data();
}

template <class Number>
void DirectSolver::Mumps<Number>::set_values(const SparseMatrix& A) {
  auto value = values_.begin();
  for (Eigen::Index i = 0; i < A.outerSize(); ++i)
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      if (stored(i, entry.col())) *value++ = Number(entry.value());
  assert(value == values_.end());
}

template <class Number>
bool DirectSolver::Mumps<Number>::factor(const SparseMatrix& A) {
  if (!analysed_) set_structure(A);
  set_values(A);
  for (const Number value : values_)
    if (!std::isfinite(value)) return false;
  if (!analysed_ && !(analysed_ = run(1))) return false;
  constexpr int out_of_workspace = -9;
  bool ok = run(2);
  for (int more = 0; !ok && id_.infog[0] == out_of_workspace && more < 3; ++more) {
    control(14) *= 2;
    ok = run(2);
  }
  return ok;
}

template <class Number>
void DirectSolver::Mumps<Number>::solve(Eigen::Ref<Eigen::MatrixXd>& rhs) {
  rhs_ = rhs.cast<Number>();
  id_.rhs = rhs_.data();
  id_.nrhs = int(rhs_.cols());
  id_.lrhs = int(rhs_.rows());
  run(3);
  rhs = rhs_.template cast<double>();
}

DirectSolver::DirectSolver(Symmetry symmetry, Precision precision) {
  if (precision == Precision::full)
    factors_ = std::make_unique<Mumps<double>>(symmetry);
  else
    factors_ = std::make_unique<Mumps<float>>(symmetry);
}
DirectSolver::~DirectSolver() = default;
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;

bool DirectSolver::factor(const SparseMatrix& A) { return factors_->factor(A); }
void DirectSolver::solve(Eigen::Ref<Eigen::MatrixXd> rhs) const { factors_->solve(rhs); }
double DirectSolver::flops() const { return factors_->flops(); }
double DirectSolver::entries() const { return factors_->entries(); }
int DirectSolver::negative_eigenvalues() const { return factors_->negative_eigenvalues(); }

}  // namespace sbeh::surface3d
