#include "surface3d/bent_shapes.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

namespace sbeh::surface3d {

namespace {

BentShapes bent_shapes(const Eigen::Vector2d& x, double weight) {
  BentShapes s{shape_values(x, weight), {}};
  const Eigen::Matrix3Xd bends = model::TriangleElement(3).second_derivatives(x);
  for (int k = 0; k < 2; ++k)
    Eigen::Map<Eigen::Matrix<double, 10, 1>>(s.ddphi[std::size_t(k)].data()) =
        bends.row(k).transpose();
  return s;
}

// On the straight line from one point to another, weights summing to 1.
BentPoints rim_points(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const model::IntervalRule rule = model::gauss_rule(6);
  BentPoints table;
  for (int k = 0; k < rule.size(); ++k)
    table.push_back(bent_shapes(from + rule.points[k] * (to - from), rule.weights[k]));
  return table;
}

}  // namespace

const BentPoints& inner_points() {
  static const BentPoints points = [] {
    const model::TriangleRule rule = model::symmetric_triangle_rule();
    BentPoints table;
    for (int k = 0; k < rule.size(); ++k)
      table.push_back(bent_shapes(rule.points.col(k), rule.weights[k]));
    return table;
  }();
  return points;
}
const BentPoints& first_rim() {
  static const BentPoints points = rim_points({0, 0}, {0, 1});
  return points;
}
const BentPoints& second_rim() {
  static const BentPoints points = rim_points({1, 0}, {0, 1});
  return points;
}

}  // namespace sbeh::surface3d
