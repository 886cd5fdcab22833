#include "axisym/modes/rigid_motions.h"

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

// Without what is beyond the equator in an element that it cuts.
RigidMotion motion_of(const SecondVariation& second, const RigidVelocity& velocity) {
  const StationaryState& state = second.state;
  const Nodes n = node_normals(state.X);
  const Field slope = order_slope(state), none = Field::Zero(3 * second.sector.elements() + 1);
  RigidMotion motion{velocity, none, none};
  for (Eigen::Index i = 0; i < second.sector.nodes(); ++i) {
    const Eigen::Vector2d v = velocity.meridian(state.X.col(i)), nu = n.col(i), t(nu[1], -nu[0]);
    motion.u[i] = v.dot(nu);
    motion.b[i] = -v.dot(t) * slope[i];
  }
  return motion;
}

std::vector<RigidVelocity> velocities_of(const StationaryState& state, int m, Parity parity) {
  const double middle = (state.X(1, 0) + state.X(1, state.X.cols() - 1)) / 2;
  std::vector<RigidVelocity> velocities;
  if (m == 0 && parity != Parity::even) velocities.push_back({.along = 1});
  if (m == 1 && parity != Parity::odd) velocities.push_back({.across = 1});
  if (m == 1 && parity != Parity::even) velocities.push_back({.turn = 1, .middle = middle});
  return velocities;
}

// About the axis across of the one that turns.
RigidVelocity sum(double a, const RigidVelocity& x, double b, const RigidVelocity& y) {
  return {a * x.along + b * y.along, a * x.across + b * y.across, a * x.turn + b * y.turn,
          x.turn == 0 ? y.middle : x.middle};
}

Eigen::VectorXd fields_of(const RigidMotion& motion) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(node_unknowns * motion.u.size());
  for (Eigen::Index i = 0; i < motion.u.size(); ++i) {
    x[index(i, node_d)] = motion.u[i];
    x[index(i, node_beta)] = motion.b[i];
  }
  return x;
}

}  // namespace

Eigen::MatrixXd unknowns_of(const std::vector<RigidMotion>& motions) {
  Eigen::MatrixXd columns;
  for (const RigidMotion& motion : motions) {
    columns.conservativeResize(node_unknowns * motion.u.size(), columns.cols() + 1);
    columns.rightCols(1) = fields_of(motion);
  }
  return columns;
}

std::vector<RigidMotion> rigid_motions(const SecondVariation& second, int m, Parity parity,
                                       const NodeChain& mass) {
  constexpr double none = 1e-6;  // a sphere's rotation moves nothing
  const auto product = [&](const RigidMotion& a, const RigidMotion& b) {
    return fields_of(a).dot(mass.times(fields_of(b)));
  };
  std::vector<RigidMotion> rigid;
  for (RigidVelocity velocity : velocities_of(second.state, m, parity)) {
    // Without up-down symmetry a translation across and the rotation are not orthogonal.
    for (const RigidMotion& other : rigid)
      velocity = sum(1, velocity, -product(other, motion_of(second, velocity)), other.velocity);
    const RigidMotion motion = motion_of(second, velocity);
    const double square = product(motion, motion);
    if (square > none)
      rigid.push_back(motion_of(second, sum(1 / std::sqrt(square), velocity, 0, velocity)));
  }
  return rigid;
}

}  // namespace sbeh::axisym
