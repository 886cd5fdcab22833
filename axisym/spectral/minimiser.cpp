#include "axisym/spectral/minimiser.h"

#include "axisym/spectral/classical.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sbeh::axisym {

using namespace spectral;
using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr int profile_intervals = 256;

void require_reduced_volume(double reduced_volume) {
  if (!(reduced_volume > 0 && reduced_volume < 1))
    throw std::invalid_argument("reduced volume " + std::to_string(reduced_volume)
                                + ": must lie between 0 and 1");
}

ClassicalShape shape_of(Branch branch, const ClassicalMinimum& minimum) {
  const Curve curve = minimum.curve();
  ClassicalShape shape{.branch = branch,
                       .reduced_volume = minimum.reduced_volume,
                       .energy = minimum.reduced_energy(),
                       .H_pole = pole_curvatures(curve)[0],
                       .pressure = minimum.pressure(),
                       .tension = minimum.tension(),
                       .self_contact = false,
                       .profile = profile(curve, profile_intervals)};
  shape.self_contact = model::meets_itself(shape.profile);
  return shape;
}

// Largest value of an even function Σ a_k cos(kπx), x ∈ [0, 1]: on a grid, then by Brent's method.
double largest(const VectorXd& a, const std::vector<int>& k) {
  const auto value = [&](double x) {
    double sum = a[0];
    for (std::size_t i = 0; i < k.size(); ++i)
      sum += a[Index(i) + 1] * std::cos(k[i] * std::numbers::pi * x);
    return sum;
  };
  const int grid = 4 * k.back();
  int best = 0;
  double top = value(0);
  for (int j = 1; j <= grid; ++j)
    if (const double v = value(double(j) / grid); v > top) best = j, top = v;
  const auto [at, least] = boost::math::tools::brent_find_minima(
      [&](double x) { return -value(x); }, double(best - 1) / grid, double(best + 1) / grid,
      std::numeric_limits<double>::digits / 2);
  return std::max(top, -least);
}

// Coefficients of an even function by its values on the points.
VectorXd even_series(const Basis& basis, const VectorXd& values) {
  VectorXd a = basis.C.transpose() * values * 2 / basis.points();
  a[0] /= 2;
  return a;
}

OrderedMinimum report(double reduced_volume, const Problem& problem, const Critical& state) {
  const Basis& B = *problem.basis;
  const Curve curve = curve_of(problem, state.y);
  const VectorXd c = order_of(problem, state.y), H = even_series(B, mean_curvature(curve));
  OrderedMinimum out{.reduced_volume = reduced_volume,
                     .energy = state.energy,
                     .parts = energy_parts(problem, state.y),
                     .order_min = -largest(-c, B.k),
                     .H_abs_max = std::max(largest(H, B.k), largest(-H, B.k)),
                     .pressure = -state.multipliers[1],
                     .tension = state.multipliers[0],
                     .stiffness = state.stiffness,
                     .profile = {profile(curve, profile_intervals), {}}};
  const Index points = out.profile.X.cols();
  VectorXd& order = out.profile.beta = VectorXd::Constant(points, c[0]);
  for (Index j = 0; j < points; ++j)
    for (std::size_t i = 0; i < B.k.size(); ++i)
      order[j] +=
          c[Index(i) + 1] * std::cos(B.k[i] * std::numbers::pi * double(j) / double(points - 1));
  return out;
}

// A resolved minimum of this class next to curve and order, on as many modes as it takes.
struct Ordered {
  Problem problem;
  Critical state;
};
std::optional<Ordered> ordered_from(const model::Material& material, double reduced_volume,
                                    Branch branch, Curve curve, VectorXd c) {
  constexpr double resolved = 1e-10;
  constexpr int first = 60, most = 210;
  const Grading grading{.a = branch == Branch::oblate ? 0.8 : 0};  // finer at the rim
  for (int cutoff = first; cutoff <= most; cutoff = cutoff * 3 / 2) {
    const auto modes = branch == Branch::stomatocyte ? basis_for(branch, reduced_volume, cutoff)
                                                     : basis(Symmetry::top_bottom, cutoff, grading);
    const Problem problem{material, modes, true};
    VectorXd longer = VectorXd::Zero(problem.basis->modes() + 1);
    longer.head(std::min(c.size(), longer.size())) = c.head(std::min(c.size(), longer.size()));
    const auto state = minimise(problem, target_of(problem, reduced_volume),
                                pack(on_basis(curve, problem.basis), longer));
    if (!state) return {};
    curve = curve_of(problem, state->y), c = order_of(problem, state->y);
    if (!is_of_class(branch, curve)) return {};
    if (std::max(tail(curve.b), tail(c)) < resolved) return Ordered{problem, *state};
  }
  return {};
}

}  // namespace

std::optional<ClassicalShape> minimise_classical(Branch branch, double reduced_volume) {
  require_reduced_volume(reduced_volume);
  const auto found = minimum(branch, reduced_volume);
  return found ? std::optional(shape_of(branch, *found)) : std::nullopt;
}

std::vector<ClassicalShape> minimise_branch(Branch branch,
                                            std::span<const double> reduced_volumes) {
  std::vector<ClassicalShape> shapes;
  std::optional<ClassicalMinimum> last;
  for (const double v : reduced_volumes) {
    require_reduced_volume(v);
    auto found =
        last ? minimum_along(branch, v, last->reduced_volume, last->curve()) : minimum(branch, v);
    if (!found) continue;
    shapes.push_back(shape_of(branch, *found));
    last = std::move(found);
  }
  return shapes;
}

std::optional<OrderedMinimum> minimise_ordered(const model::Material& material,
                                               double reduced_volume, Branch start) {
  require_reduced_volume(reduced_volume);
  material.validate();
  const auto classical = minimum(start, reduced_volume);
  if (!classical) return {};
  Curve curve = classical->curve();
  VectorXd c = VectorXd::Constant(1, model::full_order);
  constexpr double shortest = 1. / 64;
  double done = 0;
  for (double step = 1; step >= shortest;) {
    model::Material part = material;
    const double t = std::min(1., done + step);
    part.L1 *= t, part.L2 *= t, part.L3 *= t;
    if (const auto found = ordered_from(part, reduced_volume, start, curve, c)) {
      if (t == 1) return report(reduced_volume, found->problem, found->state);
      curve = curve_of(found->problem, found->state.y);
      c = order_of(found->problem, found->state.y);
      done = t;
    } else {
      step /= 2;
    }
  }
  return {};
}

}  // namespace sbeh::axisym
