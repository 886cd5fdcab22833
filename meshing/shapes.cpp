#include "meshing/shapes.h"

#include "meshing/curving.h"
#include "meshing/even_mesh.h"
#include "meshing/fitting.h"
#include "meshing/icosphere.h"
#include "meshing/measures.h"
#include "meshing/mesh_symmetry.h"
#include "meshing/quality.h"
#include "model/numerics/root.h"
#include "model/numerics/spheroid.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace sbeh::meshing {

using Eigen::Vector3d;
using model::root_between, model::spheroid_reduced_volume;
using std::numbers::pi;

namespace {

constexpr double thinnest = 100;  // ratio of semi-axes
constexpr double least_of_volume = 0.75;
constexpr double slender = 30;  // from here on rays from the middle hit the surface too flatly

// Newton's method for |x/a|² = 1 along the gradient: at the surface that is along the normal.
Vector3d onto_ellipsoid(const Vector3d& semi_axes, Vector3d x) {
  constexpr int iterations = 50;
  for (int i = 0; i < iterations; ++i) {
    const Vector3d y = x.cwiseQuotient(semi_axes), gradient = 2 * y.cwiseQuotient(semi_axes);
    const double f = y.squaredNorm() - 1;
    x -= f / gradient.squaredNorm() * gradient;
    if (std::abs(f) < 1e-15) break;
  }
  return x;
}

// Slender triangles where the ellipsoid is sharp, across which it bends. No even ones could go round it there.
CurvedMesh stretched_sphere(const Vector3d& semi_axes, const Resolution& resolution) {
  const int n = std::max(1, int(std::lround(std::sqrt(resolution.triangles / 8.))));
  CurvedMesh mesh = curved(octasphere(n), resolution.order,
                           [](const Vector3d& x) -> Vector3d { return x.normalized(); });
  mesh.nodes = semi_axes.asDiagonal() * mesh.nodes;
  return mesh;
}

// Where a line meets r(d) d.
HitByLine on_rays(const RadialFunction& r) {
  const auto excess = [&r](const Vector3d& x) { return x.norm() - r(x.normalized()); };
  const auto gradient = [excess](const Vector3d& x) {
    const double step = 1e-5 * x.norm();
    Vector3d slope;
    for (int k = 0; k < 3; ++k) {
      const Vector3d way = step * Vector3d::Unit(k);
      slope[k] = (excess(x + way) - excess(x - way)) / (2 * step);
    }
    return slope;
  };
  return [excess, gradient](const Vector3d& x, const Vector3d& along) -> std::optional<LineHit> {
    constexpr int iterations = 20;
    constexpr double accuracy = 1e-12;
    double s = 0, error = excess(x);
    const double slope = gradient(x).dot(along);
    for (int i = 0; i < iterations && std::abs(error) > accuracy * x.norm(); ++i) {
      s -= error / slope;
      error = excess(x + s * along);
    }
    if (!(std::abs(error) <= accuracy * x.norm())) return {};
    return LineHit{s, gradient(x + s * along).normalized()};
  };
}

void fit_to(const RadialFunction& r, const Resolution& resolution, CurvedMesh& mesh) {
  if (!resolution.fitted || resolution.order != 3) return;
  const MeshSymmetry symmetry = required_symmetry(mesh, resolution.symmetry);
  if (!fit(mesh, on_rays(r))) return;
  mesh.nodes = symmetry.symmetric_part(mesh.nodes);  // against rounding
}

RadialFunction ellipsoid_radius(const Vector3d& semi_axes) {
  return [semi_axes](const Vector3d& d) { return 1 / d.cwiseQuotient(semi_axes).norm(); };
}

// What it was before nodes left the shape.
void restore(double v, const Resolution& resolution, CurvedMesh& mesh) {
  if (resolution.fitted && !correct_area_volume(mesh, area(mesh), v))
    throw std::invalid_argument(
        fmt::format("reduced volume {}: so few triangles have no surface of it", v));
}

}  // namespace

CurvedMesh star_shaped(const RadialFunction& r, const Resolution& resolution) {
  resolution.validate();
  const Projection radially = [&r](const Vector3d& x) -> Vector3d {
    const Vector3d d = x.normalized();
    const double radius = r(d);
    if (!(radius > 0 && std::isfinite(radius)))
      throw std::invalid_argument(
          fmt::format("r = {:.3g} at theta = {:.3g}, phi = {:.3g}: must be > 0", radius,
                      std::acos(d.z()), std::atan2(d.y(), d.x())));
    return radius * d;
  };
  CurvedMesh mesh = even_mesh(resolution, radially, radially);
  fit_to(r, resolution, mesh);
  return mesh;
}

CurvedMesh sphere(const Resolution& resolution) {
  Resolution on_it = resolution;
  on_it.fitted = false;
  return star_shaped([](const Vector3d&) { return 1.; }, on_it);
}

