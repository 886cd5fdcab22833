#include "axisym/spectral/lagrangian.h"

#include "model/terms.h"

#include <Eigen/QR>
#include <ceres/jet.h>

#include <array>
#include <cmath>
#include <numbers>

namespace sbeh::axisym::spectral {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

// The fields that the pointwise density reads, in this order everywhere.
enum Field { psi, dpsi, radius, order, dorder, length, fields };
template <class T>
using Point = std::array<T, fields>;

template <class T>
struct Curvatures {
  T H, K;
};
template <class T>
Curvatures<T> curvatures(const Point<T>& q) {
  const T turn = sin(q[psi]) / q[radius];
  return {.H = -(q[dpsi] + turn) / q[length], .K = q[dpsi] * turn / (q[length] * q[length])};
}

template <class T>
model::EnergyDensity<T> density(const model::Material& material, const Point<T>& q) {
  const T slope = q[dorder] / q[length];
  const auto [H, K] = curvatures(q);
  return model::energy_density(material, q[order], T(slope * slope), H, K);
}

// dA per σ.
template <class T>
T area_density(const Point<T>& q) {
  return 2 * pi * q[length] * q[length] * q[radius];
}

// Derivatives of dU by the fields: the chain rule through H, K and |∇β|².
template <class T>
Point<T> energy_gradient(const model::Material& m, const Point<T>& q) {
  using std::cos, std::sin;
  const T &l = q[length], &r = q[radius], &beta = q[order];
  const T slope = q[dorder] / l, turn = sin(q[psi]) / r, turn_psi = cos(q[psi]) / r;
  const auto [H, K] = curvatures(q);
  const T e = density(m, q).total();
  const T e_H = m.moment(beta, H), e_K = m.kappa_gauss(beta);
  const T e_beta = model::order_force(m, beta, H, K);
  const T e_slope = m.l1() * slope;
  const T e_turn = -e_H / l + e_K * q[dpsi] / (l * l);
  const T dA = area_density(q);
  return {dA * e_turn * turn_psi,
          dA * (-e_H / l + e_K * turn / (l * l)),
          dA * (e / r - e_turn * turn / r),
          dA * e_beta,
          dA * e_slope / l,
          dA / l * (2. * e - e_slope * slope - e_H * H - 2. * e_K * K)};
}

// Derivatives of dA, dV and of the closure.
template <class T>
std::array<Point<T>, 3> measure_gradients(const Point<T>& q) {
  using std::cos, std::sin;
  const T &l = q[length], &r = q[radius];
  const T s = sin(q[psi]), zero(0.);
  return {{{zero, zero, 2 * pi * l * l, zero, zero, 4 * pi * l * r},
           {pi * l * l * l * r * r * cos(q[psi]), zero, 2 * pi * l * l * l * r * s, zero, zero,
            3 * pi * l * l * r * r * s},
           {-s, zero, zero, zero, zero, zero}}};
}

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

Problem Problem::classical(std::shared_ptr<const Basis> basis) {
  Problem p{.material = {}, .basis = std::move(basis), .with_order = false};
  p.material.L1 = 0;
  p.material.residual_stiffness = 1;
  p.material.potential = model::Potential({0.});
  return p;
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

std::optional<Expansion> expand(const Problem& problem, const VectorXd& y) {
  const Sampled sampled(problem, y);
  if (!(y[0] > 0 && sampled.value[radius].minCoeff() > 0)) return {};
  const Eigen::Index N = problem.basis->points();
  Expansion out{.energy = 0, .gradient = {}, .measures = VectorXd::Zero(3), .jacobian = {}};
  MatrixXd g(N, fields);
  std::array<MatrixXd, 3> m{MatrixXd(N, fields), MatrixXd(N, fields), MatrixXd(N, fields)};
  for (Eigen::Index j = 0; j < N; ++j) {
    const Point<double> q = sampled.at(j);
    const double w = problem.basis->odd[j];
    const double dA = w * area_density(q), rho = q[length] * q[radius];
    out.energy += dA * density(problem.material, q).total();
    out.measures[0] += dA;
    out.measures[1] += w * pi * rho * rho * q[length] * std::sin(q[psi]);
    out.measures[2] += problem.basis->even[j] * std::cos(q[psi]);
    const auto energy = energy_gradient(problem.material, q);
    const auto measures = measure_gradients(q);
    for (std::size_t f = 0; f < fields; ++f) {
      g(j, Eigen::Index(f)) = w * energy[f];
      for (std::size_t i = 0; i < 3; ++i)
        m[i](j, Eigen::Index(f)) = (i == 2 ? problem.basis->even[j] : w) * measures[i][f];
    }
  }
  out.gradient = sampled.pull_back(g);
  const int count = problem.constraints();
  out.measures = out.measures.head(count).eval();
  out.jacobian.resize(count, problem.unknowns());
  for (int i = 0; i < count; ++i)
    out.jacobian.row(i) = sampled.pull_back(m[std::size_t(i)]).transpose();
  return out;
}

MatrixXd hessian(const Problem& problem, const VectorXd& y, const Multipliers& multipliers) {
  using Jet = ceres::Jet<double, fields>;
  const Basis& B = *problem.basis;
  const Sampled sampled(problem, y);
  const Eigen::Index N = B.points(), n = B.modes(), U = problem.unknowns();

  // First and second derivatives of the pointwise Lagrangian.
  VectorXd g_radius(N);
  std::array<std::array<VectorXd, fields>, fields> second;
  for (auto& row : second) row.fill(VectorXd(N));
  for (Eigen::Index j = 0; j < N; ++j) {
    Point<Jet> q;
    for (std::size_t f = 0; f < fields; ++f) q[f] = Jet(sampled.value[f][j], int(f));
    Point<Jet> g = energy_gradient(problem.material, q);
    const auto measures = measure_gradients(q);
    for (std::size_t f = 0; f < fields; ++f) {
      g[f] *= B.odd[j];
      for (Eigen::Index i = 0; i < multipliers.size(); ++i)
        g[f] += multipliers[i] * (i == 2 ? B.even[j] : B.odd[j]) * measures[std::size_t(i)][f];
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
  return Eigen::Vector3d(4 * pi, 4 * pi / 3 * reduced_volume, 0).head(problem.constraints());
}

Multipliers estimate_multipliers(const Expansion& at) {
  return at.jacobian.transpose().householderQr().solve(-at.gradient);
}

}  // namespace sbeh::axisym::spectral
