#include "surface3d/harmonic/minimiser.h"

#include "surface3d/harmonic/energy.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace sbeh::surface3d {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

constexpr double penalty = 1e3;    // on the squared misses of area and volume
constexpr int coarse_degree = 10;  // of the way there

// ---- Ceres --------------------------------------------------------------------------------------

// Residuals f with ½ Σ f² = F/κ + ½μ Σ (measure − target + shift)².
class SquaredCurvature : public ceres::CostFunction {
 public:
  SquaredCurvature(const HarmonicEnergy& energy, const Vector2d& target)
      : energy_(energy), target_(target) {
    set_num_residuals(energy.points() + 2);
    mutable_parameter_block_sizes()->push_back(energy.unknowns());
  }

  Vector2d shift = Vector2d::Zero();

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Index N = energy_.points(), n = energy_.unknowns();
    const VectorXd c = Eigen::Map<const VectorXd>(parameters[0], n);
    const bool wanted = jacobians && jacobians[0];
    Eigen::Map<VectorXd> f(residuals, N + 2);
    const auto at = energy_.expand(c);
    if (!at) {  // no such step is taken
      f.setConstant(1e6);
      return !wanted;
    }
    MatrixXd by_c;
    f.head(N) = energy_.root_curvature(c, wanted ? &by_c : nullptr);
    for (const Index i : {0, 1})
      f[N + i] = std::sqrt(penalty) * (at->measures[1 + i] - target_[i] + shift[i]);
    if (wanted) {
      Eigen::Map<RowMajor> J(jacobians[0], N + 2, n);
      J.topRows(N) = by_c;
      J.bottomRows(2) = std::sqrt(penalty) * at->gradients.rightCols<2>().transpose();
    }
    return true;
  }

 private:
  const HarmonicEnergy& energy_;
  Vector2d target_;  // A, V
};

// Σ and P that balance the gradient of F/κ best.
Vector2d multipliers_of(const HarmonicEnergy::Expansion& at) {
  MatrixXd J(at.gradients.rows(), 2);
  J << -at.gradients.col(1), at.gradients.col(2);
  return J.colPivHouseholderQr().solve(at.gradients.col(0));
}

// Downhill, with errors of about 1e-5 in area and volume; false if that fails.
bool relax(HarmonicSurface& surface, const Vector2d& target, int& iterations) {
  constexpr int most_iterations = 400;
  constexpr double tolerance = 1e-5;
  constexpr int most_shifts = 10;
  const HarmonicEnergy energy(surface);
  VectorXd& c = surface.coefficients;
  SquaredCurvature cost(energy, target);
  const auto first = energy.expand(c);
  if (!first) return false;
  const Vector2d multipliers = multipliers_of(*first);
  cost.shift = Vector2d(multipliers[0], -multipliers[1]) / penalty;

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, c.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.logging_type = ceres::SILENT;
  options.function_tolerance = 1e-6;
  const int last = iterations + most_iterations;
  for (int i = 0; i < most_shifts && iterations < last; ++i) {
    options.max_num_iterations = last - iterations;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (summary.termination_type == ceres::FAILURE) return false;
    iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
    const Vector2d miss = energy.expand(c)->measures.tail<2>() - target;
    if (miss.cwiseAbs().maxCoeff() < tolerance) break;
    cost.shift += miss;
  }
  return true;
}

// ---- Newton's method ----------------------------------------------------------------------------

// Orthonormal coordinates of the coefficients: first those of the changes of area and volume and of
// rigid motions, then all others.
class Split {
 public:
  Split(const MatrixXd& measures, const MatrixXd& rigid) {
    Eigen::ColPivHouseholderQR<MatrixXd> motions(rigid);
    motions.setThreshold(1e-5);  // turned about its axis, a body of revolution does not move
    MatrixXd fixed(rigid.rows(), 2 + motions.rank());
    fixed << measures, motions.householderQ() * MatrixXd::Identity(rigid.rows(), motions.rank());
    fixed_ = fixed.cols();
    qr_.compute(fixed);
  }

  Index fixed() const { return fixed_; }
  MatrixXd rotated(MatrixXd K) const {
    K.applyOnTheLeft(qr_.householderQ().adjoint());
    K.applyOnTheRight(qr_.householderQ());
    return K;
  }
  VectorXd rotated(const VectorXd& v) const { return qr_.householderQ().adjoint() * v; }
  VectorXd back(const VectorXd& v) const { return qr_.householderQ() * v; }
  // The first coordinates of the step that changes area and volume by this much, to first order, without
  // rigid motion.
  VectorXd fixed_step(const Vector2d& change) const {
    VectorXd right = VectorXd::Zero(fixed_);
    right.head<2>() = change;
    return qr_.matrixQR()
        .topLeftCorner(fixed_, fixed_)
        .triangularView<Eigen::Upper>()
        .transpose()
        .solve(right);
  }

