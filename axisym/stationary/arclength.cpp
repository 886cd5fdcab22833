#include "axisym/stationary/arclength.h"

#include "axisym/redistribute.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

namespace {
constexpr double least_cosine = 0.6;  // between tangents of a step: more turning means a jump
constexpr int quick_iterations = 9;   // more than these: the prediction was not on the branch
constexpr double tolerance =
    1e-6;  // on the last change on the way; the error left is about its square

// Length of a direction: root mean square of motion and order, and the parameter.
double length_of(const Increment& t) {
  return std::sqrt((t.d.squaredNorm() + t.beta.squaredNorm()) / double(t.d.size())
                   + t.parameter * t.parameter);
}

double cosine(const Increment& a, const Increment& b) {
  return (a.d.dot(b.d) + a.beta.dot(b.beta)) / double(a.d.size()) + a.parameter * b.parameter;
}

}  // namespace

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
  if (mu == 1) return to_;  // exactly
  return {from_.reduced_volume + mu * (to_.reduced_volume - from_.reduced_volume),
          from_.L + mu * (to_.L - from_.L)};
}

Eigen::VectorXd Line::gradient_rate(double mu, const StationaryState& s) const {
  if (to_.L == from_.L) return Eigen::VectorXd::Zero(node_unknowns * s.state.beta.size());
  return (to_.L - from_.L) * gradient_rate_by_L(material(mu), s, node_normals(s.state.X));
}

namespace {

// The equation of the hyperplane across `direction`, in the length of length_of.
Parameter across(const Line& line, double mu, const StationaryState& s,
                 const Increment& direction) {
  Increment row = scaled(direction, 1. / double(direction.d.size()));
  row.parameter = direction.parameter;
  return {line.gradient_rate(mu, s), line.volume_rate(), row};
}

}  // namespace

std::optional<PathState> with_tangent(const Line& line, double mu, const StationaryState& s,
                                      const Increment* forward) {
  NewtonSystem system(line.material(mu), line.model(), int(s.state.beta.size()));
  if (!system.linearise(s)) return {};
  Increment t, ahead;
  // Along μ for the sign of the determinant, and for the direction where there is no other.
  const bool regular = system.tangent(line.gradient_rate(mu, s), line.volume_rate(), ahead);
  const int sign = regular ? system.determinant_sign() : 0;
  if (forward) {
    if (!system.tangent(across(line, mu, s, *forward), t)) return {};
  } else if (regular) {
    t = ahead;
  } else {
    return {};
  }
  return PathState{mu, s, scaled(t, 1 / length_of(t)), sign};
}

std::optional<PathState> arc_step(const Line& line, const PathState& from, double ds) {
  double mu = from.mu + ds * from.tangent.parameter;
  if (!line.contains(mu)) return {};
  StationaryState s = from.s;
  displace(from.tangent, ds, s);
  for (int iteration = 0; iteration < quick_iterations; ++iteration) {
    NewtonSystem system(line.material(mu), line.model(), int(s.state.beta.size()));
    const Parameter parameter = across(line, mu, s, from.tangent);
    Increment step;
    if (!system.linearise(s) || !system.newton_step(line.target(mu), parameter, 0, step)) return {};
    const double change = largest_change(step);
    if (!(change < 0.3)) return {};
    system.apply(step, 1, s);
    mu += step.parameter;
    if (change < tolerance) {
      auto arrived = with_tangent(line, mu, s, &from.tangent);
      return arrived && cosine(arrived->tangent, from.tangent) > least_cosine ? arrived
                                                                              : std::nullopt;
    }
  }
  return {};
}

PathState locate_fold(const Line& line, const PathState& start, const PathState& beyond,
                      double ds) {
  PathState before = start, best = beyond;
  const double sign = start.tangent.parameter < 0 ? -1 : 1;  // before the fold
  const auto slope = [sign](const PathState& p) { return sign * p.tangent.parameter; };
  double h = ds * slope(before) / (slope(before) - slope(beyond));
  for (int iteration = 0; iteration < 40 && std::abs(slope(best)) > 1e-8 && h > 1e-12;
       ++iteration) {
    const auto next = arc_step(line, before, h);
    if (!next) {
      h /= 2;
      continue;
    }
    if (std::abs(slope(*next)) < std::abs(slope(best))) best = *next;
    const double zero = h * slope(before) / (slope(before) - slope(*next));
    if (slope(*next) > 0) {  // not there yet: go on from the nearer state
      before = *next;
      h = std::max(zero - h, 1e-12);
    } else {
      h = zero;
    }
  }
  return best;
}

PathState with_fresh_nodes(const Line& line, const PathState& state, double grading) {
  const NewtonResult r = solve_stationary(line.material(state.mu), line.model(),
                                          line.target(state.mu), redistribute(state.s, grading),
                                          {.iterations = quick_iterations, .tolerance = tolerance});
  if (r.status != NewtonStatus::converged) return state;
  // The tangent as a field over the old nodes still tells which way is forward.
  const auto fresh = with_tangent(line, state.mu, r.solution, &state.tangent);
  return fresh ? *fresh : state;
}

}  // namespace sbeh::axisym
