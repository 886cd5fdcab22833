#include "axisym/stationary/arclength.h"

#include "axisym/redistribute.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

double length_of(const Increment& t) {
  return std::sqrt((t.d.squaredNorm() + t.beta.squaredNorm()) / double(t.d.size())
                   + t.parameter * t.parameter);
}

Increment scaled(Increment t, double factor) {
  for (Field* f : {&t.d, &t.Lambda, &t.H, &t.beta}) *f *= factor;
  t.tension *= factor;
  t.pressure *= factor;
  t.parameter *= factor;
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

Eigen::VectorXd Line::gradient_rate(double mu, const StationaryState& s) const {
  if (to.L == from.L) return Eigen::VectorXd::Zero(node_unknowns * s.state.beta.size());
  return (to.L - from.L) * gradient_rate_by_L(material(mu), s, node_normals(s.state.X));
}

namespace {

// The equation of the hyperplane across `direction`, in the length of length_of.
Parameter across(const Line& line, const Eigen::VectorXd& gradient_rate,
                 const Increment& direction) {
  Increment row = scaled(direction, 1. / double(direction.d.size()));
  row.parameter = direction.parameter;
  return {gradient_rate, line.volume_rate(), row};
}

NewtonSystem system_at(const Line& line, const LineState& at) {
  return {line.material(at.mu), line.model, int(at.s.state.beta.size())};
}

}  // namespace

double cosine(const PathState& p, const PathState& q) {
  const Increment &a = p.tangent, &b = q.tangent;
  return (a.d.dot(b.d) + a.beta.dot(b.beta)) / double(a.d.size()) + a.parameter * b.parameter;
}

std::optional<PathState> with_tangent(const Line& line, const LineState& at,
                                      const Increment* forward) {
  NewtonSystem system = system_at(line, at);
  if (!system.linearise(at.s)) return {};
  Increment t, ahead;
  const Eigen::VectorXd gradient_rate = line.gradient_rate(at.mu, at.s);
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
  return PathState{at, scaled(t, 1 / length_of(t)), sign};
}

std::optional<LineState> predicted(const Line& line, const PathState& from, double ds) {
  LineState x{from.mu + ds * from.tangent.parameter, from.s};
  if (!line.contains(x.mu)) return {};
  displace(from.tangent, ds, x.s);
  return x;
}

std::optional<double> newton_step(const Line& line, LineState& at, const PathState& from,
                                  double /*ds*/) {
  NewtonSystem system = system_at(line, at);
  const Parameter parameter = across(line, line.gradient_rate(at.mu, at.s), from.tangent);
  Increment step;
  if (!system.linearise(at.s) || !system.newton_step(line.target(at.mu), parameter, 0, step))
    return {};
  displace(step, 1, at.s);
  at.mu += step.parameter;
  return largest_change(step);
}

PathState with_fresh_nodes(const Line& line, const PathState& state, double grading) {
  const NewtonResult r = solve_stationary(
      line.material(state.mu), line.model, line.target(state.mu), redistribute(state.s, grading),
      {.iterations = Line::limits.most_iterations, .tolerance = Line::limits.tolerance});
  if (r.status != NewtonStatus::converged) return state;
  // The tangent as a field over the old nodes still tells which way is forward.
  const auto fresh = with_tangent(line, {state.mu, r.solution}, &state.tangent);
  return fresh ? *fresh : state;
}

}  // namespace sbeh::axisym
