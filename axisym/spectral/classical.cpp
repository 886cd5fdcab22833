#include "axisym/spectral/classical.h"

#include "model/numerics/constrained_squares.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym::spectral {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

std::shared_ptr<const Basis> basis_for(Branch branch, double reduced_volume, int cutoff) {
  if (branch != Branch::stomatocyte) return basis(Symmetry::top_bottom, cutoff);
  // Width and place of the rim along the branch, fitted for 0.1 < V_r < 0.66.
  const double v = reduced_volume;
  return basis(
      Symmetry::none, cutoff,
      {.a = 1 - 0.08 * std::pow(0.72, (0.65 - v) / 0.1), .x0 = 0.5 - 0.053 * v - 0.03 * v * v});
}

namespace {

// Highest wave number that suffices for most shapes of the branch.
int usual_cutoff(Branch branch) { return branch == Branch::stomatocyte ? 72 : 36; }

// f = √(2πr) (ψ' + sin ψ/r), so that ½ Σ f² = F/κ; and its Jacobian by length and angle.
VectorXd root_curvature(const Basis& B, const Angles& x, MatrixXd* by_y) {
  const Index N = B.points(), n = B.modes();
  const VectorXd root = (2 * pi * B.odd.array() * x.r.array()).sqrt();
  const VectorXd turn = x.psi.array().sin() / x.r.array();
  const VectorXd f = root.array() * (x.dpsi + turn).array();
  if (by_y) {
    const VectorXd by_psi = root.array() * x.psi.array().cos() / x.r.array();
    const VectorXd by_r = (f.array() / 2 - root.array() * turn.array()) / x.r.array();
    *by_y = MatrixXd::Zero(N, 1 + n);
    by_y->rightCols(n) = by_psi.asDiagonal() * B.S;
    by_y->rightCols(n) += root.asDiagonal() * B.dS;
    by_y->rightCols(n) += by_r.asDiagonal() * radius_jacobian(B, x);
  }
  return f;
}

// Minimises over the curves of this problem's basis by least squares: the residuals are √dS H and the
// shifted penalties of area, volume and closure. Leaves errors of about 1e-5 in the measures; empty if
// a curve ran into the axis.
std::optional<VectorXd> minimise_squares(const Problem& classical, const VectorXd& target,
                                         VectorXd y) {
  const std::optional<Expansion> first = expand(classical, y);
  if (!first) return {};
  const model::ConstrainedSquares squares{
      .residuals = classical.basis->points(),
      .unknowns = classical.unknowns(),
      .target = target,
      .evaluate =
          [&](const VectorXd& at, auto& values, auto* wanted) {
            const std::optional<Expansion> e = expand(classical, at);
            if (!e) return false;
            values = {root_curvature(*classical.basis, angles(curve_of(classical, at)),
                                     wanted ? &wanted->residuals : nullptr),
                      e->measures};
            if (wanted) wanted->measures = e->jacobian;
            return true;
          },
      .penalty = 1e4,
      .function_tolerance = 1e-8,
      .most_iterations = 1000,
      .normal_equations = false};
  int iterations = 0;
  if (!model::minimise_squares(squares, estimate_multipliers(*first), y, iterations)) return {};
  return y;
}

// Least squares on a coarse basis, then Newton's method with as many modes as it takes.
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

}  // namespace

std::optional<ClassicalMinimum> sharpen(Branch branch, double reduced_volume, const Curve& start) {
  const Problem problem = Problem::classical(start.basis);
  const auto state = minimise(problem, target_of(problem, reduced_volume), pack(start));
  if (!state || !is_of_class(branch, curve_of(problem, state->y))) return {};
  return ClassicalMinimum{reduced_volume, problem, *state};
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
