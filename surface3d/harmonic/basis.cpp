#include "surface3d/harmonic/basis.h"

#include "meshing/spherical_harmonics.h"
#include "model/numerics/quadrature.h"

#include <Eigen/Geometry>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace sbeh::surface3d {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

// Q_lm at (l, m), 0 for m > l.
MatrixXd legendre_table(int degree, double z) {
  MatrixXd Q = MatrixXd::Zero(degree + 1, degree + 3);
  for (int m = 0; m <= degree; ++m)
    Q.col(m).tail(degree + 1 - m) = meshing::normalised_legendre(degree, m, z);
  return Q;
}

// dQ_lm/dz = slope(l, m) Q_l,m+1
double slope(int l, int m) { return m >= l ? 0 : std::sqrt(double(l - m) * (l + m + 1)); }

// (x + iy)^k for k = 0 … degree
std::vector<Complex> powers(int degree, const Vector3d& d) {
  std::vector<Complex> w(std::size_t(degree) + 1, 1.);
  for (std::size_t k = 1; k < w.size(); ++k) w[k] = w[k - 1] * Complex(d.x(), d.y());
  return w;
}

// Derivatives of Q(z) (x + iy)^m in space along a, and along a and b.
struct Monomial {
  double Q, dQ, ddQ;
  Complex w, dw, ddw;  // (x + iy)^m, m (x + iy)^(m−1), m (m−1) (x + iy)^(m−2)

  Complex along(const Vector3d& a) const { return Q * dw * Complex(a.x(), a.y()) + dQ * a.z() * w; }
  Complex along(const Vector3d& a, const Vector3d& b) const {
    const Complex A(a.x(), a.y()), B(b.x(), b.y());
    return Q * ddw * A * B + dQ * dw * (A * b.z() + B * a.z()) + ddQ * a.z() * b.z() * w;
  }
};

using Jet = std::array<Complex, jet_size>;
// On the sphere the second derivative along a and b is that in space less (a·b) times that along ω.
Jet jet_of(const Monomial& Y, const Eigen::Matrix3d& frame) {
  const Vector3d e1 = frame.col(0), e2 = frame.col(1);
  const Complex radial = Y.along(frame.col(2));
  return {Y.Q * Y.w,       Y.along(e1),
          Y.along(e2),     Y.along(e1, e1) - radial,
          Y.along(e1, e2), Y.along(e2, e2) - radial};
}

}  // namespace

VectorXd harmonics_at(int degree, const Vector3d& direction) {
  const MatrixXd Q = legendre_table(degree, direction.z());
  const std::vector<Complex> w = powers(degree, direction);
  VectorXd Y(harmonic_count(degree));
  for (int l = 0; l <= degree; ++l) {
    const Index zonal = Index(l) * l + l;
    Y[zonal] = Q(l, 0);
    for (int m = 1; m <= l; ++m) {
      const Complex turn = std::numbers::sqrt2 * Q(l, m) * w[std::size_t(m)];
      Y[zonal + m] = turn.real();
      Y[zonal - m] = turn.imag();
    }
  }
  return Y;
}

Eigen::Matrix3d frame_at(const Vector3d& direction) {
  Index smallest = 0;
  direction.cwiseAbs().minCoeff(&smallest);
  Eigen::Matrix3d frame;
  frame.col(2) = direction;
  frame.col(0) = direction.cross(Vector3d::Unit(smallest)).normalized();
  frame.col(1) = direction.cross(frame.col(0));
  return frame;
}

HarmonicBasis harmonic_basis(int degree, const Eigen::Matrix3Xd& directions) {
  HarmonicBasis basis{.degree = degree, .omega = directions, .Y = {}};
  for (MatrixXd& Y : basis.Y) Y.resize(directions.cols(), harmonic_count(degree));
  for (Index p = 0; p < directions.cols(); ++p) {
    const Eigen::Matrix3d frame = frame_at(directions.col(p));
    const MatrixXd Q = legendre_table(degree, directions(2, p));
    const std::vector<Complex> w = powers(degree, directions.col(p));
    for (int m = 0; m <= degree; ++m) {
      const auto k = std::size_t(m);
      const double norm = m > 0 ? std::numbers::sqrt2 : 1;
      const Complex dw = m > 0 ? double(m) * w[k - 1] : 0;
      const Complex ddw = m > 1 ? double(m) * (m - 1) * w[k - 2] : 0;
      for (int l = m; l <= degree; ++l) {
        const double dQ = slope(l, m) * Q(l, m + 1);
        const double ddQ = slope(l, m) * slope(l, m + 1) * Q(l, m + 2);
        const Jet jet = jet_of({Q(l, m), dQ, ddQ, w[k], dw, ddw}, frame);
        const Index zonal = Index(l) * l + l;
        for (std::size_t a = 0; a < jet_size; ++a) {
          basis.Y[a](p, zonal + m) = norm * jet[a].real();
          if (m > 0) basis.Y[a](p, zonal - m) = norm * jet[a].imag();
        }
      }
    }
  }
  return basis;
}

SphereRule sphere_rule(int n) {
  const model::IntervalRule gauss = model::gauss_rule(n);
  SphereRule rule{.omega = Eigen::Matrix3Xd(3, 2 * n * n), .weights = VectorXd(2 * n * n)};
  for (int i = 0; i < n; ++i) {
    const double z = 2 * gauss.points[i] - 1, r = std::sqrt((1 - z) * (1 + z));
    for (int j = 0; j < 2 * n; ++j) {
      const Index p = Index(i) * 2 * n + j;
      const double phi = pi * j / n;
      rule.omega.col(p) << r * std::cos(phi), r * std::sin(phi), z;
      rule.weights[p] = 2 * gauss.weights[i] * pi / n;
    }
  }
  return rule;
}

}  // namespace sbeh::surface3d
