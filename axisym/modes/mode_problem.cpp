#include "axisym/modes/mode_problem.h"

#include "model/numerics/lanczos.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace sbeh::axisym {

namespace {

// M on what is 0 in the held unknowns, its motion along the free ones taken out: M − w W⁻¹ wᵀ, w and W their weights and
// squares.
template <int N>
class FreeMass {
 public:
  explicit FreeMass(const ModeProblem<N>& problem)
      : matrix_(problem.M), weights_(problem.free.weights) {
    for (const int i : problem.free.held) matrix_.pin(i, 0);
    if (weights_.cols() == 0) return;
    for (const int i : problem.free.held) weights_.row(i).setZero();
    squares_.compute(problem.free.squares);
  }
  const model::ChainMatrix<N>& matrix() const { return matrix_; }
  const Eigen::MatrixXd& weights() const { return weights_; }
  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    Eigen::VectorXd product = matrix_.times(x);
    if (weights_.cols() > 0) product -= weights_ * share(x);
    return product;
  }
  /// W⁻¹ wᵀ x: how much of the free motions is taken from x.
  Eigen::VectorXd share(const Eigen::VectorXd& x) const {
    return squares_.solve(Eigen::VectorXd(weights_.transpose() * x));
  }

 private:
  model::ChainMatrix<N> matrix_;
  Eigen::MatrixXd weights_;
  Eigen::FullPivLU<Eigen::MatrixXd> squares_;
};

// (A − σ M)⁻¹ likewise.
template <int N>
class FreeInverse {
 public:
  FreeInverse(const ModeProblem<N>& problem, const FreeMass<N>& mass, double shift)
      : held_(problem.free.held),
        weights_(mass.weights()),
        inverse_(shifted(problem, mass, shift)) {
    if (!usable() || weights_.cols() == 0) return;
    answers_ = weights_;
    for (auto column : answers_.colwise()) inverse_.solve(column);
    schur_.compute(problem.free.squares / shift + weights_.transpose() * answers_);
  }
  bool usable() const { return inverse_.usable(); }
  Eigen::VectorXd operator()(Eigen::VectorXd x) const {
    for (const int i : held_) x[i] = 0;
    inverse_.solve(x);
    if (weights_.cols() > 0) x -= answers_ * schur_.solve(weights_.transpose() * x);
    return x;
  }

 private:
  static model::ChainMatrix<N> shifted(const ModeProblem<N>& problem, const FreeMass<N>& mass,
                                       double shift) {
    model::ChainMatrix<N> matrix = problem.A;
    for (const int i : problem.free.held) matrix.pin(i, 1);
    matrix.add(-shift, mass.matrix());
    return matrix;
  }

  const std::vector<int>& held_;
  const Eigen::MatrixXd& weights_;
  model::ChainInverse<N> inverse_;
  Eigen::MatrixXd answers_;
  Eigen::FullPivLU<Eigen::MatrixXd> schur_;
};

// An unknown of all nodes.
template <int N, class Vector>
auto at_nodes(Vector& x, NodeUnknown c) {
  return x(Eigen::seqN(Eigen::Index(c), x.size() / N, Eigen::Index(N)));
}

// What acts on d and on the order of a vector, less what is idle.
template <int N>
Eigen::VectorXd load_of(const ModeProblem<N>& problem, const Eigen::VectorXd& x) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(x.size());
  for (const NodeUnknown c : {node_d, node_beta}) at_nodes<N>(load, c) = at_nodes<N>(x, c);
  for (const auto idle : problem.idle.colwise()) load -= idle.dot(load) / idle.squaredNorm() * idle;
  return load;
}

// The same for every run.
Eigen::VectorXd any_vector(Eigen::Index size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd x(size);
  for (double& value : x) value = uniform(random);
  return x;
}

// d and the order of a vector, in the unknowns of SecondVariation.
template <int N>
Eigen::VectorXd fields_of(const Eigen::VectorXd& x) {
  Eigen::VectorXd fields = Eigen::VectorXd::Zero(x.size() / N * node_unknowns);
  for (const NodeUnknown c : {node_d, node_beta})
    at_nodes<node_unknowns>(fields, c) = at_nodes<N>(x, c);
  return fields;
}

