#include "axisym/spectral/newton.h"

#include "model/numerics/constrained_newton.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

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

}  // namespace

std::optional<Critical> minimise(const Problem& problem, const VectorXd& target, VectorXd y) {
  std::optional<Expansion> at = expand(problem, y);
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; at && iteration < most_iterations; ++iteration) {
    const Multipliers lambda = estimate_multipliers(*at);
    const VectorXd gradient = at->gradient + at->jacobian.transpose() * lambda;
    const VectorXd miss = at->measures - target;
    const double residual = std::max(largest_force(problem, gradient), miss.cwiseAbs().maxCoeff());

    const model::TangentSplit split(at->jacobian.transpose());
    const MatrixXd H = split.rotated(hessian(problem, y, lambda));
    if (residual < rounding || (residual < tolerance && residual > 0.1 * before)) {
      const double lowest = split.tangential_eigenvalues(H)[0];
      if (!(lowest > 0)) return {};
      return Critical{.y = y,
                      .multipliers = lambda,
                      .energy = at->energy,
                      .residual = residual,
                      .stiffness = lowest};
    }
    before = residual;

    const VectorXd step = split.newton_step(H, gradient, miss, descend);
    const auto merit = [&](const Expansion& e) {
      const VectorXd off = e.measures - target;
      return e.energy + lambda.dot(off) + penalty / 2 * off.squaredNorm();
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

}  // namespace sbeh::axisym::spectral
