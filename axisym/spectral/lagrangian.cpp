#include "axisym/spectral/lagrangian.h"

#include "axisym/spectral/point_density.h"

#include <Eigen/QR>
#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sbeh::axisym::spectral {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

using namespace point;

namespace {

// Fields on all points with their Jacobians by the unknowns.
struct Sampled {
  const Problem& problem;
  std::array<VectorXd, fields> value;  // N each
  MatrixXd R;                          // N x n, ∂r/∂b

  Sampled(const Problem& p, const VectorXd& y) : problem(p) {
    const Basis& B = *p.basis;
    const Angles at = angles(spectral::curve_of(p, y));
    R = radius_jacobian(B, at);
    const VectorXd c = order_of(p, y);
    value = {at.psi,
             at.dpsi,
             at.r,
             p.with_order ? VectorXd(B.C * c) : VectorXd::Constant(B.points(), model::full_order),
             p.with_order ? VectorXd(B.dC * c) : VectorXd::Zero(B.points()),
             VectorXd::Constant(B.points(), y[0])};
  }
  Point<double> at(Eigen::Index j) const {
    Point<double> q;
    for (std::size_t f = 0; f < fields; ++f) q[f] = value[f][j];
    return q;
  }
  // ∂(field)/∂(its block of unknowns), N x block.
  const MatrixXd& jacobian(int field) const {
    const Basis& B = *problem.basis;
    switch (field) {
      case psi:
        return B.S;
      case dpsi:
        return B.dS;
      case radius:
        return R;
      case order:
        return B.C;
      default:
        return B.dC;
    }
  }
  // Σ_j of pointwise derivatives times Jacobians: a gradient by y.
  VectorXd pull_back(const MatrixXd& g) const {  // N x fields, weights included
    const int n = problem.basis->modes();
    VectorXd result(problem.unknowns());
    result[0] = g.col(length).sum();
    result.segment(1, n) = jacobian(psi).transpose() * g.col(psi)
                         + jacobian(dpsi).transpose() * g.col(dpsi)
                         + jacobian(radius).transpose() * g.col(radius);
    if (problem.with_order)
      result.tail(problem.order_modes()) =
          jacobian(order).transpose() * g.col(order) + jacobian(dorder).transpose() * g.col(dorder);
    return result;
  }
};

}  // namespace

namespace {

bool is_couple(const model::AreaDifference& ad) { return ad.is_there() && ad.compliance() == 0; }

// Whether the area difference adds to the energy, by W₂.
bool has_moment(const model::Material& m) {
  return m.area_difference.is_there() && !is_couple(m.area_difference);
}

// The closure is even about the poles, all other densities are odd.
const VectorXd& weights(const Basis& basis, std::size_t measure) {
  return measure == std::size_t(Measure::closure) ? basis.even : basis.odd;
}

}  // namespace

std::vector<Measure> Problem::held() const {
  std::vector<Measure> all{Measure::area, Measure::volume};
  if (basis->symmetry == Symmetry::none) all.push_back(Measure::closure);
  if (is_couple(material.area_difference)) all.push_back(Measure::W2);
  if (with_order && material.conserves_order()) all.push_back(Measure::excess_order);
  return all;
}

int Problem::place_of(Measure measure) const {
  const std::vector<Measure> all = held();
  const auto at = std::ranges::find(all, measure);
  return at == all.end() ? -1 : int(at - all.begin());
}

Problem Problem::classical(std::shared_ptr<const Basis> basis) {
  Problem p{.material = {}, .basis = std::move(basis), .with_order = false};
  p.material.L1 = 0;
  p.material.residual_stiffness = 1;
  p.material.potential = model::Potential({0.});
  return p;
}

Problem Problem::of(const model::Material& material, model::Model model,
                    std::shared_ptr<const Basis> basis) {
  const bool is_free = has_free_order(model);
  return {is_free ? material : material.without_gaussian().with_uniform_order(), std::move(basis),
          is_free};
}

VectorXd pack(const Curve& curve, const VectorXd& c) {
  VectorXd y(1 + curve.b.size() + c.size());
  y << curve.length, curve.b, c;
  return y;
}
Curve curve_of(const Problem& problem, const VectorXd& y) {
  return {.basis = problem.basis, .length = y[0], .b = y.segment(1, problem.basis->modes())};
}
VectorXd order_of(const Problem& problem, const VectorXd& y) {
  return y.tail(problem.order_modes());
}

