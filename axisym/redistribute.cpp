#include "axisym/redistribute.h"

#include "axisym/curvature.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sbeh::axisym {

namespace {

constexpr int samples = 16;  // of the measure, per element

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

// The new nodes' places on the old curve.
std::vector<Place> places(const Nodes& X, const Field& H, double grading, int elements) {
  const int intervals = samples * element_count(X);
  Eigen::VectorXd length(intervals), bend(intervals);
  for (int k = 0; k < intervals; ++k) {
    const ShapeValues s = shape_values((k % samples + 0.5) / samples);
    const CurvePoint p = curve_point(X, k / samples, s);
    length[k] = p.stretch / samples;
    bend[k] = length[k] * std::abs(value_at(H, k / samples, s) - p.B_phi);
  }
  const Cumulative arc(length), measure(length / length.sum() + grading * bend / bend.sum());
  const auto place = [&](double interval) {
    const int e = std::min(int(interval) / samples, element_count(X) - 1);
    return Place{e, interval / samples - e};
  };
  const auto joint = [&](int e) { return measure.inverse(measure.total() * e / elements); };
  std::vector<Place> result;
  for (int e = 0; e < elements; ++e) {
    const double begin = arc.at(joint(e)), end = arc.at(joint(e + 1));
    for (int a = 0; a < 3; ++a) result.push_back(place(arc.inverse(begin + (end - begin) * a / 3)));
  }
  result.push_back({element_count(X) - 1, 1});
  return result;
}

Field interpolate(const Field& f, const std::vector<Place>& at) {
  Field g(Eigen::Index(at.size()));
  for (std::size_t i = 0; i < at.size(); ++i)
    g[Eigen::Index(i)] = value_at(f, at[i].element, shape_values(at[i].x));
  return g;
}

State interpolate(const State& state, const std::vector<Place>& at) {
  State moved{.X = Nodes(2, Eigen::Index(at.size())), .beta = interpolate(state.beta, at)};
  for (int k = 0; k < 2; ++k)
    moved.X.row(k) = interpolate(state.X.row(k).transpose(), at).transpose();
  moved.X(0, 0) = moved.X(0, moved.X.cols() - 1) = 0;
  return moved;
}

}  // namespace

State redistribute(const State& state, double grading, int elements) {
  return interpolate(state, places(state.X, mean_curvature(state.X), grading,
                                   elements > 0 ? elements : element_count(state.X)));
}

StationaryState redistribute(const StationaryState& s, double grading, int elements) {
  const auto at =
      places(s.state.X, s.H, grading, elements > 0 ? elements : element_count(s.state.X));
  return {.state = interpolate(s.state, at),
          .H = interpolate(s.H, at),
          .Lambda = interpolate(s.Lambda, at),
          .tension = s.tension,
          .pressure = s.pressure};
}

}  // namespace sbeh::axisym
