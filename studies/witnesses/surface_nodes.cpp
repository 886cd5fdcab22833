#include "studies/witnesses/surface_nodes.h"

#include "surface3d/moments.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace sbeh::studies {

using surface3d::Triangulation;

namespace {

// Turns the nodes so that the axis of the surface is z and its centre the origin.
Eigen::Matrix3Xd upright(const Triangulation& mesh, const surface3d::Nodes& X) {
  const surface3d::Moments moments = moments_of(samples_of(mesh, X));
  Eigen::Vector3d z = moments.distinct_axis();
  if (z[2] < 0) z = -z;
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(z, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return turn * (X.colwise() - moments.centre);
}

// H at either end of the axis, upper one first: a + b ρ² through the nodes nearest to it.
std::array<double, 2> pole_curvatures(const Eigen::Matrix3Xd& X, const surface3d::Field& H) {
  const std::size_t count = std::min<std::size_t>(38, std::size_t(X.cols()));  // two rings of P3
  std::vector<std::pair<double, Eigen::Index>> near;                           // nodes about each
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    near.emplace_back(X.col(i).head<2>().squaredNorm(), i);
  std::partial_sort(near.begin(), near.begin() + std::ptrdiff_t(count), near.end());
  near.resize(count);
  const auto lower = [&](const auto& a, const auto& b) { return X(2, a.second) < X(2, b.second); };
  const auto [low, high] = std::minmax_element(near.begin(), near.end(), lower);
  const double middle = (X(2, low->second) + X(2, high->second)) / 2;
  std::array<double, 2> result{};
  for (const int pole : {0, 1}) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();  // of the least squares
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const auto& [rho2, i] : near) {
      if ((X(2, i) > middle) != (pole == 0)) continue;
      const Eigen::Vector2d powers(1, rho2);
      normal += powers * powers.transpose();
      right += powers * H[i];
    }
    result[std::size_t(pole)] = normal.fullPivLu().solve(right)[0];
  }
  return result;
}

}  // namespace

void place_nodes(const Triangulation& mesh, const surface3d::State& state,
                 const surface3d::Field& H, WitnessState& found) {
  const Eigen::Matrix3Xd X = upright(mesh, state.X);
  const auto [above, below] = pole_curvatures(X, H);
  found.measures.H_pole = std::max(above, below);
  found.points.resize(2, X.cols());
  found.points.row(0) = X.topRows<2>().colwise().norm();
  found.points.row(1) = (above < below ? -1 : 1) * X.row(2);
  found.order = state.beta;
}

}  // namespace sbeh::studies
