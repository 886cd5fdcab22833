#include "axisym/stationary/arclength.h"

#include "axisym/redistribute.h"
#include "axisym/stationary/symmetry.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym {

Field weights_of(const StationaryState& state) {
  const Nodes n = node_normals(state.X);
  const Eigen::Index last = state.H.size() - 1;
  Field weights(last + 1);
  for (Eigen::Index i = 0; i <= last; ++i) {
    const double B_phi = i > 0 && i < last ? n(0, i) / state.X(0, i) : state.H[i] / 2;
    weights[i] = std::max(1., B_phi * B_phi);
  }
  return weights;
}

double length_of(const Increment& t, const Field& weights) {
  const double square = t.d.cwiseAbs2().dot(weights) + t.beta.squaredNorm();
  return std::sqrt(square / double(t.d.size()) + t.mu * t.mu);
}

Increment scaled(Increment t, double factor) {
  for (Field* f : {&t.d, &t.Lambda, &t.H, &t.beta}) *f *= factor;
  t.tension *= factor;
  t.pressure *= factor;
  t.moment *= factor;
  t.chemical_potential *= factor;
  t.mu *= factor;
  return t;
}

PlanePoint Line::at(double mu) const {
  if (mu == 1) return to;  // exactly
  return {from.reduced_volume + mu * (to.reduced_volume - from.reduced_volume),
          from.L + mu * (to.L - from.L)};
}

model::Material Line::material_at(double mu) const {
  model::Material m = material.with_L1(at(mu).L);
  if (mu == 1) return m;
  m.spontaneous_curvature = first_H0 + mu * (m.spontaneous_curvature - first_H0);
  m.area_difference.W2 = first_W2 + mu * (m.area_difference.W2 - first_W2);
  if (first_coupling != 1) m.flexoelectric = m.flexoelectric.times(coupling(mu));
  return first_scale == 1 ? m : m.with_given_scaled(scale(mu));
}

namespace {
constexpr double h = 1e-3;  // of μ: the energy is linear in L and f and quadratic in H₀, a cubic
}

double Line::W2_rate(const LineState& state) const {
  const auto value = [&](double mu) {
    const model::AreaDifference ad = material_at(mu).area_difference;
    const double moment = state.moment == 0 ? 0 : state.moment * ad.compliance();
    return ad.is_there() ? ad.W2 + moment * area(state.X) : 0;
  };
  return (value(state.mu + h) - value(state.mu - h)) / (2 * h);
}

Eigen::VectorXd Line::gradient_rate(const LineState& state) const {
  const model::Material before = felt_material(material_at(state.mu - h), model),
                        after = felt_material(material_at(state.mu + h), model);
  if (before == after) return Eigen::VectorXd::Zero(node_unknowns * state.beta.size());
  return gradient_difference(after, before, state, node_normals(state.X)) / (2 * h);
}

namespace {

// The equation of the hyperplane across `direction`, in the length of length_of.
PathEquation across(const Line& line, const LineState& state, const Eigen::VectorXd& gradient_rate,
                    const Increment& direction, const Field& weights) {
  Increment row = scaled(direction, 1. / double(direction.d.size()));
  row.d = row.d.cwiseProduct(weights);
  row.mu = direction.mu;
  return {gradient_rate, line.volume_rate(), line.W2_rate(state), row};
}

NewtonSystem system_at(const Line& line, const LineState& state) {
  return {line.material_at(state.mu), line.model, {element_count(state.X), line.symmetric}};
}

// Rounding grows where a branch crosses that breaks the symmetry: what is odd is taken out. Empty where it has
// grown to another state.
std::optional<PathState> on_path(const Line& line, LineState state, Increment t, int sign) {
  if (line.symmetric) static_cast<StationaryState&>(state) = symmetric_part(state);
  Field weights = weights_of(state);
  t = scaled(t, 1 / length_of(t, weights));
  return PathState{state, std::move(t), std::move(weights), sign};
}

double cosine(const PathState& p, const PathState& q) {
  const Increment &a = p.tangent, &b = q.tangent;
  const double square = a.d.cwiseProduct(b.d).dot(p.weights) + a.beta.dot(b.beta);
  return square / double(a.d.size()) + a.mu * b.mu;
}

// The largest change from one state to the other, and how far the mean of their tangents is from it.
struct Chord {
  double change, miss;
};
Chord chord(const PathState& from, const PathState& next, double ds) {
  const Nodes mean_motion = (node_normals(from.X) * from.tangent.d.asDiagonal()
                             + node_normals(next.X) * next.tangent.d.asDiagonal())
                          / 2;
  const Field mean_order = (from.tangent.beta + next.tangent.beta) / 2;
  const Nodes moved = next.X - from.X;
  const Field ordered = next.beta - from.beta;
  const auto largest = [](const auto& nodal) { return nodal.cwiseAbs().maxCoeff(); };
  return {std::max(largest(moved), largest(ordered)),
          std::max(largest(moved - ds * mean_motion), largest(ordered - ds * mean_order))};
}

}  // namespace

