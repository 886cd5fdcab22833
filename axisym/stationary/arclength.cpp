#include "axisym/stationary/arclength.h"

#include "axisym/redistribute.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

double length_of(const Increment& t) {
  return std::sqrt((t.d.squaredNorm() + t.beta.squaredNorm()) / double(t.d.size()) + t.mu * t.mu);
}

Increment scaled(Increment t, double factor) {
  for (Field* f : {&t.d, &t.Lambda, &t.H, &t.beta}) *f *= factor;
  t.tension *= factor;
  t.pressure *= factor;
  t.mu *= factor;
  return t;
}

double largest_change(const Increment& step) {
  return std::max(step.d.cwiseAbs().maxCoeff(), step.beta.cwiseAbs().maxCoeff());
}

PlanePoint Line::at(double mu) const {
  if (mu == 1) return to;  // exactly
  return {from.reduced_volume + mu * (to.reduced_volume - from.reduced_volume),
          from.L + mu * (to.L - from.L)};
}

Eigen::VectorXd Line::gradient_rate(const LineState& state) const {
  if (to.L == from.L) return Eigen::VectorXd::Zero(node_unknowns * state.beta.size());
  return (to.L - from.L) * gradient_rate_by_L(material_at(state.mu), state, node_normals(state.X));
}

namespace {

// The equation of the hyperplane across `direction`, in the length of length_of.
PathEquation across(const Line& line, const Eigen::VectorXd& gradient_rate,
                    const Increment& direction) {
  Increment row = scaled(direction, 1. / double(direction.d.size()));
  row.mu = direction.mu;
  return {gradient_rate, line.volume_rate(), row};
}

NewtonSystem system_at(const Line& line, const LineState& state) {
  return {line.material_at(state.mu), line.model, int(state.beta.size())};
}

}  // namespace

double cosine(const PathState& p, const PathState& q) {
  const Increment &a = p.tangent, &b = q.tangent;
  return (a.d.dot(b.d) + a.beta.dot(b.beta)) / double(a.d.size()) + a.mu * b.mu;
}

std::optional<PathState> with_tangent(const Line& line, const LineState& state,
                                      const Increment* forward) {
  NewtonSystem system = system_at(line, state);
  if (!system.linearise(state)) return {};
  Increment t, ahead;
  const Eigen::VectorXd gradient_rate = line.gradient_rate(state);
  // Along μ for the sign of the determinant, and for the direction where there is no other.
  const bool regular = system.tangent(gradient_rate, line.volume_rate(), ahead);
  const int sign = regular ? system.determinant_sign() : 0;
  if (forward) {
    if (!system.tangent(across(line, gradient_rate, *forward), t)) return {};
  } else if (regular) {
    t = ahead;
  } else {
    return {};
  }
  return PathState{state, scaled(t, 1 / length_of(t)), sign};
}

std::optional<LineState> predicted(const Line& line, const PathState& from, double ds) {
  LineState guess = from;
  guess.mu += ds * from.tangent.mu;
  if (!line.contains(guess.mu)) return {};
  displace(from.tangent, ds, guess);
  return guess;
}

std::optional<double> newton_step(const Line& line, LineState& state, const PathState& from,
                                  double /*ds*/) {
  NewtonSystem system = system_at(line, state);
  const PathEquation path = across(line, line.gradient_rate(state), from.tangent);
  Increment step;
  if (!system.linearise(state) || !system.newton_step(line.target(state.mu), path, 0, step))
    return {};
  displace(step, 1, state);
  state.mu += step.mu;
  return largest_change(step);
}

PathState with_fresh_nodes(const Line& line, const PathState& state, double grading) {
  const auto solved = solve_at(
      line.material, line.model, line.at(state.mu), redistribute(state, grading),
      {.most_iterations = Line::limits.most_iterations, .tolerance = Line::limits.tolerance});
  if (!solved) return state;
  // The tangent as a field over the old nodes still tells which way is forward.
  const auto fresh = with_tangent(line, {*solved, state.mu}, &state.tangent);
  return fresh ? *fresh : state;
}

}  // namespace sbeh::axisym
