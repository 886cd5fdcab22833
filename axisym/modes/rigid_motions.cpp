#include "axisym/modes/rigid_motions.h"

#include "axisym/stationary/newton_system.h"

#include <cmath>

namespace sbeh::axisym {

namespace {

// β' by arc length at the nodes, at joints the mean of both elements.
Field order_slope(const State& state) {
  static const std::array at_nodes = {shape_values(0), shape_values((1 - std::sqrt(0.2)) / 2),
                                      shape_values((1 + std::sqrt(0.2)) / 2), shape_values(1)};
  const Eigen::Index nodes = state.beta.size();
  Field slope = Field::Zero(nodes);
  for (int e = 0; e < element_count(state.X); ++e)
    for (int a = 0; a < 4; ++a) {
      const ShapeValues& s = at_nodes[std::size_t(a)];
      const Eigen::Index i = 3 * e + a;
      const bool is_shared = a % 3 == 0 && i > 0 && i + 1 < nodes;
      slope[i] +=
          (is_shared ? 0.5 : 1) * slope_at(state.beta, e, s) / curve_point(state.X, e, s).stretch;
    }
  return slope;
}

std::vector<Eigen::VectorXd> motions_of(const StationaryState& state, int m) {
  const Nodes n = node_normals(state.X);
  const Field slope = order_slope(state);
  const Eigen::Index nodes = state.beta.size();
  const auto motion = [&](auto&& velocity) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(node_unknowns * nodes);
    for (Eigen::Index i = 0; i < nodes; ++i) {
      const Eigen::Vector2d v = velocity(state.X.col(i)), nu = n.col(i), t(nu[1], -nu[0]);
      x[index(i, node_d)] = v.dot(nu);
      x[index(i, node_beta)] = -v.dot(t) * slope[i];
    }
    return x;
  };
  const double middle = (state.X(1, 0) + state.X(1, nodes - 1)) / 2;
  using Vector = Eigen::Vector2d;
  if (m == 0) return {motion([](const Vector&) { return Vector(0, 1); })};
  if (m > 1) return {};
  return {motion([](const Vector&) { return Vector(1, 0); }),
          motion([middle](const Vector& x) { return Vector(x[1] - middle, -x[0]); })};
}

}  // namespace

std::vector<Eigen::VectorXd> rigid_motions(const SecondVariation& second, int m) {
  constexpr double none = 1e-6;  // a sphere's rotation moves nothing
  const model::BandMatrix mass = second.mass_of(m);
  std::vector<Eigen::VectorXd> rigid;
  for (Eigen::VectorXd& motion : motions_of(second.state, m)) {
    // Without up-down symmetry a translation across and the rotation are not orthogonal.
    for (const Eigen::VectorXd& other : rigid) motion -= other.dot(mass.times(motion)) * other;
    if (const double square = motion.dot(mass.times(motion)); square > none)
      rigid.emplace_back(motion / std::sqrt(square));
  }
  return rigid;
}

}  // namespace sbeh::axisym
