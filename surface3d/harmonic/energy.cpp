#include "surface3d/harmonic/energy.h"

#include "model/numerics/second_order.h"

#include <ceres/jet.h>

#include <array>
#include <cmath>

namespace sbeh::surface3d {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using First = ceres::Jet<double, jet_size>;
using Second = model::SecondOrder<jet_size>;
using Jets = Eigen::Matrix<double, jet_size, Eigen::Dynamic>;  // of u, per point

namespace {

template <class T>
using Vector = std::array<T, 3>;
template <class T>
T dot(const Vector<T>& x, const Vector<T>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
template <class T>
Vector<T> cross(const Vector<T>& x, const Vector<T>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}

// plain + frame (e1, e2, omega)
template <class T>
Vector<T> displaced(const Vector3d& plain, const Matrix3d& frame, const T& e1, const T& e2,
                    const T& omega) {
  Vector<T> x;
  for (int i = 0; i < 3; ++i)
    x[std::size_t(i)] = plain[i] + (frame(i, 0) * e1 + frame(i, 1) * e2 + frame(i, 2) * omega);
  return x;
}

// Per area of the unit sphere: J = dS, dV = x·ν/3 dS; and H.
template <class T>
struct Geometry {
  T J, dV, H;
};

// Of x = (D + u T) ω, in normal coordinates about ω: ω_s = e1, ω_t = e2, ω_ss = ω_tt = −ω, ω_st = 0. The
// columns of D and T are those of the frame (e1, e2, ω) under either.
template <class S>
Geometry<S> geometry(const Matrix3d& D, const Matrix3d& T, const std::array<S, jet_size>& jet) {
  const auto& [u, u_s, u_t, u_ss, u_st, u_tt] = jet;
  const S none(0.);
  const Vector3d zero = Vector3d::Zero(), inward = -D.col(2);
  const Vector<S> x = displaced<S>(D.col(2), T, none, none, u);
  const Vector<S> x_s = displaced<S>(D.col(0), T, u, none, u_s);
  const Vector<S> x_t = displaced<S>(D.col(1), T, none, u, u_t);
  const Vector<S> x_ss = displaced<S>(inward, T, 2. * u_s, none, u_ss - u);
  const Vector<S> x_st = displaced<S>(zero, T, u_t, u_s, u_st);
  const Vector<S> x_tt = displaced<S>(inward, T, none, 2. * u_t, u_tt - u);
  const Vector<S> n = cross(x_s, x_t);  // J ν
  const S E = dot(x_s, x_s), F = dot(x_s, x_t), G = dot(x_t, x_t);
  const S JJ = dot(n, n), J = sqrt(JJ);
  const S H = (G * dot(x_ss, n) - 2. * F * dot(x_st, n) + E * dot(x_tt, n)) / (JJ * J);
  return {J, dot(x, n) / 3., H};
}

template <class S>
std::array<S, jet_size> variables(const Jets& jets, Index p) {
  std::array<S, jet_size> q;
  for (int k = 0; k < jet_size; ++k) q[std::size_t(k)] = S(jets(k, p), k);
  return q;
}

Jets jets_of(const HarmonicBasis& basis, const VectorXd& a) {
  Jets q(jet_size, basis.omega.cols());
  for (int k = 0; k < jet_size; ++k) q.row(k) = (basis.Y[std::size_t(k)] * a).transpose();
  return q;
}

// J ν
Vector3d normal_at(const Matrix3d& D, const Matrix3d& T, const Jets& q, Index p) {
  const Vector3d x_s = D.col(0) + q(0, p) * T.col(0) + q(1, p) * T.col(2),
                 x_t = D.col(1) + q(0, p) * T.col(1) + q(2, p) * T.col(2);
  return x_s.cross(x_t);
}

}  // namespace

HarmonicEnergy::HarmonicEnergy(const HarmonicSurface& surface) {
  const SphereRule rule = sphere_rule(2 * (surface.degree + 1));
  basis_ = harmonic_basis(surface.degree, rule.omega);
  weights_ = rule.weights;
  for (const auto omega : rule.omega.colwise()) {
    const Matrix3d frame = frame_at(omega);
    frames_.push_back({surface.ellipsoid * frame, surface.direction() * frame});
  }
}

std::optional<HarmonicEnergy::Expansion> HarmonicEnergy::expand(const VectorXd& a) const {
  const Jets q = jets_of(basis_, a);
  Expansion at{HarmonicMeasures::Zero(), Eigen::MatrixX3d::Zero(unknowns(), 3)};
  std::array<Jets, 3> by_jet;  // of the measures
  by_jet.fill(Jets(jet_size, points()));
  for (int p = 0; p < points(); ++p) {
    const auto& [D, T] = frames_[std::size_t(p)];
    if (!(normal_at(D, T, q, p).dot(T.col(2)) > 0)) return {};
    const Geometry<First> g = geometry(D, T, variables<First>(q, p));
    const std::array<First, 3> densities{0.5 * g.H * g.H * g.J, g.J, g.dV};
    for (std::size_t i = 0; i < 3; ++i) {
      at.measures[Index(i)] += weights_[p] * densities[i].a;
      by_jet[i].col(p) = weights_[p] * densities[i].v;
    }
  }
  for (Index i = 0; i < 3; ++i)
    for (Index k = 0; k < jet_size; ++k)
      at.gradients.col(i).noalias() +=
          basis_.Y[std::size_t(k)].transpose() * by_jet[std::size_t(i)].row(k).transpose();
  return at;
}

MatrixXd HarmonicEnergy::hessian(const VectorXd& a, double tension, double pressure) const {
  const Jets q = jets_of(basis_, a);
  MatrixXd h(points(), jet_size * jet_size);
  for (int p = 0; p < points(); ++p) {
    const auto& [D, T] = frames_[std::size_t(p)];
    const Geometry<Second> g = geometry(D, T, variables<Second>(q, p));
    const Second density = 0.5 * g.H * g.H * g.J + tension * g.J - pressure * g.dV;
    h.row(p) = weights_[p] * density.hessian().reshaped().transpose();
  }
  MatrixXd K = MatrixXd::Zero(unknowns(), unknowns()), hY(points(), unknowns());
  for (Index i = 0; i < jet_size; ++i) {
    hY.setZero();
    for (Index k = 0; k < jet_size; ++k)
      hY += h.col(i * jet_size + k).asDiagonal() * basis_.Y[std::size_t(k)];
    K.noalias() += basis_.Y[std::size_t(i)].transpose() * hY;
  }
  return K;
}

VectorXd HarmonicEnergy::root_curvature(const VectorXd& a, MatrixXd* derivatives) const {
  const Jets q = jets_of(basis_, a);
  VectorXd values(points());
  Jets by_jet(jet_size, points());
  for (int p = 0; p < points(); ++p) {
    const auto& [D, T] = frames_[std::size_t(p)];
    const Geometry<First> g = geometry(D, T, variables<First>(q, p));
    const First f = sqrt(weights_[p] * g.J) * g.H;
    values[p] = f.a;
    by_jet.col(p) = f.v;
  }
  if (!derivatives) return values;
  derivatives->setZero(points(), unknowns());
  for (Index k = 0; k < jet_size; ++k)
    *derivatives += by_jet.row(k).asDiagonal() * basis_.Y[std::size_t(k)];
  return values;
}

MatrixXd HarmonicEnergy::rigid_motions(const VectorXd& a) const {
  const Jets q = jets_of(basis_, a);
  MatrixXd rate(points(), 6);  // of u, from u̇ (Tω)·ν = v·ν, times the weight
  for (int p = 0; p < points(); ++p) {
    const auto& [D, T] = frames_[std::size_t(p)];
    const Vector3d x = D.col(2) + q(0, p) * T.col(2), n = normal_at(D, T, q, p);
    rate.row(p) << n.transpose(), x.cross(n).transpose();
    rate.row(p) *= weights_[p] / n.dot(T.col(2));
  }
  return basis_.Y[0].transpose() * rate;
}

VectorXd mean_curvature(const HarmonicSurface& surface, const Eigen::Matrix3Xd& omega) {
  const Jets q = jets_of(harmonic_basis(surface.degree, omega), surface.coefficients);
  VectorXd H(omega.cols());
  for (Index p = 0; p < omega.cols(); ++p) {
    const Matrix3d frame = frame_at(omega.col(p));
    H[p] = geometry(surface.ellipsoid * frame, surface.direction() * frame, variables<First>(q, p))
               .H.a;
  }
  return H;
}

}  // namespace sbeh::surface3d
