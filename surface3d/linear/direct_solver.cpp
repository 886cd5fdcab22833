#include "surface3d/linear/direct_solver.h"

#include <dmumps_c.h>
#include <metis.h>
#include <smumps_c.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sbeh::surface3d {

namespace {

// A row with more entries than this is a multiplier's: eliminated last, and no part of the graph.
constexpr Eigen::Index dense_row = 1000;

// Of each unknown those that it meets in an entry or in one of the transposed matrix, ascending, without itself; rows and
// columns count from 1.
std::vector<std::vector<int>> neighbours_of(int size, const std::vector<int>& rows,
                                            const std::vector<int>& columns) {
  std::vector<std::vector<int>> neighbours{std::size_t(size)};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int i = rows[k] - 1, j = columns[k] - 1;
    if (i == j) continue;
    neighbours[std::size_t(i)].push_back(j);
    neighbours[std::size_t(j)].push_back(i);
  }
  for (auto& of_one : neighbours) {
    std::ranges::sort(of_one);
    of_one.erase(std::unique(of_one.begin(), of_one.end()), of_one.end());
  }
  return neighbours;
}

// The place of each unknown in the order of elimination, counted from 1: nested dissection by METIS,
// a function of the structure alone.
std::vector<int> elimination_order(int size, const std::vector<int>& rows,
                                   const std::vector<int>& columns) {
  const auto graph = neighbours_of(size, rows, columns);
  std::vector<int> number(graph.size(), -1);  // in the graph
  idx_t vertices = 0;
  for (std::size_t i = 0; i < graph.size(); ++i)
    if (Eigen::Index(graph[i].size()) < dense_row) number[i] = vertices++;
  std::vector<idx_t> start{0}, neighbours, order(std::size_t(vertices), 0), place(order);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (number[i] < 0) continue;
    for (const int j : graph[i])
      if (number[std::size_t(j)] >= 0) neighbours.push_back(number[std::size_t(j)]);
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
  /// As another rank, in a job of the first one, which has the matrix and the right-hand sides.
  virtual void join(int job, int workspace) = 0;
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

// MUMPS's jobs.
constexpr int begin = -1, end = -2, analyse = 1, decompose = 2, solve_with = 3;

// What the first rank tells the others of a job that they are to join: this word, and the call.
constexpr std::string_view factors_word = "factors";
struct Call {
  int number, job, workspace;
  Symmetry symmetry;
  Precision precision;
};

// Those that help a process with what it factors alone; itself: none do.
Ranks helpers_of_one;
std::mutex one_job;  // at a time: they have one order

}  // namespace

template <class Number>
class DirectSolver::Mumps : public Factors {
 public:
  Mumps(Symmetry symmetry, const Ranks& ranks, const Ranks& helpers)
      : ranks_(ranks), helpers_(helpers), symmetric_(symmetry == Symmetry::symmetric) {
    static std::atomic<int> count = 0;
    number_ = ++count;
    id_.par = 1;
    id_.sym = symmetric_ ? 2 : 0;
    id_.comm_fortran = (helpers_.is_alone() ? ranks_ : helpers_).communicator();
    run(begin);
    for (const int stream : {1, 2, 3}) control(stream) = -1;
    control(4) = 0;    // silent
    control(6) = 0;    // no permutation by values: the analysis sees the structure alone
    control(7) = 1;    // our ordering
    control(14) = 60;  // per cent of memory more than estimated, for pivoting
    control(13) = symmetric_ ? 1 : 0;              // the last front on one rank: its inertia counts
    control(18) = ranks_.is_alone() ? 0 : parted;  // the matrix
  }
  ~Mumps() override { run(end); }
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
  void join(int job, int workspace) override {
    control(14) = workspace;
    run(job);
  }

 private:
  static constexpr int parted = 3;
  // MUMPS's manual counts from 1.
  int& control(int i) { return id_.icntl[i - 1]; }
  bool run(int job) {
    std::unique_lock lock(one_job, std::defer_lock);
    if (!helpers_.is_alone() && helpers_.is_first()) {
      lock.lock();
      call_helpers(job);
    }
    id_.job = job;
    Library<Number>::call(id_);
    return id_.infog[0] >= 0;
  }
  void call_helpers(int job) {
    const Call call{number_, job, control(14), symmetric_ ? Symmetry::symmetric : Symmetry::general,
                    std::is_same_v<Number, double> ? Precision::full : Precision::single};
    std::string message(factors_word);
    message.append(reinterpret_cast<const char*>(&call), sizeof call);
    send_to_others(helpers_, message);
  }
  bool stored(Eigen::Index row, Eigen::Index column) const { return !symmetric_ || column <= row; }
  void set_structure(const SparseMatrix& A);
  std::vector<int> order() const;
  void set_values(const SparseMatrix& A);

