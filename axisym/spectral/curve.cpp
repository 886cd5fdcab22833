#include "axisym/spectral/curve.h"

#include "model/numerics/root.h"
#include "model/numerics/spheroid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace sbeh::axisym::spectral {

using Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

namespace {

// Points per wave number of the cutoff on the whole curve.
constexpr double oversampling = 2;

// cos and sin of jπ/(2N), from tables: all angles of the midpoint grid are such.
class TrigTable {
 public:
  explicit TrigTable(int N) : period_(4 * N), cos_(std::size_t(period_)), sin_(cos_) {
    for (int j = 0; j < period_; ++j) {
      cos_[std::size_t(j)] = std::cos(2 * pi * j / period_);
      sin_[std::size_t(j)] = std::sin(2 * pi * j / period_);
    }
  }
  // j ∈ [0, 4N)
  double cos(int j) const { return cos_[std::size_t(j)]; }
  double sin(int j) const { return sin_[std::size_t(j)]; }
  // j + step, step ∈ [0, 4N), in that range
  int next(int j, int step) const { return j + step < period_ ? j + step : j + step - period_; }

 private:
  int period_;
  std::vector<double> cos_, sin_;
};

// Angle by arc length: pairs (s, ψ), s rising.
struct AngleSamples {
  std::vector<double> s, psi;
  void add(double at, double angle) { s.push_back(at), psi.push_back(angle); }
};

// Coefficients of ψ(σ).
VectorXd project(const Basis& basis, auto&& psi) {
  VectorXd excess(basis.points());
  for (int j = 0; j < basis.points(); ++j)
    excess[j] = psi(basis.grading.sigma(basis.x[j])) - pi * basis.x[j];
  return 2. / basis.points() * (basis.S.transpose() * excess);
}

// The curve whose angle is piecewise linear between the samples.
Curve curve_of(const AngleSamples& samples, std::shared_ptr<const Basis> basis) {
  const double length = samples.s.back();
  const auto psi = [&](double sigma) {
    const double s = length * sigma;
    const auto after = std::upper_bound(samples.s.begin() + 1, samples.s.end() - 1, s);
    const std::size_t i = std::size_t(after - samples.s.begin());
    const double t = (s - samples.s[i - 1]) / (samples.s[i] - samples.s[i - 1]);
    return (1 - t) * samples.psi[i - 1] + t * samples.psi[i];
  };
  return {.basis = basis, .length = length, .b = project(*basis, psi)};
}

}  // namespace

double Grading::sigma(double x) const {
  const double c = std::cos(pi * x0), scale = 1 + a * a / 2 * std::cos(2 * pi * x0);
  return x + (a * a / 4 * std::sin(2 * pi * x) - 2 * a * c * std::sin(pi * x)) / (pi * scale);
}
double Grading::slope(double x) const {
  const double scale = 1 + a * a / 2 * std::cos(2 * pi * x0);
  return (1 - a * std::cos(pi * (x - x0))) * (1 - a * std::cos(pi * (x + x0))) / scale;
}
double Grading::inverse(double at) const {
  if (a == 0 || at <= 0 || at >= 1) return at;
  return model::root_between([&](double x) { return sigma(x) - at; }, 0, 1).middle();
}

