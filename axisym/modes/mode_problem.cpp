#include "axisym/modes/mode_problem.h"

#include "axisym/stationary/newton_system.h"
#include "model/numerics/lanczos.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace sbeh::axisym {

namespace {

Eigen::MatrixXd independent_columns(const Eigen::MatrixXd& columns) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns.colwise().normalized());
  qr.setThreshold(1e-6);
  return (columns * qr.colsPermutation()).leftCols(qr.rank());
}

// M x, free motions with their own weight: x = y + Σ c_j x_j, y 0 where it is held.
class Mass {
 public:
  explicit Mass(const ModeProblem& problem) : matrix_(problem.M) {
    const auto count = Eigen::Index(problem.free.size());
    corrections_.resize(matrix_.size(), count);
    Eigen::MatrixXd held(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const FreeMotion& motion = problem.free[std::size_t(j)];
      corrections_.col(j) = -matrix_.times(motion.x);
      if (motion.weight.size() > 0) corrections_.col(j) += motion.weight;
      held_.push_back(motion.held);
      for (Eigen::Index i = 0; i < count; ++i)
        held(i, j) = motion.x[problem.free[std::size_t(i)].held];
    }
    if (count > 0) share_.compute(held);
  }
  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    Eigen::VectorXd product = matrix_.times(x);
    if (!held_.empty()) product += corrections_ * share_.solve(Eigen::VectorXd(x(held_)));
    return product;
  }

 private:
  const model::BandMatrix& matrix_;
  std::vector<int> held_;
  Eigen::MatrixXd corrections_;  // of M x_j, in columns
  Eigen::FullPivLU<Eigen::MatrixXd> share_;
};

// (A − σ M)⁻¹ on what does not set free motions going: x = y + Σ c_j x_j, y 0 where it is held, x_j · M x = 0.
class FreeInverse {
 public:
  FreeInverse(const ModeProblem& problem, double shift) : matrix_(problem.A) {
    matrix_.add(-shift, problem.M);
    Eigen::Index resisted = 0;
    for (const FreeMotion& motion : problem.free) {
      held_.push_back(motion.held);
      matrix_.pin(motion.held, 1);
      resisted += motion.weight.size() > 0;
    }
    usable_ = matrix_.factor();
    if (!usable_) return;
    weights_.resize(matrix_.size(), resisted);
    answers_.resize(matrix_.size(), resisted);
    Eigen::Index k = 0;
    for (const FreeMotion& motion : problem.free) {
      if (motion.weight.size() == 0) continue;
      weights_.col(k) = motion.weight;
      answers_.col(k) = motion.x + shift * held_inverse(weights_.col(k));
      ++k;
    }
    if (k > 0) schur_.compute(weights_.transpose() * answers_);
  }
  bool usable() const { return usable_; }
  Eigen::VectorXd operator()(const Eigen::VectorXd& load) const {
    Eigen::VectorXd x = held_inverse(load);
    if (weights_.cols() > 0) x -= answers_ * schur_.solve(weights_.transpose() * x);
    return x;
  }

 private:
  Eigen::VectorXd held_inverse(Eigen::VectorXd x) const {
    for (const int i : held_) x[i] = 0;
    matrix_.solve(x);
    return x;
  }

  model::BandMatrix matrix_;
  std::vector<int> held_;
  Eigen::MatrixXd weights_, answers_;  // in columns: M x_j, and x_j with the y that it brings
  Eigen::FullPivLU<Eigen::MatrixXd> schur_;
  bool usable_;
};

// (A − σ M)⁻¹, the constraints kept.
class Inverse {
 public:
  Inverse(const ModeProblem& problem, double shift) : free_(problem, shift) {
    if (!usable() || problem.constraints.cols() == 0) return;
    // On the sphere area and volume change together.
    constraints_ = independent_columns(problem.constraints);
    solved_ = constraints_;
    for (auto column : solved_.colwise()) column = free_(column);
    schur_.compute(constraints_.transpose() * solved_);
  }
  bool usable() const { return free_.usable(); }
  Eigen::VectorXd operator()(const Eigen::VectorXd& load) const {
    Eigen::VectorXd x = free_(load);
    if (constraints_.cols() > 0) x -= solved_ * schur_.solve(constraints_.transpose() * x);
    return x;
  }

 private:
  FreeInverse free_;
  Eigen::MatrixXd constraints_, solved_;  // in columns, and (A − σ M)⁻¹ of them
  Eigen::FullPivLU<Eigen::MatrixXd> schur_;
};

// An unknown of all nodes.
template <class Vector>
auto at_nodes(Vector& x, int node_size, NodeUnknown c) {
  return x(Eigen::seqN(Eigen::Index(c), x.size() / node_size, Eigen::Index(node_size)));
}

// What acts on d and on the order of a vector, in the part of a parity.
Eigen::VectorXd load_of(const Eigen::VectorXd& x, int node_size, Parity parity) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(x.size());
  for (const NodeUnknown c : {node_d, node_beta}) {
    auto part = at_nodes(load, node_size, c);
    part = at_nodes(x, node_size, c);
    if (parity == Parity::none) continue;
    const double sign = parity == Parity::even ? 1 : -1;
    part = (part + sign * part.reverse()).eval() / 2;
  }
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