  typename Library<Number>::Data id_{};
  Ranks ranks_, helpers_;
  int number_ = 0;
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
  (ranks_.is_alone() ? id_.nnz : id_.nnz_loc) = MUMPS_INT8(rows_.size());
  (ranks_.is_alone() ? id_.irn : id_.irn_loc) = rows_.data();
  (ranks_.is_alone() ? id_.jcn : id_.jcn_loc) = columns_.data();
  (ranks_.is_alone() ? id_.a : id_.a_loc) = values_.data();
  order_ = order();
  id_.perm_in = order_.data();
}

// On the first rank, which asks for it.
template <class Number>
std::vector<int> DirectSolver::Mumps<Number>::order() const {
  if (ranks_.is_alone()) return elimination_order(id_.n, rows_, columns_);
  std::vector<int> rows = rows_, columns = columns_;
  ranks_.gather(rows);
  ranks_.gather(columns);
  return ranks_.is_first() ? elimination_order(id_.n, rows, columns) : std::vector<int>();
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
  const auto is_finite = [](Number value) { return std::isfinite(value); };
  if (ranks_.any(!std::ranges::all_of(values_, is_finite))) return false;
  if (!analysed_ && !(analysed_ = run(analyse))) return false;
  constexpr int out_of_workspace = -9;
  bool ok = run(decompose);
  for (int more = 0; !ok && id_.infog[0] == out_of_workspace && more < 3; ++more) {
    control(14) *= 2;
    ok = run(decompose);
  }
  return ok;
}

template <class Number>
void DirectSolver::Mumps<Number>::solve(Eigen::Ref<Eigen::MatrixXd>& rhs) {
  rhs_ = rhs.cast<Number>();
  id_.rhs = rhs_.data();
  id_.nrhs = int(rhs_.cols());
  id_.lrhs = int(rhs_.rows());
  run(solve_with);
  ranks_.broadcast(std::as_writable_bytes(std::span(rhs_.data(), std::size_t(rhs_.size()))));
  rhs = rhs_.template cast<double>();
}

std::unique_ptr<DirectSolver::Factors> DirectSolver::factors(Symmetry symmetry, Precision precision,
                                                             const Ranks& ranks,
                                                             const Ranks& helpers) {
  if (precision == Precision::full)
    return std::make_unique<Mumps<double>>(symmetry, ranks, helpers);
  return std::make_unique<Mumps<float>>(symmetry, ranks, helpers);
}

DirectSolver::DirectSolver(Symmetry symmetry, Precision precision, const Ranks& ranks)
    : factors_(factors(symmetry, precision, ranks, ranks.is_alone() ? helpers_of_one : Ranks())) {}
DirectSolver::~DirectSolver() = default;
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;
DirectSolver& DirectSolver::operator=(DirectSolver&&) noexcept = default;

bool DirectSolver::factor(const SparseMatrix& A) { return factors_->factor(A); }
void DirectSolver::solve(Eigen::Ref<Eigen::MatrixXd> rhs) const { factors_->solve(rhs); }
double DirectSolver::flops() const { return factors_->flops(); }
double DirectSolver::entries() const { return factors_->entries(); }
int DirectSolver::negative_eigenvalues() const { return factors_->negative_eigenvalues(); }

SharedFactors::SharedFactors(const Ranks& ranks) { helpers_of_one = ranks; }
SharedFactors::~SharedFactors() { helpers_of_one = {}; }

void SharedFactors::serve(const std::string& message) {
  static std::map<int, std::unique_ptr<DirectSolver::Factors>> known;
  Call call;
  std::memcpy(&call, message.data() + factors_word.size(), sizeof call);
  if (call.job == begin)
    known[call.number] = DirectSolver::factors(call.symmetry, call.precision, {}, Ranks::all());
  else if (call.job == end)
    known.erase(call.number);
  else
    known.at(call.number)->join(call.job, call.workspace);
}

bool SharedFactors::is_meant(const std::string& message) {
  return message.starts_with(factors_word);
}

}  // namespace sbeh::surface3d
