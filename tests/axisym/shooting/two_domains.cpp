#include "tests/axisym/shooting/two_domains.h"

#include "axisym/shooting/seifert_shooting.h"
#include "model/numerics/continuation.h"

#include <Eigen/LU>
#include <ceres/jet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

namespace sbeh::axisym::shooting {
namespace {

using std::numbers::pi;

constexpr double multiplier_unit = 10, first_volume = 0.95;

// What is solved for: H at the poles, lengths, Σ_i/κ_i and P, these in multiplier_unit; and μ, where on the line.
struct Of {
  enum : int { H_a, length_a, tension_a, H_b, length_b, tension_b, pressure, mu, count };
};
using Vector = Eigen::Vector<double, Of::count>;
using Matrix = Eigen::Matrix<double, Of::count, Of::count>;
using Jet = ceres::Jet<double, Of::count>;  // derivatives by all of them

// A straight line in all parameters, μ = 0 at `from`, 1 at `to`.
struct DomainLine {
  struct Solution {
    Vector y;
  };
  struct Point : Solution {
    Vector tangent;  // of the branch, unit
    double parameter() const { return y[Of::mu]; }
    double slope() const { return tangent[Of::mu]; }
  };
  static constexpr model::ContinuationLimits limits{
      .most_iterations = 9, .tolerance = 1e-7, .far = 1, .fold = 1e-9};

  TwoDomains from, to;

