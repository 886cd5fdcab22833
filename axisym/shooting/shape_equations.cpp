#include "axisym/shooting/shape_equations.h"

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <ceres/jet.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <type_traits>

namespace sbeh::axisym::shooting {
namespace {

namespace odeint = boost::numeric::odeint;
using std::cos, std::sin;
using std::numbers::pi;

// Derivatives by H, tension and pressure of the pole.
using Jet = ceres::Jet<double, 3>;

template <class T>
using Shape = std::array<T, Row::count>;

template <class T>
struct Constants {
  T H, tension, pressure;
  double H0;
};
template <class T>
Constants<T> constants(const Pole& pole, double H0) {
  if constexpr (std::is_same_v<T, Jet>)
    return {Jet(pole.H, 0), Jet(pole.tension, 1), Jet(pole.pressure, 2), H0};
  else
    return {pole.H, pole.tension, pole.pressure, H0};
}

template <class T>
Shape<T> right_hand_side(const Shape<T>& x, const Constants<T>& pole) {
  const auto& [psi, H, X, gamma, Z, area, volume, energy] = x;
  const T &Sigma = pole.tension, &P = pole.pressure;
  const T sin_psi = sin(psi), cos_psi = cos(psi);
  const T c = sin_psi / X;
  const T PX = P * X, excess = H - pole.H0;

  Shape<T> d;
  d[Row::psi] = -H - c;
  d[Row::H] = 0.5 * PX * cos_psi - gamma * c;
  d[Row::X] = cos_psi;
  d[Row::gamma] = 0.5 * excess * excess + excess * c + Sigma - PX * sin_psi;
  d[Row::Z] = sin_psi;
  d[Row::area] = 2 * pi * X;
  d[Row::volume] = pi * X * X * sin_psi;
  d[Row::energy] = 0.125 * excess * excess * X;
  return d;
}

// ψ = u s + a₃s³ + a₅s⁵, −H = 2u + C₂s² + C₄s⁴, c = u + a₃s² + c₄s⁴, X = s + x₃s³ + x₅s⁵,
// γ = g₁s + g₃s³ + g₅s⁵, w = 2u + H₀: coefficients compared in the equations, power by power.
template <class T>
Shape<T> pole_series(const Constants<T>& pole, double s) {
  const T& P = pole.pressure;
  const T u = -0.5 * pole.H, uu = u * u, w = 2. * u + pole.H0;

  const T g1 = pole.tension + 0.5 * pole.H0 * w;
  const T C2 = 0.5 * (g1 * u - 0.5 * P);
  const T a3 = 0.25 * C2;
  const T g3 = (C2 * (0.75 * w - u) - P * u) / 3.;
  const T x3 = -uu / 6.;

  const T C4 = 0.25 * (g3 * u + g1 * a3 + P * uu / 3.);
  const T a5 = (C4 + 2. / 15 * a3 * uu) / 6.;
  const T c4 = a5 - 2. / 15 * a3 * uu;
  const T g5 = ((w - u) * C4 + 0.5 * C2 * C2 - w * c4 - C2 * a3 - P * (a3 - uu * u / 3.)) / 5.;
  const T x5 = (uu * uu / 24. - u * a3) / 5.;

  const double ss = s * s;
  Shape<T> x;
  x[Row::psi] = s * (u + ss * (a3 + ss * a5));
  x[Row::H] = -(2. * u + ss * (C2 + ss * C4));
  x[Row::X] = s * (1. + ss * (x3 + ss * x5));
  x[Row::gamma] = s * (g1 + ss * (g3 + ss * g5));
  x[Row::Z] = ss * (0.5 * u + 0.25 * ss * (a3 - uu * u / 6.));
  x[Row::area] = pi * ss * (1. + ss * (x3 / 2. + ss * x5 / 3.));
  x[Row::volume] = pi * ss * ss * (u / 4. + ss * (a3 - uu * u / 2.) / 6.);
  x[Row::energy] = 0.125 * ss * w * (0.5 * w + ss * (0.5 * C2 + 0.25 * w * x3));
  return x;
}

// The integrator sees plain numbers: a shape with derivatives has four per row.
constexpr std::size_t jet_size = 4;
template <class T>
using Numbers = std::array<double, Row::count*(std::is_same_v<T, Jet> ? jet_size : 1)>;

template <class T>
Shape<T> unpack(const Numbers<T>& x) {
  Shape<T> shape;
  if constexpr (std::is_same_v<T, Jet>)
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const double* row = &x[jet_size * i];
      shape[i] = Jet(row[0], Eigen::Vector3d(row[1], row[2], row[3]));
    }
  else
    shape = x;
  return shape;
}
template <class T>
Numbers<T> pack(const Shape<T>& shape) {
  Numbers<T> x;
  if constexpr (std::is_same_v<T, Jet>)
    for (std::size_t i = 0; i < shape.size(); ++i) {
      double* row = &x[jet_size * i];
      row[0] = shape[i].a;
      for (int j = 0; j < 3; ++j) row[1 + j] = shape[i].v[j];
    }
  else
    x = shape;
  return x;
}

template <class T>
struct System {
  Constants<T> pole;
  void operator()(const Numbers<T>& x, Numbers<T>& dx, double) const {
    dx = pack<T>(right_hand_side(unpack<T>(x), pole));
  }
};

template <class T>
using Stepper = odeint::runge_kutta_fehlberg78<Numbers<T>>;
// Steppers are copied from it, with their scratch space; static, so that it is not undefined.
template <class T>
const Stepper<T> blank;

// A solution under way.
template <class T>
class Integration {
 public:
  Integration(const Pole& pole, double start, const Options& options)
      : system_{constants<T>(pole, options.H0)},
        stepper_(odeint::make_controlled(options.tolerance, options.tolerance, blank<T>)),
        s_(start),
        x_(pack<T>(pole_series(system_.pole, start))) {}

