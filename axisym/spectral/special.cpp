#include "axisym/spectral/special.h"

#include "model/numerics/constrained_newton.h"
#include "model/numerics/root.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sbeh::axisym::spectral {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double last_change = 1e-14;  // of the secants
constexpr double sphere = 4 * std::numbers::pi / 3;
struct Lost {};

// Positions of the unknowns of a whole curve that are odd under reflection: b_k and c_k with odd k.
std::vector<Index> odd_unknowns(const Problem& whole) {
  std::vector<Index> odd;
  const Index n = whole.basis->modes();
  for (Index i = 1; i <= n; i += 2) odd.push_back(i);
  for (Index k = 1; k < whole.order_modes(); k += 2) odd.push_back(1 + n + k);
  return odd;
}

// A critical point of the Lagrangian where it crosses the plane direction·y = t: the volume is an unknown there, and the
// branch goes on through its fold.
class Crossing {
 public:
  Crossing(const Problem& problem, const Critical& start, VectorXd direction)
      : problem_(problem),
        direction_(std::move(direction)),
        target_(target_of(problem, 0)),
        y_(start.y),
        multipliers_(start.multipliers),
        tangent_(direction_) {}

  // Moves to this plane, in short steps; the change of the volume along the branch, by t.
  double slope_at(double t) {
    constexpr double longest = 0.05;
    double way = t - direction_.dot(y_);
    for (; std::abs(way) > longest; way = t - direction_.dot(y_))
      step_to(t - way + std::copysign(longest, way));
    return step_to(t);
  }
  // The state there.
  BranchPoint state() const {
    const std::optional<Expansion> e = expand(problem_, y_);
    const model::TangentSplit split(e->jacobian.transpose());
    const VectorXd eigenvalues =
        split.tangential_eigenvalues(split.rotated(hessian(problem_, y_, multipliers_)));
    return {
        volume_ / sphere,
        {.y = y_,
         .multipliers = multipliers_,
         .energy = e->energy,
         .residual = (e->gradient + e->jacobian.transpose() * multipliers_).cwiseAbs().maxCoeff(),
         .stiffness = eigenvalues[0],
         .negative_directions = int((eigenvalues.array() < 0).count())}};
  }

 private:
  double step_to(double t) {
    constexpr int most_iterations = 20;
    const Index U = y_.size(), m = multipliers_.size(), volume = U + 1;
    y_ += (t - direction_.dot(y_)) * tangent_;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_iterations; ++i) {
      const std::optional<Expansion> e = expand(problem_, y_);
      if (!e) throw Lost{};
      MatrixXd bordered = MatrixXd::Zero(U + m, U + m);
      bordered.topLeftCorner(U, U) = hessian(problem_, y_, multipliers_);
      bordered.topRightCorner(U, m) = e->jacobian.transpose();
      bordered.bottomLeftCorner(m, U) = e->jacobian;
      bordered.block(volume, 0, 1, U) = direction_.transpose();  // in place of the volume
      VectorXd residual(U + m);
      residual << e->gradient + e->jacobian.transpose() * multipliers_, e->measures - target_;
      residual[volume] = direction_.dot(y_) - t;
      const Eigen::PartialPivLU<MatrixXd> lu(bordered);
      const VectorXd step = lu.solve(-residual);
      tangent_ = lu.solve(VectorXd::Unit(U + m, volume)).head(U);
      volume_ = e->measures[1];
      const double change = step.head(U).norm();
      if (change < 1e-12 || (change < 1e-8 && change > before / 2))
        return e->jacobian.row(1).dot(tangent_);
      if (!(change < 1)) break;
      before = change;
      y_ += step.head(U), multipliers_ += step.tail(m);
    }
    throw Lost{};
  }
  const Problem& problem_;
  VectorXd direction_, target_, y_, multipliers_, tangent_;
  double volume_ = 0;
};

}  // namespace

std::optional<Critical> Branchlet::at(double reduced_volume) {
  auto found = critical_point(problem_, target_of(problem_, reduced_volume), y_);
  if (found) y_ = found->y;
  return found;
}

// The multiplier of the closure vanishes on symmetric shapes, its derivative by odd ones does not; those of all other
// measures do.
double odd_stiffness(const Problem& symmetric, const Critical& state) {
  const Basis& half = *symmetric.basis;
  const Problem whole = symmetric.on(basis(Symmetry::none, half.cutoff, half.grading));
  const Index n = half.modes();
  VectorXd y = VectorXd::Zero(whole.unknowns());
  y[0] = state.y[0];
  for (Index i = 0; i < n; ++i) y[half.k[std::size_t(i)]] = state.y[1 + i];
  for (Index i = 0; i < symmetric.order_modes(); ++i)
    y[1 + whole.basis->modes() + (i == 0 ? 0 : half.k[std::size_t(i - 1)])] = state.y[1 + n + i];
  VectorXd multipliers = VectorXd::Zero(whole.constraints());
  const std::vector<Measure> held = symmetric.held();
  for (std::size_t i = 0; i < held.size(); ++i)
    multipliers[whole.place_of(held[i])] = state.multipliers[Index(i)];
  const std::vector<Index> odd = odd_unknowns(whole);
  const VectorXd closure = expand(whole, y)->jacobian.row(whole.place_of(Measure::closure));
  const model::TangentSplit split(closure(odd));
  return split.tangential_eigenvalues(split.rotated(hessian(whole, y, multipliers)(odd, odd)))[0];
}

std::optional<BranchPoint> symmetry_loss(Branchlet& branch, double a, double b) {
  std::optional<Critical> last;
  const auto stiffness = [&](double v) {
    last = branch.at(v);
    if (!last) throw Lost{};
    return odd_stiffness(branch.problem(), *last);
  };
  try {
    const double v = model::root_near(a, b, stiffness, last_change);
    return BranchPoint{v, *last};
  } catch (const Lost&) {
    return {};
  }
}

std::optional<BranchPoint> fold(const Problem& problem, const Critical& before,
                                const Critical& after) {
  const VectorXd direction = (after.y - before.y).normalized();
  Crossing at(problem, after, direction);
  try {
    model::root_near(
        direction.dot(after.y), direction.dot(before.y), [&](double t) { return at.slope_at(t); },
        last_change);
    return at.state();
  } catch (const Lost&) {
    return {};
  }
}

}  // namespace sbeh::axisym::spectral