namespace {

// All measures and their gradients, one row each.
struct Measured {
  VectorXd values = VectorXd::Zero(Eigen::Index(measures));
  MatrixXd gradients;
};
Measured measure(const Problem& problem, const Sampled& sampled) {
  const Basis& B = *problem.basis;
  Measured out;
  std::array<MatrixXd, measures> g;
  g.fill(MatrixXd(B.points(), fields));
  for (Eigen::Index j = 0; j < B.points(); ++j) {
    const Point<double> q = sampled.at(j);
    const auto values = measure_densities(problem.material, q);
    const auto gradients = measure_gradients(problem.material, q);
    for (std::size_t i = 0; i < measures; ++i) {
      const double w = weights(B, i)[j];
      out.values[Eigen::Index(i)] += w * values[i];
      for (std::size_t f = 0; f < fields; ++f) g[i](j, Eigen::Index(f)) = w * gradients[i][f];
    }
  }
  out.gradients.resize(Eigen::Index(measures), problem.unknowns());
  for (std::size_t i = 0; i < measures; ++i)
    out.gradients.row(Eigen::Index(i)) = sampled.pull_back(g[i]).transpose();
  return out;
}

// The area difference's share of energy and gradient.
void add_moment(const model::AreaDifference& ad, const Measured& all, Expansion& out) {
  constexpr auto A = Eigen::Index(Measure::area), W = Eigen::Index(Measure::W2);
  const double area = all.values[A], k = ad.compliance();
  out.moment = (all.values[W] - ad.W2) / (area * k);
  out.energy += ad.energy(area, all.values[W]);
  const VectorXd dA = all.gradients.row(A), dW = all.gradients.row(W);
  out.gradient += out.moment * (dW - out.moment * k / 2 * dA);
  out.of_moment = (dW - out.moment * k * dA) / std::sqrt(area * k);
}

}  // namespace

std::optional<Expansion> expand(const Problem& problem, const VectorXd& y) {
  const Sampled sampled(problem, y);
  if (!(y[0] > 0 && sampled.value[radius].minCoeff() > 0)) return {};
  const Eigen::Index N = problem.basis->points();
  Expansion out{.energy = 0, .gradient = {}, .measures = {}, .jacobian = {}, .of_moment = {}};
  MatrixXd g(N, fields);
  for (Eigen::Index j = 0; j < N; ++j) {
    const Point<double> q = sampled.at(j);
    const double w = problem.basis->odd[j];
    out.energy += w * area_density(q) * density(problem.material, q).total();
    const auto energy = energy_gradient(problem.material, q);
    for (std::size_t f = 0; f < fields; ++f) g(j, Eigen::Index(f)) = w * energy[f];
  }
  out.gradient = sampled.pull_back(g);
  const Measured all = measure(problem, sampled);
  const std::vector<Measure> held = problem.held();
  out.measures.resize(Eigen::Index(held.size()));
  out.jacobian.resize(Eigen::Index(held.size()), problem.unknowns());
  for (std::size_t i = 0; i < held.size(); ++i) {
    out.measures[Eigen::Index(i)] = all.values[Eigen::Index(held[i])];
    out.jacobian.row(Eigen::Index(i)) = all.gradients.row(Eigen::Index(held[i]));
  }
  if (has_moment(problem.material)) add_moment(problem.material.area_difference, all, out);
  return out;
}

namespace {

// What multiplies each measure in the Lagrangian, the area difference's share in it.
std::array<double, measures> factors(const Problem& problem, const Multipliers& multipliers,
                                     double moment) {
  std::array<double, measures> all{};
  const std::vector<Measure> held = problem.held();
  for (std::size_t i = 0; i < held.size(); ++i)
    all[std::size_t(held[i])] = multipliers[Eigen::Index(i)];
  if (has_moment(problem.material)) {
    all[std::size_t(Measure::W2)] += moment;
    all[std::size_t(Measure::area)] -=
        moment * moment * problem.material.area_difference.compliance() / 2;
  }
  return all;
}

}  // namespace