CurvedMesh ellipsoid(const Vector3d& semi_axes, const Resolution& resolution) {
  if (!semi_axes.allFinite() || !(semi_axes.minCoeff() > 0))
    throw std::invalid_argument(fmt::format("ellipsoid: semi-axes {}, {}, {}: must be > 0",
                                            semi_axes[0], semi_axes[1], semi_axes[2]));
  if (semi_axes.maxCoeff() > thinnest * semi_axes.minCoeff())
    throw std::invalid_argument(
        fmt::format("ellipsoid: semi-axes {}, {}, {}: must not differ by more than a factor of {}",
                    semi_axes[0], semi_axes[1], semi_axes[2], thinnest));
  resolution.validate();
  const Projection radially = [&](const Vector3d& x) -> Vector3d {
    return x / x.cwiseQuotient(semi_axes).norm();
  };
  const Projection onto = [&](const Vector3d& x) { return onto_ellipsoid(semi_axes, x); };
  const bool is_slender = semi_axes.maxCoeff() >= slender * semi_axes.minCoeff();
  const auto even = even_mesh_if_any(resolution, radially, is_slender ? onto : radially);
  CurvedMesh mesh = stretched_sphere(semi_axes, resolution);
  // New triangles that are wider than a needle close it where it is not yet at its end.
  const bool is_even = even && volume(*even) > least_of_volume * volume(mesh);
  if (is_even) mesh = *even;
  if (!(min_jacobian(mesh) > 0)) refuse_as_too_sharp(resolution);
  if (!is_even && !resolution.symmetry.is_trivial()) required_symmetry(mesh, resolution.symmetry);
  fit_to(ellipsoid_radius(semi_axes), resolution, mesh);
  return mesh;
}

CurvedMesh ellipsoid(double v, bool prolate, const Resolution& resolution) {
  if (!(v > 0 && v <= 1))
    throw std::invalid_argument(
        fmt::format("ellipsoid: reduced volume {}: must be > 0 and <= 1", v));
  const double extreme = prolate ? thinnest : 1 / thinnest;
  if (v < spheroid_reduced_volume(extreme))
    throw std::invalid_argument(
        fmt::format("ellipsoid: reduced volume {}: must be >= {:.4g}, where its semi-axes differ "
                    "by a factor of {}",
                    v, spheroid_reduced_volume(extreme), thinnest));
  double q = 1;
  if (v < 1)
    q = root_between([&](double x) { return spheroid_reduced_volume(x) - v; },
                     std::min(extreme, 1.), std::max(extreme, 1.))
            .middle();
  Resolution on_it = resolution;
  on_it.fitted = false;
  CurvedMesh mesh = ellipsoid(Vector3d(1, 1, q), on_it);
  if (v < 1) {
    // Stretched along z it remains a spheroid, nodes included.
    const auto stretched = [&](double s) {
      CurvedMesh m = mesh;
      m.nodes.row(2) *= s;
      return m;
    };
    const double highest = reduced_volume(stretched(1 / q));
    if (!(highest > v))
      throw std::invalid_argument(
          fmt::format("ellipsoid: reduced volume {}: a mesh of {} triangles of order {} reaches {} "
                      "at most, as the sphere; take 1, or more triangles",
                      v, mesh.triangle_count(), mesh.order, highest));
    const double too_far = prolate ? 1.5 : 0.5;
    const auto miss = [&](double s) { return reduced_volume(stretched(s)) - v; };
    const double s =
        root_between(miss, std::min(too_far, 1 / q), std::max(too_far, 1 / q)).middle();
    mesh = stretched(s);
    fit_to(ellipsoid_radius({1, 1, q * s}), resolution, mesh);
    restore(v, resolution, mesh);
  }
  scale_to_area(mesh, 4 * pi);
  return mesh;
}

CurvedMesh harmonic_sphere(std::span<const Harmonic> modes, const Resolution& resolution) {
  return star_shaped([modes](const Vector3d& d) { return 1 + harmonic_sum(modes, d); }, resolution);
}

CurvedMesh harmonic_sphere(std::span<const Harmonic> modes, double v,
                           const Resolution& resolution) {
  if (!(v > 0 && v < 1))
    throw std::invalid_argument(
        fmt::format("harmonics: reduced volume {}: must be > 0 and < 1", v));
  // The nodes of a mesh keep their directions while the amplitudes change.
  const auto with_factor = [&](CurvedMesh mesh, double factor) {
    for (auto x : mesh.nodes.colwise()) {
      const Vector3d d = x.normalized();
      x = (1 + factor * harmonic_sum(modes, d)) * d;
    }
    return mesh;
  };
  const auto miss = [&](const CurvedMesh& mesh) {
    return [&](double factor) { return reduced_volume(with_factor(mesh, factor)) - v; };
  };
  const CurvedMesh coarse = sphere({.triangles = 1280});
  const auto deepest = [&](double factor) {  // smallest radius
    double r = 1;
    for (const auto d : coarse.nodes.colwise())
      r = std::min(r, 1 + factor * harmonic_sum(modes, d.normalized()));
    return r;
  };
  double high = 1e-6;
  for (; miss(coarse)(high) > 0; high *= 1.2)
    if (!(deepest(1.2 * high) > 0) || high > 1e6)
      throw std::invalid_argument(
          fmt::format("harmonics: reduced volume {}: r reaches 0 before, at {:.4g}", v,
                      v + miss(coarse)(high)));
  const double guess = root_between(miss(coarse), 0, high).middle();
  std::vector<Harmonic> scaled(modes.begin(), modes.end());
  for (Harmonic& mode : scaled) mode.amplitude *= guess;
  Resolution on_it = resolution;
  on_it.fitted = false;
  const CurvedMesh mesh = harmonic_sphere(scaled, on_it);
  constexpr double range = 1.05;  // coarse and fine mesh differ by less
  const auto fine = miss(mesh);
  if (!(fine(guess / range) > 0 && fine(guess * range) < 0))
    throw std::invalid_argument(
        fmt::format("harmonics: reduced volume {}: {} triangles of order {} are too few for it", v,
                    mesh.triangle_count(), mesh.order));
  const double factor = root_between(fine, guess / range, guess * range).middle();
  CurvedMesh result = with_factor(mesh, factor);
  fit_to([&](const Vector3d& d) { return 1 + factor * harmonic_sum(modes, d); }, resolution,
         result);
  restore(v, resolution, result);
  return result;
}

}  // namespace sbeh::meshing
