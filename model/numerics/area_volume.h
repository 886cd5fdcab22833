// Area and volume of a closed surface as constraints.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace sbeh::model {

/// The area and volume that a surface keeps, and ∫β dS where the order is conserved.
struct Target {
  double area;
  double volume;
  std::optional<double> order{};
};

/// V_r = 6√π V / A^{3/2}, 1 for the sphere.
double reduced_volume(double area, double volume);

/// The (a, b) at which `miss`, the relative differences (A/A₀ − 1, V/V₀ − 1) of a surface displaced by
/// (a + bH) n, vanishes to 1e-12: Newton's method, with `slope` (row: difference, column: a, b) evaluated
/// again only where that of before brings less than a digit. On a sphere, where a and b are the same
/// motion, b = 0 and the area alone counts. Empty when it does not converge.
std::optional<Eigen::Vector2d> solve_area_volume(
    const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& miss,
    const std::function<Eigen::Matrix2d(const Eigen::Vector2d&)>& slope, bool sphere);
/// The same with the slope by central differences.
std::optional<Eigen::Vector2d> solve_area_volume(
    const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& miss, bool sphere);

}  // namespace sbeh::model
