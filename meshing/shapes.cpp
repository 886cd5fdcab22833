#include "meshing/shapes.h"

#include "meshing/curving.h"
#include "meshing/icosphere.h"
#include "meshing/measures.h"
#include "meshing/remeshing.h"
#include "meshing/smoothing.h"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace sbeh::meshing {

using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr double thinnest = 100;   // ratio of semi-axes
constexpr double good_angle = 40;  // degrees: below, new triangles are tried

int divisions(int triangles) { return std::max(1, int(std::lround(std::sqrt(triangles / 20.)))); }

// Reduced volume of the spheroid with polar/equatorial = q, from its closed-form area.
double spheroid_reduced_volume(double q) {
  const double e = std::sqrt(std::abs(1 - q * q));
  double area = 4 * pi;
  if (e > 1e-6) area = 2 * pi * (1 + q * q / e * (q < 1 ? std::atanh(e) : std::atan(e)));
  return reduced_volume(area, 4 * pi / 3 * q);
}

template <class F>
double root(const F& f, double low, double high) {
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

}  // namespace

void Resolution::validate() const {
  if (triangles < 20 || triangles > 2'000'000)
    throw std::invalid_argument(
        fmt::format("triangles = {}: must be in 20 ... 2000000", triangles));
  if (order < 1 || order > 3)
    throw std::invalid_argument(fmt::format("order = {}: must be 1, 2 or 3", order));
  if (!(grading >= 0 && grading <= 10))
    throw std::invalid_argument(fmt::format("grading = {}: must be in 0 ... 10", grading));
}

int triangle_count(int wanted) {
  const int n = divisions(wanted);
  return 20 * n * n;
}

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
  int n = divisions(resolution.triangles), halvings = 0;
  constexpr int coarsest = 4;  // divisions that a shape needs at least for its triangles to settle
  for (; n % 2 == 0 && n / 2 >= coarsest; n /= 2) ++halvings;
  TriangleMesh mesh = refined(icosphere(n), halvings, radially, resolution.grading);
  if (resolution.grading == 0 && min_angle(mesh) < good_angle) {
    TriangleMesh other = remeshed(mesh, mesh.triangle_count(), radially, resolution.grading);
    if (min_angle(other) > min_angle(mesh)) mesh = std::move(other);
  }
  return curved(mesh, resolution.order, radially);
}

CurvedMesh sphere(const Resolution& resolution) {
  return star_shaped([](const Vector3d&) { return 1.; }, resolution);
}

CurvedMesh ellipsoid(const Vector3d& semi_axes, const Resolution& resolution) {
  if (!(semi_axes.minCoeff() > 0 && std::isfinite(semi_axes.maxCoeff())))
    throw std::invalid_argument(fmt::format("ellipsoid: semi-axes {}, {}, {}: must be > 0",
                                            semi_axes[0], semi_axes[1], semi_axes[2]));
  if (semi_axes.maxCoeff() > thinnest * semi_axes.minCoeff())
    throw std::invalid_argument(
        fmt::format("ellipsoid: semi-axes {}, {}, {}: must not differ by more than a factor of {}",
                    semi_axes[0], semi_axes[1], semi_axes[2], thinnest));
  return star_shaped([=](const Vector3d& d) { return 1 / d.cwiseQuotient(semi_axes).norm(); },
                     resolution);
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
    q = root([&](double x) { return spheroid_reduced_volume(x) - v; }, std::min(extreme, 1.),
             std::max(extreme, 1.));
  CurvedMesh mesh = ellipsoid(Vector3d(1, 1, q), resolution);
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
    mesh = stretched(root([&](double s) { return reduced_volume(stretched(s)) - v; },
                          std::min(too_far, 1 / q), std::max(too_far, 1 / q)));
  }
  scale_to_area(mesh, 4 * pi);
  return mesh;
}

CurvedMesh harmonic_sphere(std::span<const Harmonic> modes, const Resolution& resolution) {
  return star_shaped([modes](const Vector3d& d) { return 1 + harmonic_sum(modes, d); }, resolution);
}

}  // namespace sbeh::meshing
