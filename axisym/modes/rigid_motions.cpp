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

// Given by the velocity in the meridian plane and that across, at (r, z).
template <class Meridian, class Across>
RigidMotion motion_of(const StationaryState& state, Meridian&& meridian, Across&& across) {
  const Nodes n = node_normals(state.X);
  const Field slope = order_slope(state);
  const Eigen::Index nodes = state.beta.size();
  RigidMotion motion{Field(nodes), Field(nodes), Field(nodes), Field(nodes)};
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const Eigen::Vector2d x = state.X.col(i), v = meridian(x), nu = n.col(i), t(nu[1], -nu[0]);
    motion.u[i] = v.dot(nu);
    motion.v_t[i] = v.dot(t);
    motion.b[i] = -motion.v_t[i] * slope[i];
    motion.v_phi[i] = across(x);
  }
  return motion;
}

std::vector<RigidMotion> motions_of(const StationaryState& state, int m) {
  using Vector = Eigen::Vector2d;
  const auto vector = [](double r, double z) {
    return [=](const Vector&) { return Vector(r, z); };
  };
  const auto number = [](double value) { return [=](const Vector&) { return value; }; };
  const double middle = (state.X(1, 0) + state.X(1, state.X.cols() - 1)) / 2;
  if (m == 0) return {motion_of(state, vector(0, 1), number(0))};
  if (m > 1) return {};
  return {motion_of(state, vector(1, 0), number(-1)),
          motion_of(
              state, [&](const Vector& x) { return Vector(x[1] - middle, -x[0]); },
              [&](const Vector& x) { return middle - x[1]; })};
}

RigidMotion sum(const RigidMotion& a, double factor, const RigidMotion& b) {
  return {a.u + factor * b.u, a.b + factor * b.b, a.v_t + factor * b.v_t,
          a.v_phi + factor * b.v_phi};
}

}  // namespace

Eigen::VectorXd unknowns_of(const RigidMotion& motion) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(node_unknowns * motion.u.size());
  for (Eigen::Index i = 0; i < motion.u.size(); ++i) {
    x[index(i, node_d)] = motion.u[i];
    x[index(i, node_beta)] = motion.b[i];
  }
  return x;
}

std::vector<RigidMotion> rigid_motions(const StationaryState& state, int m,
                                       const model::BandMatrix& mass) {
  constexpr double none = 1e-6;  // a sphere's rotation moves nothing
  const auto product = [&](const RigidMotion& a, const RigidMotion& b) {
    return unknowns_of(a).dot(mass.times(unknowns_of(b)));
  };
  std::vector<RigidMotion> rigid;
  for (RigidMotion& motion : motions_of(state, m)) {
    // Without up-down symmetry a translation across and the rotation are not orthogonal.
    for (const RigidMotion& other : rigid) motion = sum(motion, -product(other, motion), other);
    const double square = product(motion, motion);
    if (square > none) rigid.push_back(sum(motion, 1 / std::sqrt(square) - 1, motion));
  }
  return rigid;
}

}  // namespace sbeh::axisym
