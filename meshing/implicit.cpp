#include "meshing/implicit.h"

#include "meshing/curving.h"
#include "meshing/defects.h"
#include "meshing/implicit_mesher.h"
#include "meshing/measures.h"
#include "meshing/remeshing.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::meshing {

using Eigen::Vector3d;

namespace {

Vector3d gradient_of(const ImplicitShape& shape, const Vector3d& x) {
  if (shape.gradient) return shape.gradient(x);
  const double h = 1e-5 * shape.radius;
  Vector3d g;
  for (int i = 0; i < 3; ++i)
    g[i] = (shape.f(x + h * Vector3d::Unit(i)) - shape.f(x - h * Vector3d::Unit(i))) / (2 * h);
  return g;
}

// Newton's method along the gradient.
Vector3d onto_level(const ImplicitShape& shape, Vector3d x) {
  constexpr int iterations = 50;
  for (int i = 0; i < iterations; ++i) {
    const Vector3d g = gradient_of(shape, x);
    const Vector3d step = -shape.f(x) / g.squaredNorm() * g;
    if (!step.allFinite()) break;
    // Far away the tangent says little.
    const double limit = 0.1 * shape.radius;
    x += step.norm() > limit ? Vector3d(limit * step.normalized()) : step;
    if (step.norm() < 1e-15 * shape.radius) break;
  }
  return x;
}

}  // namespace

CurvedMesh implicit_surface(const ImplicitShape& shape, const Resolution& resolution) {
  resolution.validate();
  if (!(shape.radius > 0 && std::isfinite(shape.radius)))
    throw std::invalid_argument(
        fmt::format("implicit surface: radius {}: must be > 0", shape.radius));
  if (!(shape.f(shape.centre) < 0))
    throw std::invalid_argument(fmt::format(
        "implicit surface: f = {} at the centre: must be < 0, inside", shape.f(shape.centre)));
  // A sphere of half the bounding radius, say, in so many triangles; fine enough to see the shape.
  const double guess = std::numbers::pi * shape.radius * shape.radius;
  const int first = std::max(resolution.triangles, 1000);
  TriangleMesh mesh = triangulate(shape, 0.5 * std::sqrt(4 / std::sqrt(3.) * guess / first));
  const Projection level = [&](const Vector3d& x) { return onto_level(shape, x); };
  project(mesh, level);
  if (const auto defect = find_defect(mesh, {}))
    throw std::invalid_argument(fmt::format(
        "implicit surface: no closed surface of sphere topology was found: {}", defect->text));
  mesh = remeshed(mesh, resolution.triangles, level, resolution.grading);
  return curved(mesh, resolution.order, level);
}

}  // namespace sbeh::meshing