std::shared_ptr<const Basis> basis(Symmetry symmetry, int cutoff, const Grading& grading) {
  if (cutoff < 2)
    throw std::invalid_argument("cutoff " + std::to_string(cutoff) + ": must be >= 2");
  if (symmetry == Symmetry::top_bottom && grading.a != 0 && grading.x0 != 0.5)
    throw std::invalid_argument("grading at x0 = " + std::to_string(grading.x0)
                                + ": must be 0.5 for symmetric curves");
  auto B = std::make_shared<Basis>();
  const bool half = symmetry == Symmetry::top_bottom;
  const int step = half ? 2 : 1;
  B->symmetry = symmetry;
  B->grading = grading;
  for (int k = step; k <= cutoff; k += step) B->k.push_back(k);
  B->cutoff = B->k.back();
  const int N = step * int(std::ceil(oversampling * cutoff / step));  // on the whole curve
  const int n = int(B->k.size()), points = N / step;
  B->x.resize(points);
  B->S.resize(points, n), B->dS.resize(points, n);
  B->C.resize(points, n + 1), B->dC.resize(points, n + 1);
  VectorXd slope(points);
  for (int j = 0; j < points; ++j) {
    B->x[j] = (j + 0.5) / N;
    slope[j] = grading.slope(B->x[j]);
  }
  const TrigTable trig(N);
  B->C.col(0).setOnes(), B->dC.col(0).setZero();
  for (int i = 0; i < n; ++i) {
    const int k = B->k[std::size_t(i)];
    for (int j = 0, at = k; j < points; ++j, at = trig.next(at, 2 * k)) {
      B->S(j, i) = trig.sin(at), B->C(j, i + 1) = trig.cos(at);
      B->dS(j, i) = k * pi * trig.cos(at) / slope[j];
      B->dC(j, i + 1) = -k * pi * trig.sin(at) / slope[j];
    }
  }
  // Of a symmetric curve cos ψ has odd wave numbers alone.
  const int highest = (N - 2) / step * step + 1;
  MatrixXd sines(points, (highest - 1) / step + 1), cosines = sines;
  B->odd.setZero(points);
  for (int m = 1; m <= highest; m += step) {
    const int i = (m - 1) / step;
    for (int j = 0, at = m; j < points; ++j, at = trig.next(at, 2 * m)) {
      sines(j, i) = trig.sin(at) / (m * pi);
      cosines(j, i) = trig.cos(at) * 2 / points;
    }
    // f = Σ d_m sin(mπx) has ∫f = Σ 2 d_m/(mπ) over odd m.
    if (m % 2 == 1) B->odd += sines.col(i) * 4 / points;
  }
  B->M = sines * cosines.transpose() * slope.asDiagonal();
  B->odd.array() *= slope.array();
  B->even = slope / points;
  B->dx = slope.cwiseInverse();
  return B;
}

double angle(const Curve& curve, double sigma) {
  const double x = curve.basis->grading.inverse(sigma);
  double psi = pi * x;
  for (std::size_t i = 0; i < curve.basis->k.size(); ++i)
    psi += curve.b[Eigen::Index(i)] * std::sin(curve.basis->k[i] * pi * x);
  return psi;
}

Curve on_basis(const Curve& curve, std::shared_ptr<const Basis> basis) {
  Curve result{.basis = basis, .length = curve.length, .b = VectorXd::Zero(basis->modes())};
  if (curve.basis->grading != basis->grading) {
    result.b = project(*basis, [&](double sigma) { return angle(curve, sigma); });
    return result;
  }
  const std::vector<int>&from = curve.basis->k, &to = basis->k;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto at = std::lower_bound(from.begin(), from.end(), to[i]);
    if (at != from.end() && *at == to[i]) result.b[Eigen::Index(i)] = curve.b[at - from.begin()];
  }
  return result;
}

Angles angles(const Curve& curve) {
  const Basis& B = *curve.basis;
  Angles at;
  at.psi = pi * B.x + B.S * curve.b;
  at.dpsi = B.dS * curve.b + pi * B.dx;
  at.r = B.M * at.psi.array().cos().matrix();
  return at;
}

MatrixXd radius_jacobian(const Basis& basis, const Angles& at) {
  return basis.M * ((-at.psi.array().sin()).matrix().asDiagonal() * basis.S);
}

