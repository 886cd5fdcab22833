#include "axisym/continuation.h"

#include "axisym/newton_system.h"
#include "axisym/redistribute.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace sbeh::axisym {

Target target_of(double reduced_volume) {
  return {4 * std::numbers::pi, 4 * std::numbers::pi / 3 * reduced_volume};
}

namespace {

constexpr int direct_iterations = 6;  // more than these: the prediction was not on the branch

// The line from one point to another, μ ∈ [0, 1], and one system at a time on it.
class Line {
 public:
  Line(const model::Material& material, model::Model model, PlanePoint from, PlanePoint to)
      : material_(material), model_(model), from_(from), to_(to) {}

  PlanePoint at(double mu) const {
    if (mu == 1) return to_;  // exactly
    return {from_.reduced_volume + mu * (to_.reduced_volume - from_.reduced_volume),
            from_.L + mu * (to_.L - from_.L)};
  }
  Target target(double mu) const { return target_of(at(mu).reduced_volume); }
  model::Material material(double mu) const { return material_.with_L(at(mu).L); }
  model::Model model() const { return model_; }

  double volume_rate() const { return target(1).volume - target(0).volume; }
  Eigen::VectorXd gradient_rate(double mu, const StationaryState& s) const {
    return (to_.L - from_.L) * gradient_rate_by_L(material(mu), model_, s);
  }

 private:
  model::Material material_;
  model::Model model_;
  PlanePoint from_, to_;
};

// Length of a direction: root mean square of motion and order, and the parameter.
double length_of(const Increment& t) {
  return std::sqrt((t.d.squaredNorm() + t.beta.squaredNorm()) / double(t.d.size())
                   + t.parameter * t.parameter);
}
double dot(const Increment& a, const Increment& b) {
  return (a.d.dot(b.d) + a.beta.dot(b.beta)) / double(a.d.size()) + a.parameter * b.parameter;
}
Increment scaled(Increment t, double factor) {
  for (Field* f : {&t.d, &t.Lambda, &t.H, &t.beta}) *f *= factor;
  t.tension *= factor;
  t.pressure *= factor;
  t.parameter *= factor;
  return t;
}

// A state on the line with its unit tangent.
struct PathState {
  double mu;
  StationaryState s;
  Increment tangent;
  int determinant_sign;
};

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

// Newton on the hyperplane at distance ds along the tangent. Empty when it does not converge fast.
std::optional<PathState> arc_step(const Line& line, const PathState& from, double ds) {
  double mu = from.mu + ds * from.tangent.parameter;
  if (line.at(mu).L <= 0 || line.at(mu).reduced_volume > 1) return {};
  StationaryState s = from.s;
  {
    NewtonSystem system(line.material(from.mu), line.model(), int(s.state.beta.size()));
    if (!system.linearise(s)) return {};
    system.apply(from.tangent, ds, s);
  }
  Increment row = scaled(from.tangent, 1. / double(from.tangent.d.size()));
  row.parameter = from.tangent.parameter;
  for (int iteration = 0; iteration < direct_iterations; ++iteration) {
    NewtonSystem system(line.material(mu), line.model(), int(s.state.beta.size()));
    const Parameter parameter{line.gradient_rate(mu, s), line.volume_rate(), row};
    Increment step;
    if (!system.linearise(s) || !system.newton_step(line.target(mu), parameter, 0, step)) return {};
    const double change =
      std::max(step.d.cwiseAbs().maxCoeff(), step.beta.cwiseAbs().maxCoeff());
    if (!(change < 0.3)) return {};
    system.apply(step, 1, s);
    mu += step.parameter;
    if (change < NewtonOptions{}.tolerance) return with_tangent(line, mu, s, &from.tangent);
  }
  return {};
}

// The fold between `before` (parameter still advancing) and ds further: zero of the tangent's
// parameter component, by the Illinois variant of regula falsi.
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

std::optional<NewtonResult> solve_near(const Line& line, double mu, const StationaryState& guess,
                                       int determinant_sign) {
  const NewtonResult r = solve_stationary(line.material(mu), line.model(), line.target(mu), guess,
                                          {.iterations = direct_iterations});
  if (r.status != NewtonStatus::converged) return {};
  if (determinant_sign != 0 && r.determinant_sign != determinant_sign) return {};
  return r;
}

BranchState arrived(const Line& line, double mu, const StationaryState& s, int determinant_sign,
                    const Numerics& numerics) {
  BranchState state{.at = line.at(mu), .solution = s, .determinant_sign = determinant_sign};
  const StationaryState placed = redistribute(s, numerics.grading);
  if (const auto r = solve_near(line, mu, placed, 0)) {
    state.solution = r->solution;
    state.iterations = r->iterations;
  }
  return state;
}

}  // namespace

FollowResult follow(const model::Material& material, model::Model model, const BranchState& from,
                    PlanePoint to, const Numerics& numerics) {
  const Line line(material, model, from.at, to);
  auto here = with_tangent(line, 0, from.solution, nullptr);
  if (!here) return {Arrival::lost, from};
  const int sign = here->determinant_sign;

  const double whole = 1 / here->tangent.parameter;  // arc length to μ = 1 along the tangent
  if (whole * std::max(here->tangent.d.cwiseAbs().maxCoeff(),
                       here->tangent.beta.cwiseAbs().maxCoeff()) < 0.3) {
    NewtonSystem system(line.material(0), model, int(from.solution.state.beta.size()));
    StationaryState guess = from.solution;
    if (system.linearise(guess)) system.apply(here->tangent, whole, guess);
    if (const auto r = solve_near(line, 1, guess, sign))
      return {Arrival::reached, arrived(line, 1, r->solution, sign, numerics)};
  }

  double ds = std::min(whole / 2, 0.1);
  for (int step = 0; step < 200 && ds > 1e-7; ++step) {
    const auto next = arc_step(line, *here, ds);
    if (!next) {
      ds /= 2;
      continue;
    }
    if (next->tangent.parameter <= 0) {
      const PathState fold = locate_fold(line, *here, *next, ds);
      return {Arrival::fold, {.at = line.at(fold.mu),             .solution = fold.s,
                              .determinant_sign = sign, .iterations = step}};
    }
    if (next->mu >= 1) {
      const double share = (1 - here->mu) / (next->mu - here->mu);
      const auto close = arc_step(line, *here, ds * share);
      // A different sign here is a branch crossing this one, not another branch.
      const auto r = solve_near(line, 1, close ? close->s : next->s, 0);
      if (r)
        return {Arrival::reached, arrived(line, 1, r->solution, r->determinant_sign, numerics)};
      ds /= 2;
      continue;
    }
    // Move on, with the nodes where the curvature now is.
    const StationaryState placed = redistribute(next->s, numerics.grading);
    const auto settled = solve_near(line, next->mu, placed, 0);
    const auto kept = with_tangent(line, next->mu, settled ? settled->solution : next->s,
                                   settled ? nullptr : &here->tangent);
    if (!kept) return {Arrival::lost, {.at = line.at(here->mu), .solution = here->s}};
    here = kept;
    ds *= 1.5;
  }
  return {Arrival::lost, {.at = line.at(here->mu), .solution = here->s, .determinant_sign = sign}};
}

}  // namespace sbeh::axisym
