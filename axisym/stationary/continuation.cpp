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

std::optional<BranchState> solve_at(const model::Material& material, model::Model model,
                                    PlanePoint at, const StationaryState& guess,
                                    const NewtonOptions& options) {
  const NewtonResult r =
      solve_stationary(material.with_L(at.L), model, target_of(at.reduced_volume), guess, options);
  if (r.status != NewtonStatus::converged) return {};
  return BranchState{r.state, at, r.determinant_sign, r.iterations};
}

namespace {

constexpr int direct_iterations = 6;  // more than these: the prediction was not on the branch

std::optional<BranchState> solve_near(const Line& line, double mu, const StationaryState& guess,
                                      int determinant_sign) {
  auto solved = solve_at(line.material, line.model, line.at(mu), guess,
                         {.most_iterations = direct_iterations});
  if (solved && determinant_sign != 0 && solved->determinant_sign != determinant_sign) return {};
  return solved;
}

// With the nodes where the curvature is, if that succeeds.
FollowResult arrived(const Line& line, BranchState state, double grading) {
  const auto placed = solve_near(line, 1, redistribute(state, grading), 0);
  state.iterations = placed ? placed->iterations : 0;
  if (placed) static_cast<StationaryState&>(state) = *placed;
  return {Arrival::reached, state};
}

}  // namespace

FollowResult follow(const model::Material& material, model::Model model, const BranchState& from,
                    PlanePoint to, const Numerics& numerics) {
  const Line line{material, model, from.at, to};
  auto here = with_tangent(line, {from, 0});
  if (!here) return {Arrival::lost, from};
  const int sign = here->determinant_sign;

  const double whole = 1 / here->slope();  // arc length to μ = 1 along the tangent
  if (whole * largest_change(here->tangent) < 0.3) {
    StationaryState guess = from;
    displace(here->tangent, whole, guess);
    if (const auto solved = solve_near(line, 1, guess, sign))
      return arrived(line, *solved, numerics.grading);
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
      return {Arrival::fold, {fold, line.at(fold.mu), sign, step}};
    }
    if (next->mu >= 1) {
      const double share = (1 - here->mu) / (next->mu - here->mu);
      const auto close = arc_step(line, *here, ds * share);
      // A different sign here is a branch crossing this one, not another branch.
      const auto solved = solve_near(line, 1, close ? *close : *next, 0);
      if (solved) return arrived(line, *solved, numerics.grading);
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
  return {Arrival::lost, {*here, line.at(here->mu), sign}};
}

}  // namespace sbeh::axisym
