// A closed surface by spherical harmonics, without an axis: an ellipsoid and a displacement.
#pragma once

#include "surface3d/harmonic/basis.h"
#include "surface3d/moments.h"
#include "surface3d/surface.h"

#include <Eigen/Core>

namespace sbeh::surface3d {

/// x(ω) = centre + (D + u(ω) T) ω over the unit vectors ω, with the ellipsoid D ω, u = Σ a_lm Y_lm, and
/// T = (det D)^{1/2} D^{−1/2}: displacements between those along the radius and those along the ellipsoid's
/// normals. The ellipsoid is a choice of coordinates and no restriction: any surface near enough to have
/// one u per ω has these a_lm, and they fall faster than those of a radius, most of all for discs with
/// dimples.
struct HarmonicSurface {
  int degree;  ///< largest l
  Eigen::Vector3d centre;
  Eigen::Matrix3d ellipsoid;     ///< D, symmetric, positive
  Eigen::VectorXd coefficients;  // (degree + 1)²: a_lm at l² + l + m

  Eigen::Matrix3d direction() const;  ///< T
  /// x(ω) at a unit vector.
  Eigen::Vector3d at(const Eigen::Vector3d& omega) const;
  /// The same surface with more harmonics, or without its highest.
  HarmonicSurface with_degree(int other) const;
};

/// Its points at those of a rule on the unit sphere, with the areas that they stand for.
SurfaceSamples samples_of(const HarmonicSurface& surface, const SphereRule& rule);

/// Where a point lies in the coordinates of a surface: x = centre + (D + u T) ω.
struct EllipsoidCoordinates {
  Eigen::Vector3d omega;
  double u;
};
/// NaN for the centre itself.
EllipsoidCoordinates coordinates_of(const HarmonicSurface& surface, const Eigen::Vector3d& x);

/// Ellipsoid along the axes of coordinates.
HarmonicSurface harmonic_ellipsoid(const Eigen::Vector3d& semi_axes, int degree);

/// Spheroid about z, oblate or prolate, of area 4π and reduced volume 0.1 < V_r < 1.
/// Throws std::invalid_argument outside.
HarmonicSurface harmonic_spheroid(double reduced_volume, bool prolate, int degree);

/// Centre by the first, ellipsoid by the second moments of the points, but rounder; u by least squares.
/// Points: 3 x n, n >= (degree + 1)²; weights (> 0): n, best the area that each stands for.
/// Throws std::invalid_argument where there are fewer points, or they lie in a plane.
HarmonicSurface fit_harmonics(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& weights,
                              int degree);
/// The same through a P3 surface, at its quadrature points.
HarmonicSurface fit_harmonics(const Triangulation& mesh, const Nodes& X, int degree);
/// The same surface about its own centre and ellipsoid, to the accuracy of the degree.
HarmonicSurface refitted(const HarmonicSurface& surface);

/// A surface about the axis that it has, or nearly has.
struct Axis {
  Eigen::Vector3d direction;  ///< principal axis whose moment differs most from the two others
  Eigen::Vector3d centre;     ///< of area
  double
      deviation;  ///< largest |change of u| when the surface is turned about it, over eight angles:
                  ///< 0 for a surface of revolution
};
Axis axis_of(const HarmonicSurface& surface);

}  // namespace sbeh::surface3d