int rigid_of(const ModeProblem& problem, Parity parity) {
  return int(std::ranges::count_if(problem.rigid, [&](const Eigen::VectorXd& motion) {
    return load_of(motion, node_unknowns, parity).norm() > 0.5 * motion.norm();
  }));
}

// d and the order of a vector, in the unknowns of SecondVariation.
Eigen::VectorXd fields_of(const ModeProblem& problem, const Eigen::VectorXd& x) {
  Eigen::VectorXd fields = Eigen::VectorXd::Zero(problem.square.size());
  for (const NodeUnknown c : {node_d, node_beta})
    at_nodes(fields, node_unknowns, c) = at_nodes(x, problem.node_size, c);
  return fields;
}

// (u, b) as AzimuthalMode has them.
Eigen::VectorXd shape_of(const ModeProblem& problem, const Eigen::VectorXd& x) {
  Eigen::VectorXd shape = fields_of(problem, x);
  for (const FreeMotion& motion : problem.free) {
    if (motion.weight.size() > 0) continue;
    const Eigen::VectorXd part = fields_of(problem, motion.x), loaded = problem.square.times(part);
    if (const double whole = part.dot(loaded); whole > 0) shape -= shape.dot(loaded) / whole * part;
  }
  const Field u = at_nodes(shape, node_unknowns, node_d);
  const double sign = u.maxCoeff() < -u.minCoeff() ? -1 : 1;
  const double turn = problem.m == 0 ? 2 * std::numbers::pi : std::numbers::pi;  // ∫cos² mφ dφ
  return sign / std::sqrt(turn * shape.dot(problem.square.times(shape))) * shape;
}

bool is_rigid(const ModeProblem& problem, const Eigen::VectorXd& shape) {
  const Eigen::VectorXd loaded = problem.square.times(shape);
  double share = 0;
  for (const Eigen::VectorXd& motion : problem.rigid) share += std::pow(motion.dot(loaded), 2);
  return share > 0.5 * shape.dot(loaded);
}

// The modes of one parity, rigid motions among them; those of the smallest (λ − shift)⁻¹ come last. Empty where
// Lanczos' iteration fails.
std::optional<model::RitzPairs> modes_of(const ModeProblem& problem, Parity parity,
                                         const Inverse& inverse, const Mass& full_mass, int count) {
  constexpr int most_steps = 120;
  const auto load = [&](const Eigen::VectorXd& x) {
    Eigen::VectorXd part = load_of(x, problem.node_size, parity);
    for (const auto idle : problem.idle.colwise())
      part -= idle.dot(part) / idle.squaredNorm() * idle;
    return part;
  };
  const auto mass = [&](const Eigen::VectorXd& x) { return load(full_mass(x)); };
  const Eigen::VectorXd start = inverse(mass(inverse(load(any_vector(problem.M.size())))));
  return model::largest_by_lanczos(inverse, mass, start, count + rigid_of(problem, parity),
                                   most_steps);
}

}  // namespace

std::optional<AzimuthalModes> lowest(const ModeProblem& problem, bool is_symmetric, int count) {
  constexpr double first_shift = -10, lowest_shift = -1e9, growth = 4;  // scales
  constexpr double rounding = 1e-9;
  const auto parities =
      is_symmetric ? std::vector{Parity::even, Parity::odd} : std::vector{Parity::none};
  const Mass mass(problem);
  for (double shift = first_shift; shift > lowest_shift; shift *= growth) {
    const double sigma = shift * problem.scale;
    const Inverse inverse(problem, sigma);
    if (!inverse.usable()) return {};
    AzimuthalModes found;
    std::size_t recognised = 0;
    bool is_below = true;
    for (const Parity parity : parities) {
      const auto pairs = modes_of(problem, parity, inverse, mass, count);
      if (!pairs) return {};
      is_below = is_below && pairs->least > -rounding * std::abs(pairs->values[0]);
      int kept = 0;
      for (Eigen::Index k = 0; k < pairs->values.size(); ++k) {
        const Eigen::VectorXd shape = shape_of(problem, pairs->vectors.col(k));
        const double lambda = sigma + 1 / pairs->values[k];
        if (is_rigid(problem, shape)) {
          found.rigid_residual = std::max(found.rigid_residual, std::abs(lambda));
          ++recognised;
        } else if (kept++ < count) {
          found.modes.push_back({parity, lambda, at_nodes(shape, node_unknowns, node_d),
                                 at_nodes(shape, node_unknowns, node_beta)});
        }
      }
    }
    if (!is_below) continue;
    if (recognised < problem.rigid.size())
      found.rigid_residual = std::numeric_limits<double>::infinity();
    std::ranges::sort(found.modes, {}, &AzimuthalMode::lambda);
    return found;
  }
  return {};
}

}  // namespace sbeh::axisym