  // False where the solution becomes singular.
  bool advance_to(double arc_length) {
    constexpr int most_steps = 5000;
    constexpr double shortest_step = 1e-12;
    for (int steps = 0; arc_length - s_ > shortest_step; ++steps) {
      const bool last = s_ + step_ >= arc_length;
      double step = last ? arc_length - s_ : step_;
      const bool accepted = stepper_.try_step(system_, x_, s_, step) == odeint::success;
      if (!(last && accepted)) step_ = step;
      if (!std::isfinite(x_.back()) || step < shortest_step || steps > most_steps) return false;
    }
    return true;
  }
  const Numbers<T>& state() const { return x_; }
  const Constants<T>& pole() const { return system_.pole; }

 private:
  System<T> system_;
  odeint::controlled_runge_kutta<Stepper<T>> stepper_;
  double s_;
  double step_ = 0.05;
  Numbers<T> x_;
};

State as_vector(const Shape<double>& x) { return Eigen::Map<const State>(x.data()); }

void require(double value, bool in_range, const char* name, const char* range) {
  if (!in_range)
    throw std::invalid_argument(fmt::format("shooting: {} = {} must be in {}", name, value, range));
}

}  // namespace

void validate(const Options& options) {
  const double tolerance = options.tolerance, start = options.series_start;
  require(tolerance, tolerance >= 1e-15 && tolerance <= 1e-8, "tolerance", "[1e-15, 1e-8]");
  require(start, start > 0 && start <= 0.01, "series_start", "(0, 0.01]");
}

std::optional<End> integrate(const Pole& pole, double arc_length, const Options& options) {
  Integration<Jet> solution(pole, std::min(options.series_start, arc_length), options);
  if (!solution.advance_to(arc_length)) return std::nullopt;
  const Shape<Jet> x = unpack<Jet>(solution.state());
  const Shape<Jet> d = right_hand_side(x, solution.pole());
  End end;
  for (int i = 0; i < Row::count; ++i) {
    const std::size_t row = std::size_t(i);
    end.state[i] = x[row].a;
    end.rates.row(i) << x[row].v.transpose(), d[row].a;
  }
  return end;
}

Eigen::Matrix<double, Row::count, Eigen::Dynamic> sample(const Pole& pole, double arc_length,
                                                         int intervals, const Options& options) {
  Integration<double> solution(pole, options.series_start, options);
  Eigen::Matrix<double, Row::count, Eigen::Dynamic> states(int(Row::count), intervals + 1);
  for (int i = 0; i <= intervals; ++i) {
    const double s = arc_length * i / intervals;
    if (s <= options.series_start) {
      states.col(i) = as_vector(pole_series(solution.pole(), s));
    } else {
      if (!solution.advance_to(s)) throw std::runtime_error("shooting: the curve is singular");
      states.col(i) = as_vector(solution.state());
    }
  }
  return states;
}

}  // namespace sbeh::axisym::shooting
