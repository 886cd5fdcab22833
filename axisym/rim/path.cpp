#include "axisym/rim/path.h"

#include "model/numerics/constrained_newton.h"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace sbeh::axisym::spectral {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

namespace {

// ∂(gradient)/∂L: the energy is linear in L.
VectorXd gradient_rate(const RimProblem& problem, const VectorXd& y) {
  return expand(problem.at(1), y)->gradient - expand(problem.at(0), y)->gradient;
}

// The linearised equations in (y, multipliers, L) with a last row over (y, L).
struct Linearised {
  MatrixXd matrix;
  VectorXd residual;  // without the last
};
std::optional<Linearised> linearise(const RimProblem& problem, const RimState& s,
                                    const VectorXd& row) {
  if (!(s.L > 0)) return {};
  const Problem at = problem.at(s.L);
  const auto e = expand(at, s.y);
  if (!e) return {};
  const Index n = s.y.size(), m = s.multipliers.size(), last = n + m;
  Linearised out{MatrixXd::Zero(last + 1, last + 1), VectorXd(last)};
  out.matrix.topLeftCorner(n, n) = hessian(at, s.y, s.multipliers);
  out.matrix.block(0, n, n, m) = e->jacobian.transpose();
  out.matrix.block(n, 0, m, n) = e->jacobian;
  out.matrix.block(0, last, n, 1) = gradient_rate(problem, s.y);
  out.matrix.row(last).head(n) = row.head(n).transpose();
  out.matrix(last, last) = row[n];
  out.residual << e->gradient + e->jacobian.transpose() * s.multipliers,
      e->measures - problem.target();
  return out;
}

// With the last equation row·(y, L) = value.
std::optional<double> newton_step(const RimProblem& problem, RimState& s, const VectorXd& row,
                                  double value) {
  const Index n = s.y.size(), m = s.multipliers.size();
  const auto system = linearise(problem, s, row);
  if (!system) return {};
  VectorXd miss(n + m + 1);
  miss << system->residual, row.head(n).dot(s.y) + row[n] * s.L - value;
  const VectorXd step = -system->matrix.partialPivLu().solve(miss);
  s.y += step.head(n);
  s.multipliers += step.segment(n, m);
  s.L += step[n + m];
  return step.head(n).cwiseAbs().maxCoeff();
}

VectorXd along_L(Index n) { return VectorXd::Unit(n + 1, n); }

// Weights of the length: the mean over y, and L.
VectorXd weighted(VectorXd tangent) {
  const Index n = tangent.size() - 1;
  tangent.head(n) /= double(n);
  return tangent;
}

}  // namespace

VectorXd RimProblem::angles_at_nodes(const VectorXd& y) const {
  VectorXd psi = pi * rim_nodes(mesh);  // the base, exact where the rim prescribes it
  psi.segment(1, basis->S.cols()) += y.segment(1, basis->S.cols());
  return psi;
}

VectorXd RimProblem::order_at_nodes(const VectorXd& y) const {
  VectorXd beta = VectorXd::Zero(mesh.elements * mesh.degree + 1);
  beta.head(basis->C.cols()) = y.tail(basis->C.cols());
  return beta;
}

VectorXd RimProblem::unknowns(double length, const VectorXd& psi, const VectorXd& beta) const {
  const VectorXd base = pi * rim_nodes(mesh);
  VectorXd y(1 + basis->S.cols() + basis->C.cols());
  y << length, (psi - base).segment(1, basis->S.cols()), beta.head(basis->C.cols());
  return y;
}

std::optional<RimState> solve(const RimProblem& problem, RimState guess) {
  const double L = guess.L;
  const VectorXd row = along_L(guess.y.size());
  const auto step = [&](RimState& s) { return newton_step(problem, s, row, L); };
  return model::converges(guess, RimProblem::limits, step) ? std::optional(guess) : std::nullopt;
}

std::optional<RimState> minimise(const RimProblem& problem, double L, const VectorXd& y) {
  const auto found = spectral::minimise(problem.at(L), problem.target(), y);
  if (!found) return {};
  return RimState{L, found->y, found->multipliers};
}

std::optional<RimPathState> with_tangent(const RimProblem& problem, const RimState& s,
                                         const VectorXd* forward) {
  const Index n = s.y.size(), m = s.multipliers.size();
  const auto system = linearise(problem, s, forward ? weighted(*forward) : along_L(n));
  if (!system) return {};
  const VectorXd whole = system->matrix.partialPivLu().solve(VectorXd::Unit(n + m + 1, n + m));
  if (!whole.allFinite()) return {};
  VectorXd tangent(n + 1);
  tangent << whole.head(n), whole[n + m];
  return RimPathState{s, tangent / std::sqrt(tangent.dot(weighted(tangent)))};
}

std::optional<RimState> predicted(const RimProblem& problem, const RimPathState& from, double ds) {
  RimState guess = from;
  guess.y += ds * from.tangent.head(guess.y.size());
  guess.L += ds * from.slope();
  if (!(guess.L > 0)) return {};
  const auto e = expand(problem.at(guess.L), guess.y);
  if (!e) return {};
  guess.multipliers = estimate_multipliers(*e);
  return guess;
}

