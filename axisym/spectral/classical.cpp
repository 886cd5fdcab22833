#include "axisym/spectral/classical.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::axisym::spectral {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

// Residuals f with ½ Σ f² = F/κ + ½μ Σ (measure − target + λ/μ)².
class SquaredCurvature : public ceres::CostFunction {
 public:
  SquaredCurvature(const Problem& problem, const VectorXd& target, double penalty)
      : problem_(problem), target_(target), root_(std::sqrt(penalty)) {
    set_num_residuals(problem.basis->points() + problem.constraints());
    mutable_parameter_block_sizes()->push_back(problem.unknowns());
  }

  // Shift λ/μ of the targets.
  VectorXd shift;

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Basis& B = *problem_.basis;
    const Index N = B.points(), n = B.modes(), m = target_.size();
    const VectorXd y = Eigen::Map<const VectorXd>(parameters[0], problem_.unknowns());
    const std::optional<Expansion> at = expand(problem_, y);
    if (!at) return false;

    // f = √(2πr) (ψ' + sin ψ/r)
    const Angles x = angles(curve_of(problem_, y));
    const VectorXd root = (2 * pi * B.odd.array() * x.r.array()).sqrt();
    const VectorXd turn = x.psi.array().sin() / x.r.array();
    Eigen::Map<VectorXd> f(residuals, N + m);
    f.head(N) = root.array() * (x.dpsi + turn).array();
    f.tail(m) = root_ * (at->measures - target_ + shift);

    if (jacobians && jacobians[0]) {
      Eigen::Map<RowMajor> J(jacobians[0], N + m, 1 + n);
      const VectorXd by_psi = root.array() * x.psi.array().cos() / x.r.array();
      const VectorXd by_r = (f.head(N).array() / 2 - root.array() * turn.array()) / x.r.array();
      J.setZero();
      J.block(0, 1, N, n) = by_psi.asDiagonal() * B.S;
      J.block(0, 1, N, n) += root.asDiagonal() * B.dS;
      J.block(0, 1, N, n) += by_r.asDiagonal() * radius_jacobian(B, x);
      J.bottomRows(m) = root_ * at->jacobian;
    }
    return true;
  }

 private:
  const Problem& problem_;
  const VectorXd& target_;
  double root_;
};

}  // namespace

double ClassicalMinimum::reduced_energy() const { return state.energy / (8 * pi); }

std::shared_ptr<const Basis> basis_for(Branch branch, double reduced_volume, int cutoff) {
  if (branch != Branch::stomatocyte) return basis(Symmetry::top_bottom, cutoff);
  // Width and place of the rim along the branch, fitted for 0.1 < V_r < 0.66.
  const double v = reduced_volume;
  return basis(
      Symmetry::none, cutoff,
      {.a = 1 - 0.08 * std::pow(0.72, (0.65 - v) / 0.1), .x0 = 0.5 - 0.053 * v - 0.03 * v * v});
}

int usual_cutoff(Branch branch) { return branch == Branch::stomatocyte ? 72 : 36; }

std::optional<VectorXd> minimise_squares(const Problem& classical, const VectorXd& target,
                                         VectorXd y) {
  constexpr double penalty = 1e4, tolerance = 1e-5;
  constexpr int most_shifts = 10;
  SquaredCurvature cost(classical, target, penalty);
  const std::optional<Expansion> first = expand(classical, y);
  if (!first) return {};
  cost.shift = estimate_multipliers(*first) / penalty;

  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, y.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-8;

  for (int i = 0; i < most_shifts; ++i) {
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (summary.termination_type == ceres::FAILURE) return {};
    const VectorXd miss = expand(classical, y)->measures - target;
    if (miss.cwiseAbs().maxCoeff() < tolerance) break;
    cost.shift += miss;
  }
  return y;
}

std::optional<ClassicalMinimum> sharpen(Branch branch, double reduced_volume, const Curve& start) {
  const Problem problem = Problem::classical(start.basis);
  const auto state = minimise(problem, target_of(problem, reduced_volume), pack(start));
  if (!state || !is_of_class(branch, curve_of(problem, state->y))) return {};
  return ClassicalMinimum{reduced_volume, problem, *state};
}

std::optional<ClassicalMinimum> minimum_from(Branch branch, double reduced_volume,
                                             const Curve& start) {
  constexpr double resolved = 1e-11;
  constexpr int coarse_cutoff = 36, most = 250;
  const Problem coarse = Problem::classical(basis_for(branch, reduced_volume, coarse_cutoff));
  const auto near = minimise_squares(coarse, target_of(coarse, reduced_volume),
                                     pack(on_basis(start, coarse.basis)));
  if (!near) return {};
  Curve curve = curve_of(coarse, *near);
  for (int cutoff = usual_cutoff(branch); cutoff <= most; cutoff = cutoff * 3 / 2) {
    const auto found =
        sharpen(branch, reduced_volume, on_basis(curve, basis_for(branch, reduced_volume, cutoff)));
    if (!found || tail(found->state.y) < resolved) return found;
    curve = found->curve();
  }
  return {};
}

std::optional<ClassicalMinimum> minimum(Branch branch, double reduced_volume) {
  constexpr int cutoff = 12;  // what a start shape needs
  const auto start_basis = basis_for(branch, reduced_volume, cutoff);
  if (branch != Branch::stomatocyte)
    return minimum_from(branch, reduced_volume,
                        spheroid(reduced_volume, branch == Branch::prolate, start_basis));
  constexpr double safe = 0.6;  // closer to the end of the branch the basin is narrow
  const double first = std::min(reduced_volume, safe);
  const auto found = minimum_from(branch, first, invaginated_sphere(first, start_basis));
  if (!found || first == reduced_volume) return found;
  return minimum_along(branch, reduced_volume, first, found->curve());
}

std::optional<ClassicalMinimum> minimum_along(Branch branch, double reduced_volume, double v,
                                              Curve curve) {
  constexpr double longest = 0.06;
  constexpr double end = 0.6613;  // of stomatocytes, or just beyond: only to choose steps
  while (true) {
    double step = std::clamp(reduced_volume - v, -longest, longest);
    if (branch == Branch::stomatocyte && step > 0) step = std::min(step, 0.6 * (end - v));
    v += step;
    if (std::abs(reduced_volume - v) < 1e-12) return minimum_from(branch, reduced_volume, curve);
    if (std::abs(step) < 1e-4) return {};
    const auto next =
        sharpen(branch, v, on_basis(curve, basis_for(branch, v, usual_cutoff(branch))));
    if (!next) return {};
    curve = next->curve();
  }
}

double tail(const VectorXd& coefficients) {
  return coefficients.tail(std::max<Index>(2, coefficients.size() / 10)).cwiseAbs().maxCoeff();
}

bool is_of_class(Branch branch, const Curve& curve) {
  const Eigen::Vector2d H = pole_curvatures(curve);
  if (branch == Branch::stomatocyte) return H[0] > 0 && H[1] < 0;
  if (curve.basis->symmetry == Symmetry::none) return false;
  const double height = std::abs(pole_distance(curve));
  const double width = 2 * curve.length * angles(curve).r.maxCoeff();
  return (height > width) == (branch == Branch::prolate);
}

}  // namespace sbeh::axisym::spectral
