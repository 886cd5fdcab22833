#include "meshing/spherical_harmonics.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

// Q_l = N_lm P_l^m(z)/(1 − z²)^{m/2}, a polynomial in z; by the recurrence of the normalised
// functions in l, which is stable and has no singular poles.
double normalised_legendre(int l, int m, double z) {
  double Q = 1 / (4 * std::numbers::pi);  // squared for the moment
  for (int k = 1; k <= m; ++k) Q *= (2 * k + 1) / (2. * k);
  Q = std::sqrt(Q);  // Q_m
  double before = 0;
  const double mm = double(m) * m;
  for (int k = m + 1; k <= l; ++k) {
    const double kk = double(k) * k, a = std::sqrt((4 * kk - 1) / (kk - mm));
    const double ll = double(k - 1) * (k - 1);
    const double b = k == m + 1 ? 0 : std::sqrt((ll - mm) / (4 * ll - 1));
    const double next = a * (z * Q - b * before);
    before = Q;
    Q = next;
  }
  return Q;
}

}  // namespace

double spherical_harmonic(int l, int m, const Eigen::Vector3d& d) {
  if (l < 0 || std::abs(m) > l)
    throw std::invalid_argument(
        fmt::format("spherical harmonic: l = {}, m = {}: must be l >= 0, -l <= m <= l", l, m));
  const double zonal = normalised_legendre(l, std::abs(m), d.z());
  if (m == 0) return zonal;
  std::complex<double> turn = 1;  // (sin θ e^{iφ})^|m|
  for (int k = 0; k < std::abs(m); ++k) turn *= std::complex<double>(d.x(), d.y());
  return std::numbers::sqrt2 * zonal * (m > 0 ? turn.real() : turn.imag());
}

double harmonic_sum(std::span<const Harmonic> modes, const Eigen::Vector3d& direction) {
  double sum = 0;
  for (const Harmonic& mode : modes)
    sum += mode.amplitude * spherical_harmonic(mode.l, mode.m, direction);
  return sum;
}

}  // namespace sbeh::meshing