std::optional<double> newton_step(const RimProblem& problem, RimState& s, const RimPathState& from,
                                  double ds) {
  const Index n = s.y.size();
  const VectorXd row = weighted(from.tangent);
  return newton_step(problem, s, row, row.head(n).dot(from.y) + row[n] * from.L + ds);
}

bool continues(const RimProblem& /*problem*/, const RimPathState& from, const RimPathState& next,
               double /*ds*/) {
  return weighted(next.tangent).dot(from.tangent) > model::least_cosine;
}

namespace {

// Negative eigenvalues of H among the directions that these rows (one each) map to zero. The unknowns are
// scaled to diagonal entries of 1: those of the smallest elements would drown the others in rounding.
int negative_among(MatrixXd H, MatrixXd rows) {
  const VectorXd scale = H.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  H = scale.asDiagonal() * H * scale.asDiagonal();
  rows = rows * scale.asDiagonal();
  const model::TangentSplit split(rows.transpose());
  return int((split.tangential_eigenvalues(split.rotated(H)).array() < 0).count());
}

}  // namespace

int negative_directions(const RimProblem& problem, const RimState& s) {
  const RimProblem free(problem.material, problem.reduced_volume, Rim::free, problem.mesh);
  const VectorXd y =
      free.unknowns(s.y[0], problem.angles_at_nodes(s.y), problem.order_at_nodes(s.y));
  const Problem at = free.at(s.L);
  const MatrixXd H = hessian(at, y, s.multipliers);
  const Basis& B = *free.basis;
  const Index n = B.modes(), order_at_rim = y.size() - 1, angle_at_rim = n;

  // Both halves vary alike: the rim keeps what is prescribed there.
  MatrixXd alike = MatrixXd::Zero(3, y.size());
  alike.topRows(2) = expand(at, y)->jacobian;
  alike(2, problem.rim == Rim::smooth ? angle_at_rim : order_at_rim) = 1;

  // They vary oppositely, which keeps area and volume: radius ℓ∫cos ψ dσ and order of the rim, which they
  // share, cannot change. A smooth rim is no point of its own: where the curve is divided is not counted.
  const Angles angles = spectral::angles(curve_of(at, y));
  MatrixXd opposite = MatrixXd::Zero(problem.rim == Rim::smooth ? 3 : 2, y.size());
  opposite(0, 0) = B.even.dot(angles.psi.array().cos().matrix());
  opposite.row(0).segment(1, n) =
      -s.y[0] * (B.even.array() * angles.psi.array().sin()).matrix().transpose() * B.S;
  opposite(1, order_at_rim) = 1;
  if (problem.rim == Rim::smooth) opposite(2, 0) = 1;
  return negative_among(H, alike) + negative_among(H, opposite);
}

namespace {

constexpr int parts = 9;  // of an element: three P3 elements

// Values over one element, from those at its nodes.
class Interpolant {
 public:
  Interpolant(const VectorXd& nodes, const VectorXd& values) : nodes_(nodes), values_(values) {
    weights_.resize(nodes.size());
    const double scale = 4 / (nodes[nodes.size() - 1] - nodes[0]);  // keeps the products near 1
    for (Index i = 0; i < nodes.size(); ++i) {
      double product = 1;
      for (Index j = 0; j < nodes.size(); ++j)
        if (j != i) product *= (nodes[i] - nodes[j]) * scale;
      weights_[i] = 1 / product;
    }
  }
  double operator()(double x) const {  // barycentric
    double above = 0, below = 0;
    for (Index i = 0; i < nodes_.size(); ++i) {
      if (x == nodes_[i]) return values_[i];
      const double share = weights_[i] / (x - nodes_[i]);
      above += share * values_[i];
      below += share;
    }
    return above / below;
  }

 private:
  VectorXd nodes_, values_, weights_;
};

}  // namespace

State profile_of(const RimProblem& problem, const VectorXd& y) {
  const VectorXd sigma = rim_nodes(problem.mesh), psi = problem.angles_at_nodes(y),
                 beta = problem.order_at_nodes(y);
  const int degree = problem.mesh.degree, half = problem.mesh.elements * parts;
  State state{.X = Nodes::Zero(2, 2 * half + 1), .beta = Field(2 * half + 1)};
  state.beta[0] = beta[0];
  double r = 0, z = 0;
  for (int e = 0; e < problem.mesh.elements; ++e) {
    const VectorXd at = sigma.segment(e * degree, degree + 1);
    const Interpolant angle(at, psi.segment(e * degree, degree + 1)),
        order(at, beta.segment(e * degree, degree + 1));
    const double step = (at[degree] - at[0]) / parts;
    for (int k = 0; k < parts; ++k) {
      for (const ShapeValues& s : diagnostic_points()) {
        const double a = angle(at[0] + (k + s.x) * step), ds = y[0] * step * s.weight;
        r += ds * std::cos(a);
        z -= ds * std::sin(a);
      }
      const Index node = e * parts + k + 1;
      state.X.col(node) << r, z;
      state.beta[node] = k + 1 == parts ? beta[(e + 1) * degree] : order(at[0] + (k + 1) * step);
    }
  }
  state.X.row(1).array() -= z;  // the equator
  for (Index i = 0; i < half; ++i) {
    state.X.col(2 * half - i) << state.X(0, i), -state.X(1, i);
    state.beta[2 * half - i] = state.beta[i];
  }
  return state;
}

}  // namespace sbeh::axisym::spectral