 private:
  Index fixed_ = 0;
  Eigen::HouseholderQR<MatrixXd> qr_;
};

struct Stationary {
  VectorXd a;
  HarmonicMeasures measures;
  Vector2d multipliers;  // Σ, P
  double residual;
  VectorXd curvatures;  ///< eigenvalues of the second variation, ascending
};

// Newton's method to the stationary shape that is next, be it a saddle.
HarmonicStop settle(const HarmonicEnergy& energy, const Vector2d& target, VectorXd a,
                    Stationary& found, int& iterations) {
  constexpr int most_iterations = 20;
  constexpr double tolerance = 1e-8, rounding = 1e-12;
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration, ++iterations) {
    const auto at = energy.expand(a);
    if (!at) return HarmonicStop::degenerate;
    const Vector2d multipliers = multipliers_of(*at);
    const Vector2d miss = at->measures.tail<2>() - target;
    const Split split(at->gradients.rightCols<2>(), energy.rigid_motions(a));
    const Index fixed = split.fixed(), free = a.size() - fixed;
    const VectorXd force =
        split.rotated(VectorXd(-at->gradients.col(0) - multipliers[0] * at->gradients.col(1)
                               + multipliers[1] * at->gradients.col(2)));
    const MatrixXd K = split.rotated(energy.hessian(a, multipliers[0], multipliers[1]));
    const double residual =
        std::max(force.tail(free).cwiseAbs().maxCoeff(), miss.cwiseAbs().maxCoeff());
    if (residual < rounding || (residual < tolerance && residual > 0.1 * before)) {
      const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(K.bottomRightCorner(free, free),
                                                          Eigen::EigenvaluesOnly);
      found = {a, at->measures, multipliers, residual, eigen.eigenvalues()};
      return HarmonicStop::stationary;
    }
    before = residual;
    VectorXd step(a.size());
    step.head(fixed) = split.fixed_step(-miss);
    step.tail(free) =
        K.bottomRightCorner(free, free)
            .partialPivLu()
            .solve(force.tail(free) - K.bottomLeftCorner(free, fixed) * step.head(fixed));
    a += split.back(step);
  }
  return HarmonicStop::not_converged;
}

}  // namespace

std::string describe(HarmonicStop stop) {
  switch (stop) {
    case HarmonicStop::stationary:
      return "stationary";
    case HarmonicStop::degenerate:
      return "the surface turned inside out on the way";
    case HarmonicStop::not_converged:
      return "Newton's method does not converge";
  }
  return "";
}

HarmonicShape minimise_harmonics(const HarmonicSurface& start, double reduced_volume, int degree) {
  if (!(reduced_volume > 0 && reduced_volume < 1))
    throw std::invalid_argument(
        fmt::format("reduced volume {}: must lie between 0 and 1", reduced_volume));
  if (degree < 4 || degree > 32)
    throw std::invalid_argument(fmt::format("degree {}: must be in [4, 32]", degree));
  const Vector2d target(4 * pi, reduced_volume * 4 * pi / 3);
  HarmonicShape shape{.stop = HarmonicStop::degenerate,
                      .surface = refitted(start.with_degree(std::max(start.degree, coarse_degree)))
                                     .with_degree(std::min(degree, coarse_degree))};
  HarmonicSurface& surface = shape.surface;
  if (!relax(surface, target, shape.iterations)) return shape;
  surface = refitted(surface);  // the shape may be another, or have moved
  if (!relax(surface, target, shape.iterations)) return shape;
  surface = surface.with_degree(degree);
  const HarmonicEnergy energy(surface);
  Stationary found;
  shape.stop = settle(energy, target, surface.coefficients, found, shape.iterations);
  if (shape.stop != HarmonicStop::stationary) return shape;
  surface.coefficients = found.a;
  shape.energy = found.measures[0] / (8 * pi);
  shape.area = found.measures[1];
  shape.volume = found.measures[2];
  shape.tension = found.multipliers[0];
  shape.pressure = found.multipliers[1];
  shape.residual = found.residual;
  shape.negative_directions = int((found.curvatures.array() < 0).count());
  shape.stiffness = found.curvatures[0];
  shape.tail = tail(surface);
  return shape;
}

}  // namespace sbeh::surface3d
