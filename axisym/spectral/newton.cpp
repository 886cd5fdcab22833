#include "axisym/spectral/newton.h"

#include "model/numerics/constrained_newton.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sbeh::axisym::spectral {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int most_iterations = 60;
constexpr double tolerance = 1e-10;
constexpr double rounding = 1e-14;  // a residual that no step improves
constexpr double penalty = 1e3;     // on the constraints, in the merit of a step
constexpr double shortest = 1e-4;   // part of a step
constexpr double softest = 1e-3;    // eigenvalue by which an uphill direction is turned round

// H⁻¹ force, or downhill all the same where H is not positive.
VectorXd descend(const MatrixXd& H, const VectorXd& force) {
  const Eigen::LLT<MatrixXd> llt(H);
  if (llt.info() == Eigen::Success) return llt.solve(force);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(H);
  const VectorXd stiff = eigen.eigenvalues().cwiseAbs().cwiseMax(softest);
  return eigen.eigenvectors() * (eigen.eigenvectors().transpose() * force).cwiseQuotient(stiff);
}

// Derivatives by high modes are as large as the mode's number times rounding.
double largest_force(const Problem& problem, const VectorXd& lagrangian_gradient) {
  const int n = problem.basis->modes();
  double largest = 0;
  for (Index i = 0; i < lagrangian_gradient.size(); ++i) {
    const Index mode = i <= n ? i : i - n - 1;
    largest = std::max(largest, std::abs(lagrangian_gradient[i]) / double(1 + mode));
  }
  return largest;
}

// Lagrangian and second variation at y, with the multipliers that balance best.
struct Balance {
  Multipliers multipliers;
  VectorXd gradient, miss;
  double residual;
  model::TangentSplit split;
  MatrixXd H;  // rotated

  Balance(const Problem& problem, const VectorXd& target, const VectorXd& y, const Expansion& at)
      : multipliers(estimate_multipliers(at)),
        gradient(at.gradient + at.jacobian.transpose() * multipliers),
        miss(at.measures - target),
        residual(std::max(largest_force(problem, gradient), miss.cwiseAbs().maxCoeff())),
        split(at.jacobian.transpose()),
        H(split.rotated(hessian(problem, y, multipliers))) {}

  // Whether it is to rounding what steps can do; `before` is the residual one step ago.
  bool is_critical(double before) const {
    return residual < rounding || (residual < tolerance && residual > 0.1 * before);
  }
  Critical critical(const VectorXd& y, const Expansion& at) const {
    const VectorXd eigenvalues = split.tangential_eigenvalues(H);
    return {.y = y,
            .multipliers = multipliers,
            .energy = at.energy,
            .residual = residual,
            .stiffness = eigenvalues[0],
            .negative_directions = int((eigenvalues.array() < 0).count())};
  }
};

}  // namespace

std::optional<Critical> minimise(const Problem& problem, const VectorXd& target, VectorXd y) {
  std::optional<Expansion> at = expand(problem, y);
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; at && iteration < most_iterations; ++iteration) {
    const Balance balance(problem, target, y, *at);
    if (balance.is_critical(before)) {
      const Critical found = balance.critical(y, *at);
      return found.stiffness > 0 ? std::optional(found) : std::nullopt;
    }
    before = balance.residual;

    const VectorXd step =
        balance.split.newton_step(balance.H, balance.gradient, balance.miss, descend);
    const auto merit = [&](const Expansion& e) {
      const VectorXd off = e.measures - target;
      return e.energy + balance.multipliers.dot(off) + penalty / 2 * off.squaredNorm();
    };
    const double accepted = merit(*at) + 1e-11 * (1 + std::abs(at->energy));
    double part = 1;
    for (at = expand(problem, y + step); !at || merit(*at) > accepted;) {
      part /= 2;
      if (part < shortest) return {};
      at = expand(problem, y + part * step);
    }
    y += part * step;
  }
  return {};
}

std::optional<Critical> critical_point(const Problem& problem, const VectorXd& target, VectorXd y,
                                       double far) {
  const VectorXd start = y;
  const model::TangentSplit::Solve solve = [](const MatrixXd& H, const VectorXd& force) {
    return VectorXd(H.partialPivLu().solve(force));
  };
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const std::optional<Expansion> at = expand(problem, y);
    if (!at) return {};
    const Balance balance(problem, target, y, *at);
    if (balance.is_critical(before)) return balance.critical(y, *at);
    before = balance.residual;
    y += balance.split.newton_step(balance.H, balance.gradient, balance.miss, solve);
    if (!((y - start).cwiseAbs().maxCoeff() < far)) return {};
  }
  return {};
}

}  // namespace sbeh::axisym::spectral
