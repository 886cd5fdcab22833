#include "model/numerics/area_volume.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace sbeh::model {

double reduced_volume(double area, double volume) {
  return 6 * std::sqrt(std::numbers::pi) * volume / std::pow(area, 1.5);
}

std::optional<Eigen::Vector2d> solve_area_volume(
    const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& miss,
    const std::function<Eigen::Matrix2d(const Eigen::Vector2d&)>& slope, bool sphere) {
  Eigen::Vector2d c = Eigen::Vector2d::Zero();
  Eigen::FullPivLU<Eigen::Matrix2d> J;
  double before = 0;
  for (int iteration = 0; iteration < 20; ++iteration) {
    Eigen::Vector2d residual = miss(c);
    if (sphere) residual[1] = 0;
    if (!residual.allFinite()) return {};
    const double size = residual.cwiseAbs().maxCoeff();
    if (size < 1e-12) return c;
    if (iteration == 0 || size > 0.1 * before) {
      Eigen::Matrix2d derivative = slope(c);
      if (sphere) derivative.row(1) << 0, 1;  // b = 0
      J.compute(derivative);
    }
    c -= J.solve(residual);
    before = size;
  }
  return {};
}

std::optional<Eigen::Vector2d> solve_area_volume(
    const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& miss, bool sphere) {
  const auto slope = [&](const Eigen::Vector2d& c) {
    const double h = 1e-4;  // A and V are smooth and of low degree in a and b
    Eigen::Matrix2d J;
    for (int k = 0; k < 2; ++k)
      J.col(k) = (miss(c + h * Eigen::Vector2d::Unit(k)) - miss(c - h * Eigen::Vector2d::Unit(k)))
               / (2 * h);
    return J;
  };
  return solve_area_volume(miss, slope, sphere);
}

}  // namespace sbeh::model
