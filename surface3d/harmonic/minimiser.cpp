#include "surface3d/harmonic/minimiser.h"

#include "model/numerics/constrained_newton.h"
#include "model/numerics/constrained_squares.h"
#include "surface3d/harmonic/energy.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
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

constexpr int coarse_degree = 10;  // of the way there

// Σ and P that balance the gradient of F/κ best.
Vector2d multipliers_of(const HarmonicEnergy::Expansion& at) {
  MatrixXd J(at.gradients.rows(), 2);
  J << -at.gradients.col(1), at.gradients.col(2);
  return J.colPivHouseholderQr().solve(at.gradients.col(0));
}

// Downhill, with errors of about 1e-5 in area and volume; false if that fails.
bool relax(HarmonicSurface& surface, const Vector2d& target) {
  const HarmonicEnergy energy(surface);
  VectorXd& c = surface.coefficients;
  const auto first = energy.expand(c);
  if (!first) return false;
  const Vector2d multipliers = multipliers_of(*first);
  const model::ConstrainedSquares squares{
      .residuals = energy.points(),
      .unknowns = energy.unknowns(),
      .target = target,
      .evaluate =
          [&](const VectorXd& a, auto& values, auto* wanted) {
            const auto at = energy.expand(a);
            if (!at) return false;
            values = {energy.root_curvature(a, wanted ? &wanted->residuals : nullptr),
                      at->measures.tail<2>()};
            if (wanted) wanted->measures = at->gradients.rightCols<2>().transpose();
            return true;
          },
      .penalty = 1e3,
      .function_tolerance = 1e-6,
      .most_iterations = 400,
      .normal_equations = true};
  int iterations = 0;
  return minimise_squares(squares, Vector2d(multipliers[0], -multipliers[1]), c, iterations);
}

// The gradients of area and volume, and an orthonormal basis of the rigid motions.
MatrixXd fixed_directions(const HarmonicEnergy::Expansion& at, const MatrixXd& rigid) {
  Eigen::ColPivHouseholderQR<MatrixXd> motions(rigid);
  // Turned about its axis, a body of revolution does not move; one that is nearly so hardly, and held there Newton's method is slow.
  motions.setThreshold(1e-3);
  MatrixXd fixed(rigid.rows(), 2 + motions.rank());
  fixed << at.gradients.rightCols<2>(),
      motions.householderQ() * MatrixXd::Identity(rigid.rows(), motions.rank());
  return fixed;
}

VectorXd solve(const MatrixXd& K, const VectorXd& force) { return K.partialPivLu().solve(force); }

// Newton's method to the stationary shape that is next, be it a saddle.
HarmonicStop settle(const HarmonicEnergy& energy, const Vector2d& target, HarmonicState& shape) {
  constexpr int most_iterations = 20;
  constexpr double tolerance = 1e-8, rounding = 1e-12;
  VectorXd& a = shape.surface.coefficients;
  double before = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const auto at = energy.expand(a);
    if (!at) return HarmonicStop::degenerate;
    const Vector2d multipliers = multipliers_of(*at);
    const MatrixXd fixed = fixed_directions(*at, energy.rigid_motions(a));
    VectorXd miss = VectorXd::Zero(fixed.cols());
    miss.head<2>() = at->measures.tail<2>() - target;
    const VectorXd gradient = at->gradients.col(0) + multipliers[0] * at->gradients.col(1)
                            - multipliers[1] * at->gradients.col(2);
    const model::TangentSplit split(fixed);
    const MatrixXd K = split.rotated(energy.hessian(a, multipliers[0], multipliers[1]));
    // Largest of the misses, and of the derivatives of F/κ + ΣA − PV by unit combinations of coefficients that
    // are no rigid motion.
    const double residual =
        std::max(split.tangential(gradient).cwiseAbs().maxCoeff(), miss.cwiseAbs().maxCoeff());
    if (residual < rounding || (residual < tolerance && residual > 0.1 * before)) {
      const VectorXd curvatures = split.tangential_eigenvalues(K);  // ascending
      shape.energy = at->measures[0] / (8 * pi);
      shape.tension = multipliers[0];
      shape.pressure = multipliers[1];
      shape.negative_directions = int((curvatures.array() < 0).count());
      shape.stiffness = curvatures[0];
      return HarmonicStop::stationary;
    }
    before = residual;
    a += split.newton_step(K, gradient, miss, solve);
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

namespace {

Vector2d target_of(double reduced_volume, int degree) {
  if (!(reduced_volume > 0 && reduced_volume < 1))
    throw std::invalid_argument(
        fmt::format("reduced volume {}: must lie between 0 and 1", reduced_volume));
  if (degree < 4 || degree > 32)
    throw std::invalid_argument(fmt::format("degree {}: must be in [4, 32]", degree));
  return {4 * pi, reduced_volume * 4 * pi / 3};
}

HarmonicState settled(const HarmonicSurface& start, const Vector2d& target) {
  HarmonicState shape{.surface = start};
  shape.stop = settle(HarmonicEnergy(start), target, shape);
  return shape;
}

}  // namespace

HarmonicState minimise_harmonics(const HarmonicSurface& start, double reduced_volume, int degree) {
  const Vector2d target = target_of(reduced_volume, degree);
  HarmonicState shape{.stop = HarmonicStop::degenerate,
                      .surface = refitted(start.with_degree(std::max(start.degree, coarse_degree)))
                                     .with_degree(std::min(degree, coarse_degree))};
  HarmonicSurface& surface = shape.surface;
  if (!relax(surface, target)) return shape;
  surface = refitted(surface);  // the shape may be another, or have moved
  if (!relax(surface, target)) return shape;
  return settled(surface.with_degree(degree), target);
}

HarmonicState stationary_harmonics(const HarmonicSurface& start, double reduced_volume,
                                   int degree) {
  return settled(refitted(start.with_degree(degree)), target_of(reduced_volume, degree));
}

}  // namespace sbeh::surface3d