namespace {

// The determinant changes its sign where the parameter turns back. Where only one of both happens, there is another branch near, or one
// crosses: then nothing is wrong at short steps either. Branches that break a symmetry which is not asked for cross without harm.
bool has_only_folds(const Line& line, const PathState& from, const PathState& next, double ds) {
  constexpr double crossing = 1e-3, fold = 1e-4;  // of ds; of slopes whose sign is not sure
  if (std::abs(ds) < crossing || std::min(std::abs(from.slope()), std::abs(next.slope())) < fold)
    return true;
  const bool turns = from.slope() * next.slope() < 0,
             flips = from.determinant_sign * next.determinant_sign < 0;
  return turns == flips || (!line.symmetric && is_symmetric(from.X));
}

}  // namespace

bool continues(const Line& line, const PathState& from, const PathState& next, double ds) {
  if (!has_only_folds(line, from, next, ds)) return false;
  // A neck or a rim that jumps is a small part of the cosine, but not of the chord.
  constexpr double share = 1. / 3, always = 1e-3;
  const Chord c = chord(from, next, ds);
  return cosine(from, next) > model::least_cosine && c.miss < std::max(always, share * c.change);
}

std::optional<PathState> with_tangent(const Line& line, const LineState& state,
                                      const Increment* forward) {
  NewtonSystem system = system_at(line, state);
  if (!system.linearise(state)) return {};
  Increment t, ahead;
  const Eigen::VectorXd gradient_rate = line.gradient_rate(state);
  // Along μ for the sign of the determinant, and for the direction where there is no other.
  const bool regular =
      system.tangent(gradient_rate, line.volume_rate(), line.W2_rate(state), ahead);
  const int sign = regular ? system.determinant_sign() : 0;
  if (forward) {
    if (!system.tangent(across(line, state, gradient_rate, *forward, weights_of(state)), t))
      return {};
  } else if (regular) {
    t = ahead;
  } else {
    return {};
  }
  return on_path(line, state, t, sign);
}

std::optional<LineState> predicted(const Line& line, const PathState& from, double ds) {
  LineState guess = from;
  guess.mu += ds * from.tangent.mu;
  if (!line.contains(guess.mu)) return {};
  displace(from.tangent, ds, guess);
  return guess;
}

std::optional<double> newton_step(const Line& line, LineState& state, const PathState& from,
                                  double ds) {
  NewtonSystem system = system_at(line, state);
  const PathEquation path =
      across(line, state, line.gradient_rate(state), from.tangent, from.weights);
  Increment step;
  if (!system.linearise(state) || !system.newton_step(line.target(state.mu), path, 0, step))
    return {};
  if (ds != 0 && largest_change(step) > largest_correction(ds * largest_change(from.tangent)))
    return {};
  displace(step, 1, state);
  state.mu += step.mu;
  return largest_change(step);
}

double largest_correction(double predicted_change) {
  constexpr double share = 0.5, always = 1e-3;
  return std::max(always, share * std::abs(predicted_change));
}

PathState with_fresh_nodes(const Line& line, const PathState& state, const Numerics& numerics) {
  return on_nodes(line, state, fitted(state, numerics)).value_or(state);
}

std::optional<PathState> on_nodes(const Line& line, const PathState& state, StationaryState guess) {
  auto there = on_nodes(line, {std::move(guess), state.mu});
  if (there && there->slope() * state.slope() < 0) there->tangent = scaled(there->tangent, -1);
  return there;
}

std::optional<PathState> on_nodes(const Line& line, LineState guess) {
  if (line.symmetric) static_cast<StationaryState&>(guess) = symmetric_part(guess);
  // Across the guess's own tangent, along which a thin neck would give way to the error of the guess.
  const auto start = with_tangent(line, guess);
  if (!start || !model::converges(guess, Line::limits, [&](auto& s) {
        return newton_step(line, s, *start, 0);
      }))
    return {};
  return with_tangent(line, guess, &start->tangent);
}

}  // namespace sbeh::axisym
