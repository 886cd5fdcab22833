#include "axisym/arclength.h"

#include "axisym/redistribute.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

namespace {
constexpr int quick_iterations = 6;  // more than these: the prediction was not on the branch

// Length of a direction: root mean square of motion and order, and the parameter.
double length_of(const Increment& t) {
  return std::sqrt((t.d.squaredNorm() + t.beta.squaredNorm()) / double(t.d.size())
                   + t.parameter * t.parameter);
}
double dot(const Increment& a, const Increment& b) {
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
  return (to_.L - from_.L) * gradient_rate_by_L(material(mu), model_, s);
}

std::optional<PathState> with_tangent(const Line& line, double mu, const StationaryState& s,
                                      const Increment* forward) {
  NewtonSystem system(line.material(mu), line.model(), int(s.state.beta.size()));
  Increment t;
  if (!system.linearise(s) || !system.tangent(line.gradient_rate(mu, s), line.volume_rate(), t))
    return {};
  t = scaled(t, 1 / length_of(t));
  if (forward && dot(t, *forward) < 0) t = scaled(t, -1);
  return PathState{mu, s, t, system.determinant_sign()};
}

std::optional<PathState> arc_step(const Line& line, const PathState& from, double ds) {
  double mu = from.mu + ds * from.tangent.parameter;
  if (!line.contains(mu)) return {};
  StationaryState s = from.s;
  {
    NewtonSystem system(line.material(from.mu), line.model(), int(s.state.beta.size()));
    if (!system.linearise(s)) return {};
    system.apply(from.tangent, ds, s);
  }
  Increment row = scaled(from.tangent, 1. / double(from.tangent.d.size()));
  row.parameter = from.tangent.parameter;
  for (int iteration = 0; iteration < quick_iterations; ++iteration) {
    NewtonSystem system(line.material(mu), line.model(), int(s.state.beta.size()));
    const Parameter parameter{line.gradient_rate(mu, s), line.volume_rate(), row};
    Increment step;
    if (!system.linearise(s) || !system.newton_step(line.target(mu), parameter, 0, step)) return {};
    const double change = largest_change(step);
    if (!(change < 0.3)) return {};
    system.apply(step, 1, s);
    mu += step.parameter;
    if (change < NewtonOptions{}.tolerance) return with_tangent(line, mu, s, &from.tangent);
  }
  return {};
}

PathState locate_fold(const Line& line, const PathState& before, const PathState& beyond,
                      double ds) {
  double a = 0, fa = before.tangent.parameter, b = ds, fb = beyond.tangent.parameter;
  PathState best = std::abs(fa) < std::abs(fb) ? before : beyond;
  for (int iteration = 0; iteration < 20 && std::abs(best.tangent.parameter) > 1e-7; ++iteration) {
    const double c = (a * fb - b * fa) / (fb - fa);
    const auto middle = arc_step(line, before, c);
    if (!middle) break;
    best = *middle;
    const double fc = middle->tangent.parameter;
    if (fc * fb < 0) {
      a = b;
      fa = fb;
    } else {
      fa /= 2;
    }
    b = c;
    fb = fc;
  }
  return best;
}

PathState with_fresh_nodes(const Line& line, const PathState& state, double grading) {
  const NewtonResult r =
    solve_stationary(line.material(state.mu), line.model(), line.target(state.mu),
                     redistribute(state.s, grading), {.iterations = quick_iterations});
  if (r.status != NewtonStatus::converged) return state;
  // The tangent as a field over the old nodes still tells which way is forward.
  const auto fresh = with_tangent(line, state.mu, r.solution, &state.tangent);
  return fresh ? *fresh : state;
}

}  // namespace sbeh::axisym
