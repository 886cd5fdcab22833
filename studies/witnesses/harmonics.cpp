// Minimisation over spherical harmonics in the terms of the axisymmetric methods.
#include "studies/witnesses/state.h"
#include "surface3d/harmonic/basis.h"
#include "surface3d/harmonic/energy.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

using Eigen::Vector3d;
using surface3d::HarmonicState;
using surface3d::HarmonicSurface;

namespace {

// H where the surface meets a ray from its own centre.
double curvature_along(const HarmonicSurface& surface, const Vector3d& direction) {
  // The axes of the ellipsoid are those of a surface of revolution.
  const Vector3d omega = surface.ellipsoid.inverse() * direction;
  return surface3d::mean_curvature(surface, omega.normalized())[0];
}

HarmonicSurface spheroid_of(const axisym::StationaryCase& of, int degree) {
  return surface3d::harmonic_spheroid(of.reduced_volume, of.branch == axisym::Branch::prolate,
                                      degree);
}

}  // namespace

WitnessState harmonic_state(const axisym::StationaryCase& of, const HarmonicMethod& method,
                            const meshing::CurvedMesh* start) {
  const int degree = method.degree;
  const HarmonicState shape = surface3d::minimise_harmonics(
      start ? surface3d::fit_harmonics(surface3d::Triangulation(*start), start->nodes, degree)
            : spheroid_of(of, degree),
      of.reduced_volume, degree);
  WitnessState found{.witness = Witness::harmonics};
  if (shape.stop != surface3d::HarmonicStop::stationary) {
    found.failure = describe(shape.stop);
    return found;
  }
  const surface3d::Axis axis = surface3d::axis_of(shape.surface);
  found.remark = fmt::format(
      "l <= {}, from {}; {} directions in which the energy falls; deviation from an axis {:.1e}",
      degree, start ? "surface3d" : "an ellipsoid", shape.negative_directions, axis.deviation);
  found.measures = classical_measures(of.material, shape.energy, shape.pressure, shape.tension);
  const double above = curvature_along(shape.surface, axis.direction),
               below = curvature_along(shape.surface, -axis.direction);
  found.measures.H_pole = std::max(above, below);
  const Vector3d z = above < below ? Vector3d(-axis.direction) : axis.direction;
  const Eigen::Matrix3Xd omega = surface3d::sphere_rule(degree + 1).omega;
  found.points.resize(2, omega.cols());
  for (Eigen::Index i = 0; i < omega.cols(); ++i) {
    const Vector3d x = shape.surface.at(omega.col(i)) - axis.centre;
    found.points.col(i) << z.cross(x).norm(), z.dot(x);
  }
  const bool prolate = found.points.row(1).cwiseAbs().maxCoeff() > found.points.row(0).maxCoeff();
  if (prolate != (of.branch == axisym::Branch::prolate)) {
    found = {.witness = Witness::harmonics};
    found.failure = fmt::format("has come to the {} instead", prolate ? "prolate" : "oblate");
    return found;
  }
  found.order = Eigen::VectorXd::Constant(omega.cols(), model::full_order);
  return found;
}

std::optional<HarmonicState> classical_saddle(const axisym::StationaryCase& of) {
  constexpr double least_volume = 0.65;
  constexpr int degree = 16;
  if (of.model != model::Model::SSH || of.material.preferred_curvature() != 0
      || of.reduced_volume < least_volume)
    return {};
  const HarmonicState shape =
      surface3d::minimise_harmonics(spheroid_of(of, degree), of.reduced_volume, degree);
  if (shape.stop != surface3d::HarmonicStop::stationary) return {};
  return shape;
}

}  // namespace sbeh::studies
