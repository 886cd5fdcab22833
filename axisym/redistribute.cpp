#include "axisym/redistribute.h"

#include "axisym/curvature.h"
#include "axisym/domains.h"
#include "axisym/shape_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sbeh::axisym {

namespace {

constexpr int samples = 16;  // of the measure, per element

// Gauss–Lobatto points of [0, 1]: (1 ∓ 1/√5)/2 inside.
constexpr std::array<double, 4> lobatto{0, 0.27639320225002103, 0.72360679774997897, 1};

// A place on the old curve.
struct Place {
  int element;
  double x;
};

// Monotone piecewise linear function on the intervals of the old curve, and its inverse.
class Cumulative {
 public:
  explicit Cumulative(const Eigen::VectorXd& shares) : sum_(std::size_t(shares.size()) + 1, 0.) {
    for (Eigen::Index k = 0; k < shares.size(); ++k)
      sum_[std::size_t(k) + 1] = sum_[std::size_t(k)] + shares[k];
  }
  double total() const { return sum_.back(); }
  double at(double interval) const {
    const auto k = std::min(std::size_t(interval), sum_.size() - 2);
    return sum_[k] + (interval - double(k)) * (sum_[k + 1] - sum_[k]);
  }
  double inverse(double value) const {
    const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, value);
    const auto k = std::size_t(above - sum_.begin()) - 1;
    return double(k) + std::clamp((value - sum_[k]) / (sum_[k + 1] - sum_[k]), 0., 1.);
  }

 private:
  std::vector<double> sum_;
};

// Where the curve needs nodes: at a place, on the scale of a radius.
struct Centre {
  double node, radius, weight;
};

// Necks, by their depths; and interfaces between phases, whose orders differ by more than those of one phase do.
std::vector<Centre> centres(const State& state) {
  constexpr double one_phase = 0.3, two_phases = 0.4;  // of the orders that there are
  std::vector<Centre> found;
  for (const Neck& neck : necks(state.X))
    found.push_back({double(neck.node), neck.radius, neck.depth});
  const double contrast = state.beta.maxCoeff() - state.beta.minCoeff(),
               weight = std::clamp((contrast - one_phase) / (two_phases - one_phase), 0., 1.);
  if (weight > 0)
    for (const Interface& at : interfaces(state)) found.push_back({at.node, at.width, weight});
  return found;
}

// Σ weight length/√(distance² + radius²) over them: as many for each factor e of the distance, over which what a neck does to the
// curve decays.
Eigen::VectorXd near_centres(const State& state, const Eigen::VectorXd& length) {
  const Cumulative arc(length);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(length.size());
  for (const Centre& centre : centres(state)) {
    const double s = arc.at(samples / 3. * centre.node);
    for (Eigen::Index k = 0; k < length.size(); ++k)
      shares[k] +=
          centre.weight * length[k] / std::hypot(arc.at(double(k) + 0.5) - s, centre.radius);
  }
  return shares;
}

// The Gauss–Lobatto points of the new elements on the old curve, joints shared. 0 elements: as many as before.
std::vector<Place> places(const State& state, const Field& H, double grading, int elements) {
  constexpr double narrow = 0.2;
  const Nodes& X = state.X;
  if (elements == 0) elements = element_count(X);
  const int intervals = samples * element_count(X);
  Eigen::VectorXd length(intervals), bend(intervals);
  static const auto middles = [] {
    std::array<ShapeValues, samples> of;
    for (int k = 0; k < samples; ++k) of[std::size_t(k)] = shape_values((k + 0.5) / samples);
    return of;
  }();
  for (int k = 0; k < intervals; ++k) {
    const ShapeValues& s = middles[std::size_t(k % samples)];
    const CurvePoint p = curve_point(X, k / samples, s);
    length[k] = p.stretch / samples;
    bend[k] = length[k] * std::abs(value_at(H, k / samples, s) - p.B_phi);
  }
  const Cumulative arc(length), measure(length / length.sum() + grading * bend / bend.sum()
                                        + narrow * near_centres(state, length));
  const auto place = [&](double interval) {
    const int e = std::min(int(interval) / samples, element_count(X) - 1);
    return Place{e, interval / samples - e};
  };
  const auto joint = [&](int e) { return measure.inverse(measure.total() * e / elements); };
  std::vector<Place> result;
  for (int e = 0; e < elements; ++e) {
    const double begin = arc.at(joint(e)), end = arc.at(joint(e + 1));
    for (int a = 0; a < 3; ++a)
      result.push_back(place(arc.inverse(begin + (end - begin) * lobatto[a])));
  }
  result.push_back({element_count(X) - 1, 1});
  return result;
}

Field sample(const Field& f, const std::vector<Place>& at) {
  Field g(Eigen::Index(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i)
    g[Eigen::Index(i)] = value_at(f, at[i].element, shape_values(at[i].x));
  return g;
}

// What is uniform stays so to the last bit.
Field interpolate(const Field& f, const std::vector<Place>& at) {
  const double first = f[0];
  return nodal_values(sample(f.array() - first, at)).array() + first;
}

State interpolate(const State& state, const std::vector<Place>& at) {
  State moved{.X = Nodes(2, Eigen::Index(at.size())), .beta = interpolate(state.beta, at)};
  for (int k = 0; k < 2; ++k)
    moved.X.row(k) = interpolate(state.X.row(k).transpose(), at).transpose();
  moved.X(0, 0) = moved.X(0, moved.X.cols() - 1) = 0;
  return moved;
}

}  // namespace

Field nodal_values(const Field& at_lobatto) {
  // Rows: the cubic through the four points, evaluated at 1/3 and 2/3.
  static const Eigen::Matrix<double, 2, 4> to_inner = [] {
    Eigen::Matrix4d at_points;
    for (int i = 0; i < 4; ++i)
      at_points.row(i) =
          Eigen::Map<const Eigen::RowVector4d>(shape_values(lobatto[std::size_t(i)]).phi.data());
    return Eigen::Matrix<double, 2, 4>(at_points.inverse().middleRows<2>(1));
  }();
  Field nodes = at_lobatto;
  for (Eigen::Index e = 0; e < nodes.size() / 3; ++e)
    nodes.segment<2>(3 * e + 1) = to_inner * at_lobatto.segment<4>(3 * e);
  return nodes;
}

Field sample_at_lobatto(const State& state, const Field& f, double grading, int elements) {
  return sample(f, places(state, mean_curvature(state.X), grading, elements));
}

State redistribute(const State& state, double grading, int elements) {
  return interpolate(state, places(state, mean_curvature(state.X), grading, elements));
}

StationaryState redistribute(const StationaryState& state, double grading, int elements) {
  const auto at = places(state, state.H, grading, elements);
  return {interpolate(static_cast<const State&>(state), at),
          interpolate(state.H, at),
          interpolate(state.Lambda, at),
          state.tension,
          state.pressure,
          state.moment,
          state.chemical_potential};
}

StationaryState fitted(const StationaryState& state, const Numerics& numerics) {
  constexpr double coarse = 0.06, needlessly_fine = 0.025;
  const int elements = element_count(state.X);
  StationaryState placed = redistribute(state, numerics.grading);
  const double reached = resolution(placed.X, placed.H);
  if (reached > coarse && 2 * elements <= most_elements)
    return redistribute(state, numerics.grading, 2 * elements);
  if (reached < needlessly_fine && elements >= 2 * numerics.elements)
    return redistribute(state, numerics.grading, elements / 2);
  return placed;
}

}  // namespace sbeh::axisym