Eigen::Matrix2Xd profile(const Curve& curve, int intervals) {
  const std::vector<int>& k = curve.basis->k;
  const int N = std::max(intervals, 2 * curve.basis->cutoff);
  const TrigTable trig(N);
  VectorXd psi(N), cosine(N), sine(N);
  for (int j = 0; j < N; ++j) psi[j] = pi * (j + 0.5) / N;
  for (std::size_t i = 0; i < k.size(); ++i)
    for (int j = 0, at = k[i]; j < N; ++j, at = trig.next(at, 2 * k[i]))
      psi[j] += curve.b[Eigen::Index(i)] * trig.sin(at);
  for (int j = 0; j < N; ++j) {
    const double slope = curve.basis->grading.slope((j + 0.5) / N);
    cosine[j] = slope * std::cos(psi[j]), sine[j] = slope * std::sin(psi[j]);
  }
  // σ' cos ψ = Σ a_m cos(mπx) gives r = Σ a_m sin(mπx)/(mπ), σ' sin ψ = Σ d_m sin(mπx) gives
  // z = Σ d_m cos(mπx)/(mπ).
  Eigen::Matrix2Xd whole = Eigen::Matrix2Xd::Zero(2, N + 1);
  for (int m = 1; m < N; ++m) {
    double a = 0, d = 0;
    for (int j = 0, at = m; j < N; ++j, at = trig.next(at, 2 * m)) {
      a += cosine[j] * trig.cos(at);
      d += sine[j] * trig.sin(at);
    }
    const double scale = 2 * curve.length / (N * m * pi);
    for (int j = 0, at = 0; j <= N; ++j, at = trig.next(at, 2 * m)) {
      whole(0, j) += scale * a * trig.sin(at);
      whole(1, j) += scale * d * trig.cos(at);
    }
  }
  whole(0, 0) = whole(0, N) = 0;
  whole.row(1).array() -= 0.5 * (whole(1, 0) + whole(1, N));
  return whole;
}

double pole_distance(const Curve& curve) {
  return curve.length * curve.basis->odd.dot(angles(curve).psi.array().sin().matrix());
}

Curve curve_through(const Eigen::Matrix2Xd& profile, std::shared_ptr<const Basis> basis) {
  if (profile.cols() < 4)
    throw std::invalid_argument("profile of " + std::to_string(profile.cols())
                                + " points: must have at least 4");
  AngleSamples samples;
  samples.add(0, 0);
  double s = 0, before = 0;
  for (Eigen::Index i = 1; i < profile.cols(); ++i) {
    const Eigen::Vector2d chord = profile.col(i) - profile.col(i - 1);
    const double length = chord.norm(), angle = std::atan2(-chord[1], chord[0]);
    if (length == 0) continue;
    before = angle + 2 * pi * std::round((before - angle) / (2 * pi));
    samples.add(s + length / 2, before);
    s += length;
  }
  if (before < 0)  // from the lower pole upwards: seen in a mirror
    for (double& psi : samples.psi) psi = -psi;
  samples.add(s, pi);
  return curve_of(samples, std::move(basis));
}

Curve spheroid(double reduced_volume, bool prolate, std::shared_ptr<const Basis> basis) {
  assert(reduced_volume > 0 && reduced_volume < 1);
  const double c = model::spheroid_axis_ratio(reduced_volume, prolate);
  constexpr int samples = 400;
  Eigen::Matrix2Xd polygon(2, samples + 1);
  for (int j = 0; j <= samples; ++j) {
    const double t = pi * j / samples;
    polygon.col(j) << std::sin(t), c * std::cos(t);
  }
  Curve curve = curve_through(polygon, std::move(basis));
  curve.length *= std::cbrt(reduced_volume / c);  // volume 4πc/3 of the polygon
  return curve;
}

Curve invaginated_sphere(double reduced_volume, std::shared_ptr<const Basis> basis) {
  assert(reduced_volume > 0 && reduced_volume < 1);
  // Radii cos t, sin t of two spheres joined by a neck: area 4π, V_r = cos³t − sin³t.
  const auto miss = [=](double a) {
    return std::pow(std::cos(a), 3) - std::pow(std::sin(a), 3) - reduced_volume;
  };
  const double t = model::root_between(miss, 0, pi / 4).middle();
  const double outer = std::cos(t), inner = std::sin(t), rim = 0.3 * (outer - inner);
  const double inner_end = 0.65 * pi, outer_start = 0.2 * pi;  // angles where the rim begins, ends
  AngleSamples samples;
  samples.add(0, 0);
  samples.add(inner * inner_end, -inner_end);
  samples.add(samples.s.back() + rim * (inner_end + outer_start), outer_start);
  samples.add(samples.s.back() + outer * (pi - outer_start), pi);
  return curve_of(samples, std::move(basis));
}

}  // namespace sbeh::axisym::spectral
