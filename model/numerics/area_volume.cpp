#include "model/numerics/area_volume.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>

namespace sbeh::model {

double reduced_volume(double area, double volume) {
  return 6 * std::sqrt(std::numbers::pi) * volume / std::pow(area, 1.5);
}

std::optional<Eigen::Vector2d> solve_area_volume(
    const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& miss, bool sphere) {
  Eigen::Vector2d c = Eigen::Vector2d::Zero();
  for (int iteration = 0; iteration < 12; ++iteration) {
    Eigen::Vector2d residual = miss(c);
    if (sphere) residual[1] = 0;
    if (!residual.allFinite()) return {};
    if (residual.cwiseAbs().maxCoeff() < 1e-12) return c;
    const double h = 1e-4;  // A and V are smooth and of low degree in a and b
    Eigen::Matrix2d J;
    for (int k = 0; k < 2; ++k)
      J.col(k) = (miss(c + h * Eigen::Vector2d::Unit(k)) - miss(c - h * Eigen::Vector2d::Unit(k)))
               / (2 * h);
    if (sphere) J.row(1) << 0, 1;  // b = 0
    c -= J.fullPivLu().solve(residual);
  }
  return {};
}

}  // namespace sbeh::model