MatrixXd hessian(const Problem& problem, const VectorXd& y, const Multipliers& multipliers) {
  using Jet = ceres::Jet<double, fields>;
  const Basis& B = *problem.basis;
  const Sampled sampled(problem, y);
  const Eigen::Index N = B.points(), n = B.modes(), U = problem.unknowns();
  const auto at = has_moment(problem.material) ? expand(problem, y) : std::nullopt;
  const auto factor = factors(problem, multipliers, at ? at->moment : 0);

  // First and second derivatives of the pointwise Lagrangian.
  VectorXd g_radius(N);
  std::array<std::array<VectorXd, fields>, fields> second;
  for (auto& row : second) row.fill(VectorXd(N));
  for (Eigen::Index j = 0; j < N; ++j) {
    Point<Jet> q;
    for (std::size_t f = 0; f < fields; ++f) q[f] = Jet(sampled.value[f][j], int(f));
    Point<Jet> g = energy_gradient(problem.material, q);
    const auto gradients = measure_gradients(problem.material, q);
    for (std::size_t f = 0; f < fields; ++f) {
      g[f] *= B.odd[j];
      for (std::size_t i = 0; i < measures; ++i)
        if (factor[i] != 0) g[f] += factor[i] * weights(B, i)[j] * gradients[i][f];
      for (std::size_t h = 0; h < fields; ++h) second[f][h][j] = g[f].v[Eigen::Index(h)];
    }
    g_radius[j] = g[radius].a;
  }

  // Σ_j Dᵀ (second derivatives) D, block by block of the unknowns.
  MatrixXd result = MatrixXd::Zero(U, U);
  const auto add = [&](std::initializer_list<std::size_t> rows, Eigen::Index first,
                       std::initializer_list<std::size_t> columns, Eigen::Index from) {
    for (const std::size_t f : rows) {
      const MatrixXd& D = sampled.jacobian(int(f));
      MatrixXd T = MatrixXd::Zero(N, sampled.jacobian(int(*columns.begin())).cols());
      for (const std::size_t h : columns) T += second[f][h].asDiagonal() * sampled.jacobian(int(h));
      result.block(first, from, D.cols(), T.cols()).noalias() += D.transpose() * T;
    }
  };
  const auto add_length = [&](std::initializer_list<std::size_t> rows, Eigen::Index first) {
    for (const std::size_t f : rows) {
      const VectorXd column = sampled.jacobian(int(f)).transpose() * second[f][length];
      result.block(first, 0, column.size(), 1) += column;
      result.block(0, first, 1, column.size()) += column.transpose();
    }
  };
  result(0, 0) = second[length][length].sum();
  add({psi, dpsi, radius}, 1, {psi, dpsi, radius}, 1);
  add_length({psi, dpsi, radius}, 1);
  if (problem.with_order) {
    add({order, dorder}, 1 + n, {psi, dpsi, radius}, 1);
    const Eigen::Index c = problem.order_modes();
    result.block(1, 1 + n, n, c) = result.block(1 + n, 1, c, n).transpose();
    add({order, dorder}, 1 + n, {order, dorder}, 1 + n);
    add_length({order, dorder}, 1 + n);
  }
  // r = M cos ψ is curved in b.
  const VectorXd bend = sampled.value[psi].array().cos() * (B.M.transpose() * g_radius).array();
  result.block(1, 1, n, n).noalias() -= B.S.transpose() * (bend.asDiagonal() * B.S);
  if (at) result.noalias() += at->of_moment * at->of_moment.transpose();
  return result;
}

model::EnergyDensity<double> energy_parts(const Problem& problem, const VectorXd& y) {
  const Sampled sampled(problem, y);
  model::EnergyDensity<double> sum{};
  for (Eigen::Index j = 0; j < problem.basis->points(); ++j) {
    const Point<double> q = sampled.at(j);
    const double dA = problem.basis->odd[j] * area_density(q);
    const auto e = density(problem.material, q);
    sum.distortion += dA * e.distortion;
    sum.bending += dA * e.bending;
    sum.gaussian += dA * e.gaussian;
    sum.thermotropic += dA * e.thermotropic;
  }
  return sum;
}

VectorXd mean_curvature(const Curve& curve) {
  const Angles at = angles(curve);
  return -(at.dpsi.array() + at.psi.array().sin() / at.r.array()) / curve.length;
}

Eigen::Vector2d pole_curvatures(const Curve& curve) {
  double first = pi, last = pi;
  for (std::size_t i = 0; i < curve.basis->k.size(); ++i) {
    const int k = curve.basis->k[i];
    const double slope = k * pi * curve.b[Eigen::Index(i)];
    first += slope, last += k % 2 == 0 ? slope : -slope;
  }
  const Grading& grading = curve.basis->grading;
  return -2 / curve.length * Eigen::Vector2d(first / grading.slope(0), last / grading.slope(1));
}

VectorXd target_of(const Problem& problem, double reduced_volume) {
  const std::vector<Measure> held = problem.held();
  VectorXd target = VectorXd::Zero(Eigen::Index(held.size()));
  target.head(2) << 4 * pi, 4 * pi / 3 * reduced_volume;
  if (const int at = problem.place_of(Measure::W2); at >= 0)
    target[at] = problem.material.area_difference.W2;
  return target;
}

Multipliers estimate_multipliers(const Expansion& at) {
  return at.jacobian.transpose().householderQr().solve(-at.gradient);
}

}  // namespace sbeh::axisym::spectral
