// Real spherical harmonics, orthonormal on the unit sphere.
#pragma once

#include <Eigen/Core>

#include <span>

namespace sbeh::meshing {

/// Amplitude of Y_lm, l >= 0, −l <= m <= l.
struct Harmonic {
  int l, m;
  double amplitude;
  bool operator==(const Harmonic&) const = default;
};

/// Y_lm at a unit vector: √((2l+1)/4π (l−|m|)!/(l+|m|)!) P_l^|m|(cos θ) times √2 cos mφ for m > 0,
/// √2 sin |m|φ for m < 0, 1 for m = 0; ∫ Y_lm² = 1, no factor (−1)^m. θ from the z axis.
/// Throws std::invalid_argument for indices that do not exist.
double spherical_harmonic(int l, int m, const Eigen::Vector3d& direction);

/// Q_lm for l = m … degree, with Y_lm = Q_lm Re (x + iy)^m, times √2 for m > 0: a polynomial in z, Q_lm =
/// √((2l+1)/4π (l−m)!/(l+m)!) d^m P_l/dz^m.
Eigen::VectorXd normalised_legendre(int degree, int m, double z);

/// Σ a_lm Y_lm at a unit vector.
double harmonic_sum(std::span<const Harmonic> modes, const Eigen::Vector3d& direction);

}  // namespace sbeh::meshing
