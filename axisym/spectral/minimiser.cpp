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

// A resolved minimum with its problem.
struct Resolved {
  Problem problem;
  Critical state;

  Curve curve() const { return curve_of(problem, state.y); }
  double multiplier(Measure measure) const {
    const int at = problem.place_of(measure);
    return at < 0 ? 0 : state.multipliers[at];
  }
};

VectorXd order_along(const Basis& B, const VectorXd& c, Index points) {
  VectorXd order = VectorXd::Constant(points, c[0]);
  for (Index j = 0; j < points; ++j)
    for (Index i = 1; i < c.size(); ++i)
      order[j] +=
          c[i]
          * std::cos(B.k[std::size_t(i - 1)] * std::numbers::pi * double(j) / double(points - 1));
  return order;
}

EnergyMinimum report(const model::Material& material, double reduced_volume,
                     const Resolved& found) {
  const Problem& problem = found.problem;
  const Basis& B = *problem.basis;
  const VectorXd H = even_series(B, mean_curvature(found.curve()));
  const VectorXd c = problem.with_order ? order_of(problem, found.state.y)
                                        : VectorXd::Constant(1, model::full_order);
  const double finite_moment = expand(problem, found.state.y)->moment;
  EnergyMinimum out{
      .reduced_volume = reduced_volume,
      .energy = found.state.energy,
      .parts = energy_parts(problem, found.state.y),
      .area_difference = 0,
      .order_min = c[0],
      .H_abs_max = std::max(largest(H, B.k), largest(-H, B.k)),
      .H_poles = {pole_curvatures(found.curve())[0], pole_curvatures(found.curve())[1]},
      .pressure = -found.multiplier(Measure::volume),
      .tension = found.multiplier(Measure::area),
      .moment = finite_moment + found.multiplier(Measure::W2),
      .chemical_potential = -found.multiplier(Measure::excess_order),
      .stiffness = found.state.stiffness,
      .profile = {profile(found.curve(), profile_intervals), {}}};
  out.area_difference = out.energy - out.parts.total();
  if (problem.with_order) {
    out.order_min = -largest(-c, B.k);
  } else {  // by Gauss and Bonnet
    out.parts.gaussian = 4 * std::numbers::pi * material.kappa_gauss(model::full_order);
    out.energy += out.parts.gaussian;
  }
  out.profile.beta = order_along(B, c, out.profile.X.cols());
  return out;
}

std::shared_ptr<const Basis> fine_basis(Branch branch, double reduced_volume, int cutoff) {
  if (branch == Branch::stomatocyte) return basis_for(branch, reduced_volume, cutoff);
  const Grading grading{.a = branch == Branch::oblate ? 0.8 : 0};  // finer at the rim
  return basis(Symmetry::top_bottom, cutoff, grading);
}

// A resolved minimum of this class next to curve and order, on as many modes as it takes.
std::optional<Resolved> resolved_from(const model::Material& material, model::Model model,
                                      double reduced_volume, Branch branch, Curve curve,
                                      VectorXd c) {
  constexpr double resolved = 1e-10;
  constexpr int first = 60, most = 210;
  for (int cutoff = first; cutoff <= most; cutoff = cutoff * 3 / 2) {
    const Problem problem =
        Problem::of(material, model, fine_basis(branch, reduced_volume, cutoff));
    VectorXd longer = VectorXd::Zero(problem.order_modes());
    const Index kept = std::min(c.size(), longer.size());
    longer.head(kept) = c.head(kept);
    const auto state = minimise(problem, target_of(problem, reduced_volume),
                                pack(on_basis(curve, problem.basis), longer));
    if (!state) return {};
    curve = curve_of(problem, state->y), c = order_of(problem, state->y);
    if (!is_of_class(branch, curve)) return {};
    if (std::max(tail(curve.b), c.size() > 0 ? tail(c) : 0) < resolved)
      return Resolved{problem, *state};
  }
  return {};
}

// Along t from 0, where `from` is, to 1: at(t) on the last one found, in steps that are halved where there is none.
template <class At>
std::optional<Resolved> in_steps(std::optional<Resolved> from, const At& at) {
  constexpr double shortest = 1. / 64;
  double done = 0;
  for (double step = 1; step >= shortest;) {
    const double t = std::min(1., done + step);
    if (auto found = at(t, from)) {
      if (t == 1) return found;
      from = std::move(found);
      done = t;
    } else {
      step /= 2;
    }
  }
  return {};
}

// A material of SSH on the way from the classical shape, whose W₂ is `first_W2`.
model::Material partly_curved(const model::Material& whole, double t, double first_W2) {
  model::Material part = whole;
  part.spontaneous_curvature *= t;
  part.flexoelectric = whole.flexoelectric.times(t);
  part.area_difference.W2 = first_W2 + t * (whole.area_difference.W2 - first_W2);
  return part;
}

std::optional<Resolved> uniform_minimum(const model::Material& material, double reduced_volume,
                                        Branch branch) {
  const auto classical = minimum(branch, reduced_volume);
  if (!classical) return {};
  const Curve start = classical->curve();
  const Angles at = angles(start);
  const double W2 = 2 * std::numbers::pi * start.length * start.length
                  * start.basis->odd.dot(at.r.cwiseProduct(mean_curvature(start)));
  return in_steps({}, [&](double t, const std::optional<Resolved>& last) {
    return resolved_from(partly_curved(material, t, W2), model::Model::SSH, reduced_volume, branch,
                         last ? last->curve() : start, {});
  });
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

std::optional<EnergyMinimum> minimise_energy(const model::Material& material, model::Model model,
                                             double reduced_volume, Branch start) {
  require_reduced_volume(reduced_volume);
  material.validate();
  if (start == Branch::pear)
    throw std::invalid_argument("branch pear: none that a classical shape leads to");
  const auto uniform = uniform_minimum(material, reduced_volume, start);
  if (!uniform) return {};
  if (!has_free_order(model)) return report(material, reduced_volume, *uniform);
  const VectorXd order = VectorXd::Constant(1, material.mean_order.value_or(model::full_order));
  const auto found = in_steps({}, [&](double t, const std::optional<Resolved>& last) {
    model::Material part = material.with_given_scaled(t).with_L1(t * material.L1);
    part.residual_stiffness *= t;
    return resolved_from(part, model, reduced_volume, start,
                         last ? last->curve() : uniform->curve(),
                         last ? order_of(last->problem, last->state.y) : order);
  });
  if (!found) return {};
  return report(material, reduced_volume, *found);
}

}  // namespace sbeh::axisym
