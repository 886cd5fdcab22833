// Real spherical harmonics with their derivatives along the unit sphere, anywhere on it, and a rule for
// integrals over it.
#pragma once

#include <Eigen/Core>

#include <array>

namespace sbeh::surface3d {

/// (degree + 1)²: how many Y_lm there are up to l = degree. Y_lm has the index l² + l + m.
constexpr int harmonic_count(int degree) { return (degree + 1) * (degree + 1); }

/// All Y_lm at a unit vector, as meshing::spherical_harmonic normalises them.
Eigen::VectorXd harmonics_at(int degree, const Eigen::Vector3d& direction);

/// Frame (e1, e2, ω) at a unit vector ω, e1 × e2 = ω.
Eigen::Matrix3d frame_at(const Eigen::Vector3d& direction);

/// A function on the sphere at a point: f, f_s, f_t, f_ss, f_st, f_tt, with (s, t) the normal coordinates
/// along (e1, e2), so that the second derivatives are the covariant ones.
inline constexpr int jet_size = 6;

/// All harmonics at some points.
struct HarmonicBasis {
  int degree;
  Eigen::Matrix3Xd omega;                   // 3 x points, unit vectors
  std::array<Eigen::MatrixXd, jet_size> Y;  // points x harmonics: the jets, in frame_at(ω)
};
HarmonicBasis harmonic_basis(int degree, const Eigen::Matrix3Xd& directions);

/// Points and weights on the unit sphere; the weights sum to 4π.
struct SphereRule {
  Eigen::Matrix3Xd omega;   // 3 x points
  Eigen::VectorXd weights;  // points
};
/// Gauss–Legendre in cos θ times equal steps of φ, n x 2n points: exact for harmonics of l < 2n.
SphereRule sphere_rule(int n);

}  // namespace sbeh::surface3d
