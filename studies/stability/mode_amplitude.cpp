#include "studies/stability/mode_amplitude.h"

#include "meshing/spherical_harmonics.h"
#include "surface3d/moments.h"

#include <cmath>

namespace sbeh::studies {

using Eigen::Vector3d;
using surface3d::SurfacePoint;

namespace {

constexpr double equal_moments = 0.05;

}  // namespace

double mode_amplitude(const surface3d::Triangulation& mesh, const surface3d::Nodes& X, int l,
                      int m) {
  const Vector3d centre = moments_of(samples_of(mesh, X)).centre;
  double cosine = 0, sine = 0, total = 0;
  surface3d::for_each_point(mesh, X, surface3d::assembly_points(),
                            [&](int, const surface3d::ShapeValues&, const SurfacePoint& p) {
                              const double r = (p.x - centre).norm();
                              if (r == 0) return;
                              const Vector3d direction = (p.x - centre) / r;
                              const double weight = p.dS * std::pow(r, l);
                              cosine += weight * meshing::spherical_harmonic(l, m, direction);
                              sine += weight * meshing::spherical_harmonic(l, -m, direction);
                              total += weight;
                            });
  return std::hypot(cosine, sine) / total;
}

Roundness roundness_of(const surface3d::Triangulation& mesh, const surface3d::Nodes& X) {
  const Vector3d w = moments_of(samples_of(mesh, X)).principal;
  const double range = w[2] - w[0];
  if (w[1] - w[0] < equal_moments * range) return Roundness::prolate;
  if (w[2] - w[1] < equal_moments * range) return Roundness::oblate;
  return Roundness::triaxial;
}

}  // namespace sbeh::studies
