#include "studies/stability/classical_saddle.h"

#include "surface3d/harmonic/minimiser.h"

namespace sbeh::studies {

namespace {
constexpr double least_volume = 0.65;
constexpr int degree = 16;
}  // namespace

std::optional<ClassicalSaddle> classical_saddle(const StabilityInput& input,
                                                const StabilityKey& key, double reduced_volume) {
  if (key.model != model::Model::SSH || input.material.spontaneous_curvature != 0
      || reduced_volume < least_volume)
    return {};
  const surface3d::HarmonicShape shape = surface3d::minimise_harmonics(
      surface3d::harmonic_spheroid(reduced_volume, key.branch == axisym::Branch::prolate, degree),
      reduced_volume, degree);
  if (shape.stop != surface3d::HarmonicStop::stationary) return {};
  return ClassicalSaddle{shape.negative_directions, shape.stiffness};
}

}  // namespace sbeh::studies
