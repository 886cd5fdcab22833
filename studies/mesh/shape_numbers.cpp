#include "studies/mesh/shape_numbers.h"

#include "model/material.h"
#include "model/numerics/root.h"
#include "surface3d/diagnostics.h"
#include "surface3d/harmonic/energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::studies {

using std::numbers::pi;
using surface3d::HarmonicSurface;

namespace {

constexpr int largest_l = 32;

// r = 1 + u
ShapeNumbers on_rule(const HarmonicSurface& surface, const surface3d::SphereRule& rule) {
  ShapeNumbers sum{0, 0, 0};
  constexpr Eigen::Index at_a_time = 1024;
  for (Eigen::Index first = 0; first < rule.weights.size(); first += at_a_time) {
    const Eigen::Index count = std::min(at_a_time, rule.weights.size() - first);
    const surface3d::SphereRule some{rule.omega.middleCols(first, count),
                                     rule.weights.segment(first, count)};
    const surface3d::SurfaceSamples samples = samples_of(surface, some);
    const Eigen::VectorXd H = mean_curvature(surface, some.omega);
    sum.area += samples.areas.sum();
    sum.bending += samples.areas.dot(H.cwiseAbs2()) / 2;
    sum.volume +=
        some.weights.dot(samples.points.colwise().norm().transpose().array().cube().matrix()) / 3;
  }
  return sum;
}

std::optional<ShapeNumbers> numbers_of(const HarmonicSurface& surface) {
  constexpr int most = 256;            // 2n² points
  constexpr double tolerance = 1e-10;  // ten digits
  ShapeNumbers before = on_rule(surface, surface3d::sphere_rule(32));
  for (int n = 64; n <= most; n *= 2) {
    const ShapeNumbers now = on_rule(surface, surface3d::sphere_rule(n));
    if (std::abs(now.bending - before.bending) < tolerance * now.bending) return now;
    before = now;
  }
  return {};
}

HarmonicSurface star(const HarmonicShape& shape, double factor) {
  int degree = 1;
  for (const meshing::Harmonic& mode : shape.modes) degree = std::max(degree, mode.l);
  HarmonicSurface surface = surface3d::harmonic_ellipsoid(Eigen::Vector3d::Ones(), degree);
  for (const auto& [l, m, amplitude] : shape.modes)
    surface.coefficients[Eigen::Index(l) * l + l + m] += factor * amplitude;
  return surface;
}

std::optional<ShapeNumbers> unscaled(const SphereShape&, const MeshRequest&) {
  return ShapeNumbers{4 * pi, 4 * pi / 3, 8 * pi};
}

std::optional<ShapeNumbers> unscaled(const EllipsoidShape& shape, const MeshRequest& request) {
  const HarmonicSurface surface =
      shape.semi_axes ? surface3d::harmonic_ellipsoid(*shape.semi_axes, 1)
                      : surface3d::harmonic_spheroid(*request.reduced_volume, shape.prolate, 1);
  auto numbers = numbers_of(surface);
  if (numbers) numbers->volume = 4 * pi / 3 * surface.ellipsoid.determinant();
  return numbers;
}

std::optional<ShapeNumbers> unscaled(const HarmonicShape& shape, const MeshRequest& request) {
  if (std::ranges::any_of(shape.modes, [](const auto& mode) { return mode.l > largest_l; }))
    return {};
  if (!request.reduced_volume) return numbers_of(star(shape, 1));
  const auto excess = [&](double factor) {
    const ShapeNumbers at = on_rule(star(shape, factor), surface3d::sphere_rule(64));
    return model::reduced_volume(at.area, at.volume) - *request.reduced_volume;
  };
  return numbers_of(star(shape, model::root_near(1, 0.99, excess, 1e-12)));
}

std::optional<ShapeNumbers> unscaled(const auto&, const MeshRequest&) { return {}; }

}  // namespace

std::optional<ShapeNumbers> shape_numbers(const MeshRequest& request) {
  std::optional<ShapeNumbers> numbers =
      std::visit([&](const auto& shape) { return unscaled(shape, request); }, request.shape);
  if (numbers && request.area) {
    const double scale = std::sqrt(*request.area / numbers->area);
    numbers->area *= scale * scale;
    numbers->volume *= scale * scale * scale;
  }
  return numbers;
}

std::optional<double> bending_of(const meshing::CurvedMesh& mesh) {
  if (mesh.order != 3) return {};
  const surface3d::Triangulation triangles(mesh);
  const auto curvature = surface3d::curvature_of(triangles, mesh.nodes);
  if (!curvature) return {};
  model::Material unit;  // κ = 1, all else 0
  unit.L1 = 0;
  unit.kappa_powers = model::Polynomial({1});
  unit.kappa_gauss_powers = model::Polynomial({0});
  unit.potential = model::Potential({0});
  const surface3d::State state{mesh.nodes, surface3d::Field::Zero(triangles.nodes)};
  return energy(triangles, unit, state, *curvature).bending;
}

}  // namespace sbeh::studies
