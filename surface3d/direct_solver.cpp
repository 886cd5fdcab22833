#include "surface3d/direct_solver.h"

#include <dmumps_c.h>
#include <metis.h>

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
  int last = vertices;
  for (const int vertex : number)
    positions.push_back(1 + (vertex >= 0 ? place[std::size_t(vertex)] : last++));
  return positions;
}

}  // namespace

struct DirectSolver::Mumps {
  DMUMPS_STRUC_C id{};
  bool symmetric = false, analysed = false;
  std::vector<int> rows, columns, order;
  std::vector<double> values;

  // MUMPS's manual counts from 1.
  int& control(int i) { return id.icntl[i - 1]; }
  bool run(int job) {
    id.job = job;
    dmumps_c(&id);
    return id.infog[0] >= 0;
  }

  explicit Mumps(bool is_symmetric) : symmetric(is_symmetric) {
    id.par = 1;
    id.sym = symmetric ? 2 : 0;
    id.comm_fortran = -987654;  // MPI_COMM_WORLD of the sequential library
    run(-1);
    for (const int stream : {1, 2, 3}) control(stream) = -1;
    control(4) = 0;    // silent
    control(6) = 0;    // no permutation by values: the analysis sees the structure alone
    control(7) = 1;    // our ordering
    control(14) = 60;  // per cent of memory more than estimated, for pivoting
  }
  ~Mumps() { run(-2); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  bool stored(Eigen::Index row, Eigen::Index column) const { return !symmetric || column <= row; }

  void set_structure(const SparseMatrix& A) {
    rows.clear();
    columns.clear();
    for (Eigen::Index i = 0; i < A.outerSize(); ++i)
      for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
        if (stored(i, entry.col())) {
          rows.push_back(int(i) + 1);
          columns.push_back(int(entry.col()) + 1);
        }
    values.resize(rows.size());
    id.n = int(A.rows());
    id.nnz = MUMPS_INT8(rows.size());
    id.irn = rows.data();
    id.jcn = columns.data();
    id.a = values.data();
    order = elimination_order(A);
    id.perm_in = order.data();
  }
  void set_values(const SparseMatrix& A) {
    auto value = values.begin();
    for (Eigen::Index i = 0; i < A.outerSize(); ++i)
      for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
        if (stored(i, entry.col())) *value++ = entry.value();
    assert(value == values.end());
  }
};

DirectSolver::DirectSolver(Symmetry symmetry)
    : mumps_(std::make_unique<Mumps>(symmetry == Symmetry::symmetric)) {}
DirectSolver::~DirectSolver() = default;
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;

bool DirectSolver::factor(const SparseMatrix& A) {
  Mumps& m = *mumps_;
  if (!m.analysed) m.set_structure(A);
  m.set_values(A);
  for (const double value : m.values)
    if (!std::isfinite(value)) return false;
  if (!m.analysed && !(m.analysed = m.run(1))) return false;
  constexpr int out_of_workspace = -9;
  bool ok = m.run(2);
  for (int more = 0; !ok && m.id.infog[0] == out_of_workspace && more < 3; ++more) {
    m.control(14) *= 2;
    ok = m.run(2);
  }
  return ok;
}

void DirectSolver::solve(Eigen::Ref<Eigen::MatrixXd> rhs) const {
  Mumps& m = *mumps_;
  m.id.rhs = rhs.data();
  m.id.nrhs = int(rhs.cols());
  m.id.lrhs = int(rhs.outerStride());
  m.run(3);
}

double DirectSolver::flops() const { return mumps_->id.rinfog[2]; }
double DirectSolver::entries() const {
  const int entries = mumps_->id.infog[28];
  return entries < 0 ? -1e6 * entries : entries;  // large numbers are given in millions
}
double DirectSolver::megabytes() const { return mumps_->id.infog[21]; }

}  // namespace sbeh::surface3d
