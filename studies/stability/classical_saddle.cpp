#include "studies/stability/classical_saddle.h"

#include "surface3d/harmonic/minimiser.h"

namespace sbeh::studies {

namespace {
constexpr double least_volume = 0.65;
constexpr int degree = 16;
}  // namespace

std::optional<ClassicalSaddle> classical_saddle(const axisym::StationaryCase& of) {
  if (of.model != model::Model::SSH || of.material.spontaneous_curvature != 0
      || of.reduced_volume < least_volume)
    return {};
  const surface3d::HarmonicShape shape = surface3d::minimise_harmonics(
      surface3d::harmonic_spheroid(of.reduced_volume, of.branch == axisym::Branch::prolate, degree),
      of.reduced_volume, degree);
  if (shape.stop != surface3d::HarmonicStop::stationary) return {};
  return ClassicalSaddle{shape.negative_directions, shape.stiffness};
}

}  // namespace sbeh::studies
