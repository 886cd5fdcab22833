#include "axisym/stationary/continuation.h"

#include "axisym/curvature.h"
#include "axisym/redistribute.h"
#include "axisym/shape_class.h"
#include "axisym/stationary/arclength.h"
#include "axisym/stationary/symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace sbeh::axisym {

Target target_of(double reduced_volume) {
  return {4 * std::numbers::pi, 4 * std::numbers::pi / 3 * reduced_volume};
}

std::optional<BranchState> solve_at(const model::Material& material, model::Model model,
                                    PlanePoint at, const StationaryState& guess,
                                    const NewtonOptions& options) {
  const NewtonResult r =
      solve_stationary(material.with_L1(at.L), model, target_of(at.reduced_volume), guess, options);
  if (r.status != NewtonStatus::converged) return {};
  return BranchState{r.state, at, r.determinant_sign};
}

namespace {

constexpr double near = 1e-4;  // enough where nodes are placed anew, and Newton's method goes on
constexpr int direct_iterations = 6;  // more than these: the prediction was not on the branch

std::optional<BranchState> solve_near(const Line& line, double mu, const StationaryState& guess,
                                      NewtonOptions options = {}) {
  options.most_iterations = direct_iterations;
  options.symmetric = line.symmetric;
  auto solved = solve_at(line.material_at(mu), line.model, line.at(mu), guess, options);
  if (solved && line.symmetric) static_cast<StationaryState&>(*solved) = symmetric_part(*solved);
  return solved;
}

// Whether a neck or a rim has become so much sharper that the nodes, which were placed for `here`, do not resolve it.
bool outgrows_nodes(const StationaryState& here, const StationaryState& next) {
  const double now = resolution(next.X, next.H);
  return now > 0.1 && now > 1.4 * resolution(here.X, here.H);
}

// Whether the narrowest neck closes before μ = 1. Where its radius a is small, μ falls short of the limit by
// a ln(C/a), C of the size of the surface (Fourcade et al., Phys. Rev. E 49, 5276, 1994): by some 1.2 times dμ/d(−ln a).
bool is_closing(const LineState& before, const LineState& here) {
  constexpr double narrow = 0.005, closed = 1e-4, reach = 2;
  const double a = thinnest_neck(here.X);
  if (!(a < narrow)) return false;
  const double rate = (here.mu - before.mu) / std::log(thinnest_neck(before.X) / a);
  return a < closed || (rate > 0 && here.mu + reach * rate < 1);
}

// With the nodes where the curvature is, if that succeeds.
FollowResult arrived(const Line& line, BranchState state, const Numerics& numerics) {
  auto placed = solve_near(line, 1, fitted(state, numerics));
  if (!placed) placed = solve_near(line, 1, state);
  if (placed) static_cast<StationaryState&>(state) = *placed;
  return {Arrival::reached, state, line, 1};
}

}  // namespace

FollowResult follow(const model::Material& material, model::Model model, const BranchState& from,
                    PlanePoint to, const Numerics& numerics) {
  Line line{material, model, from.at, to};
  line.symmetric = is_symmetric(from.X);
  return follow(line, from, numerics);
}

FollowResult follow(const Line& line, const BranchState& from, const Numerics& numerics) {
  auto here = with_tangent(line, {from, 0});
  if (!here) return {Arrival::lost, from, line, 0};
  const int sign = here->determinant_sign;

  const double whole = 1 / here->slope();  // arc length to μ = 1 along the tangent
  if (const double change = whole * largest_change(here->tangent); change < 0.3) {
    StationaryState guess = from;
    displace(here->tangent, whole, guess);
    const auto solved = solve_near(
        line, 1, guess, {.tolerance = near, .far = largest_correction(change), .corrects = false});
    if (solved && (sign == 0 || solved->determinant_sign == sign))
      return arrived(line, *solved, numerics);
  }

  double ds = std::min(whole / 2, 0.1), growth = 1.5;
  for (int step = 0; step < 300 && ds > 1e-7; ++step) {
    const auto next = arc_step(line, *here, ds);
    if (!next || outgrows_nodes(*here, *next)) {
      ds /= 2;
      growth = 1;  // of the next step
      continue;
    }
    if (next->slope() <= 0) {
      const PathState fold = locate_fold(line, *here, *next, ds);
      if (fold.mu >= 1) {  // the end of the line is before it
        ds /= 2;
        growth = 1;
        continue;
      }
      return {Arrival::fold,
              {fold, line.at(fold.mu), sign},
              line,
              fold.mu,
              {*here, line.at(here->mu), sign}};
    }
    if (next->mu >= 1) {
      const double share = (1 - here->mu) / (next->mu - here->mu);
      const auto close = arc_step(line, *here, ds * share);
      // A different sign here is a branch crossing this one, not another branch.
      const auto solved =
          solve_near(line, 1, close ? *close : *next, {.tolerance = near, .corrects = false});
      if (solved) return arrived(line, *solved, numerics);
      ds /= 2;
      continue;
    }
    // Necks and rims grow sharp; and Newton's method converges from farther where nodes are well placed.
    const LineState before = *std::exchange(here, with_fresh_nodes(line, *next, numerics));
    if (is_closing(before, *here))
      return {Arrival::neck, {*here, line.at(here->mu), sign}, line, here->mu};
    ds *= std::exchange(growth, 1.5);
  }
  return {Arrival::lost, {*here, line.at(here->mu), sign}, line, here->mu};
}

}  // namespace sbeh::axisym