  template <class T>
  T at(double TwoDomains::*parameter, const T& mu) const {
    return from.*parameter + mu * (to.*parameter - from.*parameter);
  }
};
using Shape = DomainLine::Solution;
using OnBranch = DomainLine::Point;

// ---- The closure ------------------------------------------------------------------------------------

// A piece from its pole to the interface.
using Piece = std::array<Jet, Row::count>;
std::optional<Piece> shoot(const Jet& H, const Jet& tension, const Jet& pressure,
                           const Jet& length) {
  constexpr double longest = 50;
  if (!(length.a > Options{}.series_start && length.a < longest)) return {};
  const auto end = integrate({H.a, tension.a, pressure.a}, length.a);
  if (!end) return {};
  Piece piece;
  for (int i = 0; i < Row::count; ++i) {
    const auto by = end->rates.row(i);
    piece[std::size_t(i)] = {
        end->state[i], by[0] * H.v + by[1] * tension.v + by[2] * pressure.v + by[3] * length.v};
  }
  return piece;
}

struct Ends {
  Piece a, b;
};
std::optional<Ends> ends(const DomainLine& line, const Vector& y) {
  const auto unknown = [&](int i, double unit = 1) { return unit * Jet(y[i], i); };
  const Jet mu = unknown(Of::mu), P = unknown(Of::pressure, multiplier_unit);
  const auto a = shoot(unknown(Of::H_a), unknown(Of::tension_a, multiplier_unit),
                       P / line.at(&TwoDomains::kappa_a, mu), unknown(Of::length_a));
  const auto b = shoot(unknown(Of::H_b), unknown(Of::tension_b, multiplier_unit),
                       P / line.at(&TwoDomains::kappa_b, mu), unknown(Of::length_b));
  if (!a || !b) return {};
  return Ends{*a, *b};
}

std::optional<std::array<Jet, Of::mu>> closure(const DomainLine& line, const Vector& y) {
  const auto both = ends(line, y);
  if (!both) return {};
  const auto& [a, b] = *both;
  const Jet mu(y[Of::mu], Of::mu);
  const Jet kappa_a = line.at(&TwoDomains::kappa_a, mu),
            kappa_b = line.at(&TwoDomains::kappa_b, mu), x = line.at(&TwoDomains::fraction, mu);
  return std::array<Jet, Of::mu>{
      a[Row::psi] + b[Row::psi] - pi,
      a[Row::X] - b[Row::X],
      a[Row::X] * (kappa_a * a[Row::H] - kappa_b * b[Row::H])
          - line.at(&TwoDomains::gauss_jump, mu) * sin(a[Row::psi]),
      kappa_a * a[Row::gamma] + kappa_b * b[Row::gamma] + line.at(&TwoDomains::line_tension, mu),
      a[Row::area] - 4 * pi * x,
      b[Row::area] - 4 * pi * (1. - x),
      a[Row::volume] + b[Row::volume] - 4 * pi / 3 * line.at(&TwoDomains::reduced_volume, mu)};
}

// ---- Continuation: what model::ContinuationSystem asks for --------------------------------------------

struct Linearised {
  Vector residual;
  Matrix matrix;
};
// The closure, and as a last equation that nothing changes along `row`.
std::optional<Linearised> linearise(const DomainLine& line, const Vector& y, const Vector& row) {
  const auto equations = closure(line, y);
  if (!equations) return {};
  Linearised out;
  for (int i = 0; i < Of::mu; ++i) {
    out.residual[i] = (*equations)[std::size_t(i)].a;
    out.matrix.row(i) = (*equations)[std::size_t(i)].v;
  }
  out.residual[Of::mu] = 0;
  out.matrix.row(Of::mu) = row;
  return out;
}

std::optional<double> newton_step_across(const DomainLine& line, Shape& x, const Vector& row) {
  const auto here = linearise(line, x.y, row);
  if (!here) return {};
  const Vector step = here->matrix.partialPivLu().solve(here->residual);
  x.y -= step;
  return step.cwiseAbs().maxCoeff();
}

std::optional<Shape> predicted(const DomainLine&, const OnBranch& from, double ds) {
  return Shape{from.y + ds * from.tangent};
}

std::optional<double> newton_step(const DomainLine& line, Shape& x, const OnBranch& from, double) {
  return newton_step_across(line, x, from.tangent);
}

// Towards growing μ without `forward`.
std::optional<OnBranch> with_tangent(const DomainLine& line, const Shape& x,
                                     const Vector* forward) {
  const Vector mu = Vector::Unit(Of::mu);
  const auto here = linearise(line, x.y, forward ? *forward : mu);
  if (!here) return {};
  const Vector tangent = here->matrix.partialPivLu().solve(mu);
  if (!tangent.allFinite()) return {};
  return OnBranch{x, tangent.normalized()};
}

bool continues(const DomainLine&, const OnBranch& from, const OnBranch& next, double ds) {
  constexpr double longest_chord = 1.15, rounding = 1e-9;  // an arc that turns so has less
  return from.tangent.dot(next.tangent) > model::least_cosine
      && (next.y - from.y).norm() < longest_chord * std::abs(ds) + rounding;
}

// To μ = 1, or to the fold before it.
OnBranch follow(const DomainLine& line, const Shape& from) {
  constexpr int most_steps = 400;
  constexpr double shortest = 1e-7, longest = 0.5;
  auto here = with_tangent(line, from, nullptr);
  double ds = 0.05;
  for (int step = 0; here && step < most_steps; ++step) {
    const auto next = model::advance(line, *here, ds, shortest);
    if (!next) break;
    if (next->slope() <= 0) {
      OnBranch fold = model::locate_fold(line, *here, *next, ds);
      if (fold.parameter() < 1) return fold;
    }
    if (next->parameter() >= 1) {
      const double share = (1 - here->parameter()) / (next->parameter() - here->parameter());
      Shape there{here->y + share * (next->y - here->y)};
      there.y[Of::mu] = 1;
      if (!model::converges(there, DomainLine::limits, [&](Shape& x) {
            return newton_step_across(line, x, Vector::Unit(Of::mu));
          }))
        break;
      return OnBranch{there, next->tangent};
    }
    here = next;
    ds = std::min(1.5 * ds, longest);
  }
  throw std::runtime_error("two domains: shooting cannot follow the branch");
}

// ---- Start and measures -------------------------------------------------------------------------------

double length_of_area(const Pole& pole, double area) {
  double length = std::sqrt(area / pi);
  for (double step = 1; std::abs(step) > 1e-12;) {
    const auto end = integrate(pole, length);
    if (!end) throw std::runtime_error("two domains: no piece of this area");
    step = (area - end->state[Row::area]) / end->rates(Row::area, 3);
    length += step;
  }
  return length;
}

Shape uniform_prolate(double fraction, double reduced_volume) {
  const ClassicalShape shape = shoot_branch(Branch::prolate, std::array{reduced_volume}).front();
  const Pole pole{shape.H_pole, shape.tension, shape.pressure};
  Vector y;
  y << pole.H, length_of_area(pole, 4 * pi * fraction), pole.tension / multiplier_unit,  //
      pole.H, length_of_area(pole, 4 * pi * (1 - fraction)), pole.tension / multiplier_unit,
      pole.pressure / multiplier_unit, 0;
  return {y};
}

// X over the arc length from the interface, through a and b.
struct Meridian {
  std::vector<double> s, X;
};
Meridian meridian(const TwoDomains& of, const Vector& y) {
  constexpr int intervals = 1000;
  const auto radii = [&](int H, int tension, int length, double kappa) -> Eigen::VectorXd {
    const Pole pole{y[H], multiplier_unit * y[tension], multiplier_unit * y[Of::pressure] / kappa};
    return sample(pole, y[length], intervals).row(Row::X);
  };
  const Eigen::VectorXd a = radii(Of::H_a, Of::tension_a, Of::length_a, of.kappa_a),
                        b = radii(Of::H_b, Of::tension_b, Of::length_b, of.kappa_b);
  Meridian m;
  for (int i = 0; i <= intervals; ++i) {
    m.s.push_back((double(i) / intervals - 1) * y[Of::length_a]);
    m.X.push_back(a[i]);
  }
  for (int i = intervals - 1; i >= 0; --i) {
    m.s.push_back((1 - double(i) / intervals) * y[Of::length_b]);
    m.X.push_back(b[i]);
  }
  return m;
}

struct Neck {
  double s = 0, radius = std::numeric_limits<double>::infinity();
};
// The least minimum, by parabolas: its place is off by the square of the intervals.
Neck neck(const Meridian& m) {
  Neck least;
  for (std::size_t i = 1; i + 1 < m.s.size(); ++i) {
    if (!(m.X[i] < m.X[i - 1] && m.X[i] <= m.X[i + 1] && m.X[i] < least.radius)) continue;
    const double h = m.s[i] - m.s[i - 1], k = m.s[i + 1] - m.s[i];
    const double left = (m.X[i] - m.X[i - 1]) / h, right = (m.X[i + 1] - m.X[i]) / k;
    const double second = (right - left) / (h + k), slope = (left * k + right * h) / (h + k);
    least = {m.s[i] - slope / (2 * second), m.X[i] - slope * slope / (4 * second)};
  }
  return least;
}

TwoDomainVesicle measured(const DomainLine& line, const OnBranch& at) {
  const Ends both = ends(line, at.y).value();
  const double X = both.a[Row::X].a, psi = both.a[Row::psi].a;
  const TwoDomains& of = line.to;  // but for V_r
  const Neck least = neck(meridian(of, at.y));
  return {
      .reduced_volume = line.at(&TwoDomains::reduced_volume, at.parameter()),
      .is_fold = at.parameter() < 1,
      .energy = 8 * pi * (of.kappa_a * both.a[Row::energy].a + of.kappa_b * both.b[Row::energy].a)
              + 2 * pi * (of.gauss_jump * (1 - std::cos(psi)) + of.line_tension * X),
      .pressure = multiplier_unit * at.y[Of::pressure],
      .tension_a = multiplier_unit * at.y[Of::tension_a] * of.kappa_a,
      .tension_b = multiplier_unit * at.y[Of::tension_b] * of.kappa_b,
      .interface_radius = X,
      .interface_angle = psi,
      .neck_radius = least.radius,
      .neck_offset = -least.s};
}

}  // namespace

TwoDomainVesicle vesicle_along(std::span<const TwoDomains> way) {
  TwoDomains from{.fraction = way.front().fraction, .reduced_volume = first_volume};
  Shape at = uniform_prolate(from.fraction, first_volume);
  for (const TwoDomains& to : way) {
    const DomainLine line{from, to};
    const OnBranch end = follow(line, at);
    if (&to == &way.back()) return measured(line, end);
    if (end.parameter() < 1) throw std::runtime_error("two domains: a fold on the way");
    at = end;
    at.y[Of::mu] = 0;
    from = to;
  }
  throw std::invalid_argument("two domains: no way");
}

TwoDomainVesicle open_vesicle(const TwoDomains& of) {
  TwoDomains first = of;
  first.reduced_volume = first_volume;
  return vesicle_along(std::array{first, of});
}

}  // namespace sbeh::axisym::shooting
