#include "meshing/spherical_harmonics.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace sbeh::meshing {

// By the recurrence of the normalised functions in l, which is stable and has no singular poles.
Eigen::VectorXd normalised_legendre(int degree, int m, double z) {
  Eigen::VectorXd Q(degree + 1 - m);
  double squared = 1 / (4 * std::numbers::pi);
  for (int k = 1; k <= m; ++k) squared *= (2 * k + 1) / (2. * k);
  Q[0] = std::sqrt(squared);
  const double mm = double(m) * m;
  for (int l = m + 1; l <= degree; ++l) {
    const double ll = double(l) * l, before = double(l - 1) * (l - 1);
    const double a = std::sqrt((4 * ll - 1) / (ll - mm));
    const double b = l == m + 1 ? 0 : std::sqrt((before - mm) / (4 * before - 1));
    Q[l - m] = a * (z * Q[l - m - 1] - (l == m + 1 ? 0 : b * Q[l - m - 2]));
  }
  return Q;
}

double spherical_harmonic(int l, int m, const Eigen::Vector3d& d) {
  if (l < 0 || std::abs(m) > l)
    throw std::invalid_argument(
        fmt::format("spherical harmonic: l = {}, m = {}: must be l >= 0, -l <= m <= l", l, m));
  const double zonal = normalised_legendre(l, std::abs(m), d.z())[l - std::abs(m)];
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
