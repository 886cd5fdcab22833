#include "axisym/start_shapes.h"

#include "axisym/curvature.h"
#include "axisym/redistribute.h"
#include "model/numerics/root.h"
#include "model/numerics/spheroid.h"

#include <boost/math/special_functions/legendre.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::axisym {

using std::numbers::pi;

Nodes nodes_on(const std::function<Eigen::Vector2d(double)>& curve, int elements, double grading) {
  // A fine curve, uniform in θ, tells where the nodes belong; θ itself rides along as its field.
  const int fine = 8 * elements;
  State dense{.X = Nodes(2, 3 * fine + 1), .beta = Field::LinSpaced(3 * fine + 1, 0, pi)};
  for (Eigen::Index i = 0; i < dense.X.cols(); ++i) dense.X.col(i) = curve(dense.beta[i]);
  dense.X(0, 0) = dense.X(0, dense.X.cols() - 1) = 0;
  const Field theta = sample_at_lobatto(dense, dense.beta, grading, elements);
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

}  // namespace sbeh::axisym
