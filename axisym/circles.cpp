#include "axisym/circles.h"

#include "model/numerics/root.h"

#include <cmath>

namespace sbeh::axisym {

namespace {

Circle circle_at(const Nodes& X, const Field& H, int e, const ShapeValues& s) {
  return {curve_point(X, e, s).x[0], value_at(H, e, s)};
}

// Visits the zeros in (0, 1) of the quadratic through these values at 0, 1/2, 1.
template <class Visit>
void for_each_zero(double first, double middle, double last, Visit&& visit) {
  const double a = 2 * (first + last) - 4 * middle, b = last - first - a, c = first;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
  for (const double x : {q / a, c / q})
    if (x > 0 && x < 1) visit(x);
}

}  // namespace

CurvePlace widest_place(const Nodes& X) {
  CurvePlace widest{0, 0};
  double radius = 0;
  const auto offer = [&](int e, double x, double r) {
    if (r <= radius) return;
    widest = {e, x};
    radius = r;
  };
  for (int e = 0; e < element_count(X); ++e) {
    const auto slope = [&](std::size_t k) { return curve_point(X, e, even_points<2>()[k]).dx[0]; };
    offer(e, 1, X(0, 3 * e + 3));
    for_each_zero(slope(0), slope(1), slope(2),
                  [&](double x) { offer(e, x, curve_point(X, e, shape_values(x)).x[0]); });
  }
  return widest;
}

Circle widest_circle(const Nodes& X, const Field& H) {
  const CurvePlace at = widest_place(X);
  return circle_at(X, H, at.element, shape_values(at.x));
}

Circle middle_circle(const Nodes& X, const Field& H) {
  const double middle = (X(1, 0) + X(1, X.cols() - 1)) / 2;
  Circle widest{0, 0};
  for (int e = 0; e < element_count(X); ++e) {
    if ((X(1, 3 * e) - middle) * (X(1, 3 * e + 3) - middle) > 0) continue;
    const auto height = [&](double x) { return curve_point(X, e, shape_values(x)).x[1] - middle; };
    const double x = model::root_between(height, 0, 1).middle();
    const Circle c = circle_at(X, H, e, shape_values(x));
    if (c.radius > widest.radius) widest = c;
  }
  return widest;
}

}  // namespace sbeh::axisym