// (u, b) as AzimuthalMode has them.
template <int N>
Eigen::VectorXd shape_of(const ModeProblem<N>& problem, const FreeMass<N>& mass,
                         const Eigen::VectorXd& x) {
  const Eigen::MatrixXd& free = problem.free.fields;
  Eigen::VectorXd shape = fields_of<N>(x);
  if (mass.weights().cols() > 0) {
    shape -= free * mass.share(x);
  } else if (free.cols() > 0) {  // orthonormal ones
    const Eigen::VectorXd loaded = problem.square.times(shape);
    shape -= free * (free.transpose() * loaded);
  }
  const Field u = at_nodes<node_unknowns>(shape, node_d);
  const double sign = u.maxCoeff() < -u.minCoeff() ? -1 : 1;
  const double turn = problem.m == 0 ? 2 * std::numbers::pi : std::numbers::pi;  // ∫cos² mφ dφ
  return sign / std::sqrt(turn * shape.dot(problem.square.times(shape))) * shape;
}

template <int N>
bool is_rigid(const ModeProblem<N>& problem, const Eigen::VectorXd& shape) {
  if (problem.rigid.cols() == 0) return false;
  const Eigen::VectorXd loaded = problem.square.times(shape);
  return (problem.rigid.transpose() * loaded).squaredNorm() > 0.5 * shape.dot(loaded);
}

// The modes, rigid motions among them; those of the smallest (λ − shift)⁻¹ come last. Empty where A − shift M is singular
// or Lanczos' iteration fails.
template <int N>
std::optional<model::RitzPairs> nearest(const ModeProblem<N>& problem, const FreeMass<N>& free_mass,
                                        double shift, int count) {
  constexpr int most_steps = 120;
  const FreeInverse<N> free(problem, free_mass, shift);
  if (!free.usable()) return {};
  const SoftInverse soft(free, problem.soft);
  const ConstrainedInverse inverse(soft, problem.constraints);
  const auto mass = [&](const Eigen::VectorXd& x) { return load_of(problem, free_mass(x)); };
  const Eigen::VectorXd start =
      inverse(mass(inverse(load_of(problem, any_vector(problem.M.size())))));
  return model::largest_by_lanczos(inverse, mass, start, count + int(problem.rigid.cols()),
                                   most_steps);
}

}  // namespace

template <int N>
std::optional<AzimuthalModes> lowest(const ModeProblem<N>& problem, int count) {
  constexpr double first_shift = -10, lowest_shift = -1e9, growth = 4;  // scales
  constexpr double rounding = 1e-9;
  const FreeMass<N> mass(problem);
  for (double shift = first_shift; shift > lowest_shift; shift *= growth) {
    const double sigma = shift * problem.scale;
    const auto pairs = nearest(problem, mass, sigma, count);
    if (!pairs) return {};
    if (pairs->least <= -rounding * std::abs(pairs->values[0])) continue;  // one is below the shift
    AzimuthalModes found;
    int recognised = 0;
    for (Eigen::Index k = 0; k < pairs->values.size(); ++k) {
      const Eigen::VectorXd shape = shape_of(problem, mass, pairs->vectors.col(k));
      const double lambda = sigma + 1 / pairs->values[k];
      if (is_rigid(problem, shape)) {
        found.rigid_residual = std::max(found.rigid_residual, std::abs(lambda));
        ++recognised;
      } else if (int(found.modes.size()) < count) {
        found.modes.push_back({lambda, at_nodes<node_unknowns>(shape, node_d),
                               at_nodes<node_unknowns>(shape, node_beta)});
      }
    }
    if (recognised < problem.rigid.cols())
      found.rigid_residual = std::numeric_limits<double>::infinity();
    std::ranges::sort(found.modes, {}, &AzimuthalMode::lambda);
    return found;
  }
  return {};
}

template std::optional<AzimuthalModes> lowest(const ModeProblem<node_unknowns>&, int);
template std::optional<AzimuthalModes> lowest(const ModeProblem<flow_node_size>&, int);

}  // namespace sbeh::axisym
