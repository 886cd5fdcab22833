#include "axisym/start_shapes.h"

#include "axisym/curvature.h"
#include "axisym/redistribute.h"
#include "axisym/shape_class.h"
#include "model/numerics/area_volume.h"
#include "model/numerics/root.h"
#include "model/numerics/spheroid.h"

#include <boost/math/special_functions/legendre.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace sbeh::axisym {

using std::numbers::pi;

Nodes nodes_on(const std::function<Eigen::Vector2d(double)>& curve, int elements, double grading) {
  // A fine curve, uniform in θ, tells where the nodes belong.
  const int fine = 8 * elements;
  const Field angles = Field::LinSpaced(3 * fine + 1, 0, pi);
  State dense{.X = Nodes(2, 3 * fine + 1), .beta = Field::Zero(3 * fine + 1)};
  for (Eigen::Index i = 0; i < dense.X.cols(); ++i) dense.X.col(i) = curve(angles[i]);
  dense.X(0, 0) = dense.X(0, dense.X.cols() - 1) = 0;
  const Field theta = sample_at_lobatto(dense, angles, grading, elements);
  Nodes points(2, theta.size()), X(2, theta.size());
  for (Eigen::Index i = 0; i < theta.size(); ++i) points.col(i) = curve(theta[i]);
  for (int k = 0; k < 2; ++k) X.row(k) = nodal_values(points.row(k).transpose()).transpose();
  X(0, 0) = X(0, X.cols() - 1) = 0;
  return X * std::sqrt(4 * pi / area(X));
}

Nodes spheroid(double equatorial, double polar, int elements, double grading) {
  if (!(equatorial > 0 && polar > 0))
    throw std::invalid_argument("spheroid: both semi-axes must be > 0");
  return nodes_on(
      [=](double theta) {
        return Eigen::Vector2d(equatorial * std::sin(theta), polar * std::cos(theta));
      },
      elements, grading);
}

Nodes spheroid(double v, bool prolate, int elements, double grading) {
  if (!(v > 0 && v <= 1))
    throw std::invalid_argument(
        fmt::format("spheroid: reduced volume {}: must be in 0 < V_r <= 1", v));
  const double q = model::spheroid_axis_ratio(v, prolate);
  Nodes X = spheroid(1, q, elements, grading);
  if (correct_area_volume(X, 4 * pi, 4 * pi / 3 * v)) return X;
  // Too sharp for a small displacement along the normal: the spheroid whose elements hold the volume.
  const auto held = [&](double log_q) {
    const Nodes Y = spheroid(1, std::exp(log_q), elements, grading);
    return reduced_volume(area(Y), volume(Y)) / v - 1;
  };
  const double near = std::log(q), low = near - 1, high = near + 1;
  if (!(held(low) * held(high) < 0))
    throw std::invalid_argument(
        fmt::format("spheroid: reduced volume {}: {} elements cannot hold one so {}; give more "
                    "elements or a larger reduced volume",
                    v, elements, prolate ? "thin" : "flat"));
  return spheroid(1, std::exp(model::root_between(held, low, high, 48).low), elements, grading);
}

double zonal_sum(std::span<const Mode> modes, double theta) {
  double sum = 0;
  for (const Mode& mode : modes) {
    if (mode.l < 0)
      throw std::invalid_argument(fmt::format("harmonic: l = {}: must be >= 0", mode.l));
    sum += mode.amplitude * std::sqrt((2 * mode.l + 1) / (4 * pi))
         * boost::math::legendre_p(mode.l, std::cos(theta));
  }
  return sum;
}

Nodes harmonic_sphere(std::span<const Mode> modes, int elements, double grading) {
  return nodes_on(
      [modes](double theta) {
        const double radius = 1 + zonal_sum(modes, theta);
        if (!(radius > 0))
          throw std::invalid_argument(fmt::format(
              "harmonic sphere: r = {:.3g} at theta = {:.3g}: must be > 0", radius, theta));
        return Eigen::Vector2d(radius * std::sin(theta), radius * std::cos(theta));
      },
      elements, grading);
}

Nodes harmonic_sphere(std::span<const Mode> modes, double v, int elements, double grading) {
  if (!(v > 0 && v < 1))
    throw std::invalid_argument(
        fmt::format("harmonic sphere: reduced volume {}: must be > 0 and < 1", v));
  const auto with_factor = [&](double factor) {
    std::vector<Mode> scaled(modes.begin(), modes.end());
    for (Mode& mode : scaled) mode.amplitude *= factor;
    return harmonic_sphere(scaled, elements, grading);
  };
  const auto excess = [&](double factor) {
    const Nodes X = with_factor(factor);
    return reduced_volume(area(X), volume(X)) - v;
  };
  double low = 0, high = 1e-6, reached = excess(low);
  try {
    for (double next = excess(high); next > 0; next = excess(high))
      low = high, high *= 1.2, reached = next;
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument(fmt::format(
        "harmonic sphere: reduced volume {}: r reaches 0 before, at {:.4g}", v, v + reached));
  }
  if (!(reached > 0))
    throw std::invalid_argument(
        fmt::format("harmonic sphere: reduced volume {}: {} elements hold one of {} at most", v,
                    elements, v + reached));
  return with_factor(model::root_between(excess, low, high).middle());
}

Nodes perturbed(const Nodes& X, std::span<const Mode> modes) {
  const double A = area(X), V = volume(X);
  double middle = 0;
  for_each_point(X, assembly_points(), [&](int, const ShapeValues&, const CurvePoint& p) {
    middle += p.dS * p.x[1] / A;
  });
  // The normals and the curvature of X bring back area and volume: those of the perturbed curve are rough.
  const Nodes n = node_normals(X);
  const Field H = mean_curvature(X);
  const auto moved = [&](const Eigen::Vector2d& by) {
    Nodes Y = X;
    for (Eigen::Index i = 0; i < X.cols(); ++i) {
      const double theta = std::atan2(X(0, i), X(1, i) - middle);
      Y.col(i) += (zonal_sum(modes, theta) + by[0] + by[1] * H[i]) * n.col(i);
    }
    return Y;
  };
  const auto miss = [&](const Eigen::Vector2d& by) -> Eigen::Vector2d {
    const Nodes Y = moved(by);
    return {area(Y) / A - 1, volume(Y) / V - 1};
  };
  const auto by = model::solve_area_volume(miss, is_sphere(A, V));
  if (!by)
    throw std::invalid_argument(
        fmt::format("no shape near has the reduced volume {:.6g}", reduced_volume(A, V)));
  Nodes Y = moved(*by);
  if (crosses_itself(Y)) throw std::invalid_argument("the surface would pass through itself");
  return Y;
}

}  // namespace sbeh::axisym
