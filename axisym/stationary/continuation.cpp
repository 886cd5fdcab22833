#include "axisym/stationary/continuation.h"

#include "axisym/redistribute.h"
#include "axisym/stationary/arclength.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace sbeh::axisym {

Target target_of(double reduced_volume) {
  return {4 * std::numbers::pi, 4 * std::numbers::pi / 3 * reduced_volume};
}

namespace {

constexpr int direct_iterations = 6;  // more than these: the prediction was not on the branch

std::optional<NewtonResult> solve_near(const Line& line, double mu, const StationaryState& guess,
                                       int determinant_sign) {
  const NewtonResult r = solve_stationary(line.material(mu), line.model, line.target(mu), guess,
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
  const Line line{material, model, from.at, to};
  auto here = with_tangent(line, {0, from.solution});
  if (!here) return {Arrival::lost, from};
  const int sign = here->determinant_sign;

  const double whole = 1 / here->slope();  // arc length to μ = 1 along the tangent
  if (whole * largest_change(here->tangent) < 0.3) {
    StationaryState guess = from.solution;
    displace(here->tangent, whole, guess);
    if (const auto r = solve_near(line, 1, guess, sign))
      return {Arrival::reached, arrived(line, 1, r->solution, sign, numerics)};
  }

  double ds = std::min(whole / 2, 0.1), moved = 0;
  // The displacement after which nodes are redistributed: along L, where necks grow sharp, at once.
  const double stale = to.L == from.at.L ? 0.1 : 0;
  for (int step = 0; step < 200 && ds > 1e-7; ++step) {
    const auto next = arc_step(line, *here, ds);
    if (!next) {
      ds /= 2;
      continue;
    }
    if (next->slope() <= 0 && moved > 0) {  // the fold is worth fresh nodes
      here = with_fresh_nodes(line, *here, numerics.grading);
      moved = 0;
      continue;
    }
    if (next->slope() <= 0) {
      const PathState fold = locate_fold(line, *here, *next, ds);
      return {Arrival::fold,
              {.at = line.at(fold.mu),
               .solution = fold.s,
               .determinant_sign = sign,
               .iterations = step}};
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
    moved += ds * largest_change(here->tangent);
    here = next;
    if (moved > stale) {
      here = with_fresh_nodes(line, *here, numerics.grading);
      moved = 0;
    }
    ds *= 1.5;
  }
  return {Arrival::lost, {.at = line.at(here->mu), .solution = here->s, .determinant_sign = sign}};
}

}  // namespace sbeh::axisym
