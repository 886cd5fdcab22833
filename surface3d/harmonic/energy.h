// Bending energy, area and volume of a surface by spherical harmonics, with their derivatives by the
// coefficients.
#pragma once

#include "surface3d/harmonic/basis.h"
#include "surface3d/harmonic/surface.h"

#include <optional>
#include <vector>

namespace sbeh::surface3d {

/// Integrals over the surface: F/κ = ½∫H² dS, A, V.
using HarmonicMeasures = Eigen::Vector3d;

/// The integrals of surfaces with one degree, centre and ellipsoid, as functions of the coefficients a.
class HarmonicEnergy {
 public:
  /// On sphere_rule(2 (degree + 1)).
  explicit HarmonicEnergy(const HarmonicSurface& surface);

  int unknowns() const { return int(basis_.Y[0].cols()); }
  int points() const { return int(weights_.size()); }

  /// Values at a, and derivatives.
  struct Expansion {
    HarmonicMeasures measures;
    Eigen::MatrixX3d gradients;  // unknowns x 3
  };
  /// Empty where the surface is turned inside out at a point.
  std::optional<Expansion> expand(const Eigen::VectorXd& a) const;

  /// ∂²/∂a² of F/κ + Σ A − P V; unknowns x unknowns.
  Eigen::MatrixXd hessian(const Eigen::VectorXd& a, double tension, double pressure) const;

  /// √dS H at the points: half the sum of its squares is F/κ. With its derivatives, points x unknowns,
  /// unless null. Only where there is an expansion.
  Eigen::VectorXd root_curvature(const Eigen::VectorXd& a, Eigen::MatrixXd* derivatives) const;

  /// The changes of a that move the surface rigidly, to first order: shifts along x, y, z and turns about
  /// them; unknowns x 6.
  Eigen::MatrixXd rigid_motions(const Eigen::VectorXd& a) const;

 private:
  HarmonicBasis basis_;
  Eigen::VectorXd weights_;  // points
  /// Per point the frame (e1, e2, ω) under D and under T.
  struct Frames {
    Eigen::Matrix3d D, T;
  };
  std::vector<Frames> frames_;
};

/// H (trace, −2 on the unit sphere) of a surface at unit vectors ω; n.
Eigen::VectorXd mean_curvature(const HarmonicSurface& surface, const Eigen::Matrix3Xd& omega);

}  // namespace sbeh::surface3d
