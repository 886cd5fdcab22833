#include "surface3d/stationary/deflation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::surface3d {

StateMarks marks_of(const Triangulation& mesh, const StationaryState& state) {
  double area = 0, H = 0, H2 = 0, beta = 0, beta2 = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for_each_point(mesh, state.X, assembly_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& p) {
                   const double h = value_at(on_element(mesh, e, state.H), s),
                                b = value_at(on_element(mesh, e, state.beta), s);
                   area += p.dS;
                   centre += p.dS * p.x;
                   H += p.dS * h;
                   H2 += p.dS * h * h;
                   beta += p.dS * b;
                   beta2 += p.dS * b * b;
                 });
  centre /= area;
  const double R = std::sqrt(area / (4 * std::numbers::pi));
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Eigen::Vector3d third = Eigen::Vector3d::Zero();
  for_each_point(mesh, state.X, assembly_points(),
                 [&](int, const ShapeValues&, const SurfacePoint& p) {
                   const Eigen::Vector3d x = (p.x - centre) / R;
                   second += p.dS / area * x * x.transpose();
                   third += p.dS / area * x.squaredNorm() * x;
                 });
  const Eigen::Matrix3d squared = second * second;
  return Eigen::VectorXd{{second.trace(), squared.trace(), (squared * second).trace(),
                          third.squaredNorm(), H * R / area, H2 * R * R / area, beta / area,
                          beta2 / area}};
}

bool is_known(const KnownStates& known, const StateMarks& marks) {
  return std::ranges::any_of(
      known, [&](const StateMarks& other) { return (marks - other).norm() < same_marks; });
}

double deflation(const KnownStates& known, const Triangulation& mesh, const StationaryState& state,
                 const Nodes& normals, const Increment& step) {
  if (known.empty()) return 1;
  constexpr double change = 1e-6, share = 0.01;  // of the differences; of the step at the most
  const double h = std::min(share, change / largest_change(step));
  StationaryState ahead = state, behind = state;
  displace(step, h, normals, ahead);
  displace(step, -h, normals, behind);
  const StateMarks here = marks_of(mesh, state), next = marks_of(mesh, ahead),
                   last = marks_of(mesh, behind);
  double growth = 0;  // m'Δ/m
  for (const StateMarks& other : known) {
    const double q = (here - other).squaredNorm(),
                 slope = ((next - other).squaredNorm() - (last - other).squaredNorm()) / (2 * h);
    growth -= slope / (q * (1 + q));
  }
  return 1 / (1 - growth);
}

}  // namespace sbeh::surface3d
