#include "axisym/rim/beyond_fold.h"

#include "axisym/rim/path.h"
#include "axisym/spectral/classical.h"
#include "model/numerics/root.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

namespace sbeh::axisym {

using namespace spectral;
using Eigen::Index, Eigen::VectorXd;
using std::numbers::pi;

namespace {

constexpr double smallest_L = 1e-3;  // below, the layer of width √L needs more elements inside
constexpr double largest_L = 2;      // beyond, no order withstands any rim
constexpr double smallest_order = 1e-5;  // at the rim; below, it is a kink
constexpr double near_rim = 1e-4;        // distance at which a jump is measured
const double critical_jump = pi / std::numbers::sqrt3;

double order_at_rim(const RimProblem& problem, const RimState& s) {
  return problem.order_at_nodes(s.y).tail<1>()[0];
}

// Part of a branch between folds, in the order in which it was followed.
struct Leg {
  std::vector<RimPathState> states;
  std::optional<RimPathState> fold, beyond;  // where it ends, and the first state after

  // A state so far before the fold that no eigenvalue is near zero for its sake.
  const RimState& before_fold() const {
    constexpr double clear = 0.1;  // of the tangent's L
    for (auto state = states.rbegin(); state != states.rend(); ++state)
      if (std::abs(state->slope()) > clear) return *state;
    return states.front();
  }

  // At this L, from its two neighbours; empty when it is not on the leg.
  std::optional<RimState> at(const RimProblem& problem, double L) const {
    for (std::size_t k = 1; k < states.size(); ++k) {
      const RimState &a = states[k - 1], &b = states[k];
      if ((a.L - L) * (b.L - L) > 0) continue;
      const double t = (L - a.L) / (b.L - a.L);
      return solve(problem,
                   {L, (1 - t) * a.y + t * b.y, (1 - t) * a.multipliers + t * b.multipliers});
    }
    return {};
  }
};

// Follows a branch until it folds or `enough` says so.
Leg follow(const RimProblem& problem, RimPathState here,
           const std::function<bool(const RimState&)>& enough) {
  constexpr int most_steps = 400;
  constexpr double longest = 0.03, shortest = 1e-7;
  Leg leg{{here}, {}, {}};
  double ds = 0.005;
  for (int step = 0; step < most_steps && !enough(here); ++step) {
    const auto next = advance(problem, here, ds, shortest);
    if (!next) break;
    if (next->slope() * here.slope() < 0) {
      leg.fold = locate_fold(problem, here, *next, ds);
      leg.beyond = next;
      // Closer to the fold, so that little of the leg is missing.
      const double left = ds * here.slope() / (here.slope() - next->slope());
      for (const double share : {0.5, 0.75, 0.9})
        if (const auto close = arc_step(problem, here, share * left);
            close && close->slope() * here.slope() > 0)
          leg.states.push_back(*close);
      return leg;
    }
    here = *next;
    leg.states.push_back(here);
    ds = std::min(1.4 * ds, longest);
  }
  return leg;
}

RimRecord record(RimKind kind, const RimProblem& problem, const RimState& s) {
  const Problem at = problem.at(s.L);
  const Basis& B = *problem.basis;
  const Curve curve = curve_of(at, s.y);
  const VectorXd H = mean_curvature(curve), psi = problem.angles_at_nodes(s.y),
                 beta = problem.order_at_nodes(s.y), sigma = rim_nodes(problem.mesh);
  const auto change = [](const VectorXd& f) {
    return (f.tail(f.size() - 1) - f.head(f.size() - 1)).cwiseAbs().maxCoeff();
  };
  Index outside = 0;  // the last node that far from the rim
  while (outside + 1 < sigma.size() && (0.5 - sigma[outside + 1]) * curve.length >= near_rim)
    ++outside;
  const bool kink = problem.rim == Rim::sharp;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {.kind = kind,
          .reduced_volume = problem.reduced_volume,
          .L = s.L,
          .energy = expand(at, s.y)->energy,
          .order_rim = beta[beta.size() - 1],
          .H_rim = kink ? -infinity : H[B.points() - 1],
          .H_abs_max = kink ? infinity : H.cwiseAbs().maxCoeff(),
          .jump = pi - 2 * psi[outside],
          .resolution = std::max(change(psi), change(beta) / model::full_order),
          .pressure = -s.multipliers[1],
          .negative_directions = negative_directions(problem, s),
          .state = profile_of(problem, s.y)};
}

// The branch of smooth oblates up to its fold, from the classical shape.
Leg smooth_leg(const RimProblem& problem) {
  const auto classical = spectral::minimum(Branch::oblate, problem.reduced_volume);
  if (!classical) return {};
  const Curve curve = classical->curve();
  const VectorXd sigma = rim_nodes(problem.mesh);
  VectorXd psi(sigma.size());
  for (Index i = 0; i < sigma.size(); ++i) psi[i] = angle(curve, sigma[i]);
  const VectorXd beta = VectorXd::Constant(sigma.size(), model::full_order);
  const auto first = minimise(problem, smallest_L, problem.unknowns(curve.length, psi, beta));
  const auto start = first ? with_tangent(problem, *first) : std::nullopt;
  if (!start) return {};
  return follow(problem, *start, [](const RimState& s) { return s.L > largest_L; });
}

// Two spherical caps of this reduced volume, joined at a kink where the order vanishes.
VectorXd spherical_caps(const RimProblem& problem, double L) {
  // V_r = (2 + c)√(1 − c)/2 of caps with the angle arccos c at the rim; falling in c.
  const auto miss = [&](double c) {
    return (2 + c) * std::sqrt(1 - c) / 2 - problem.reduced_volume;
  };
  const double c = model::root_between(miss, 0, 1).middle();
  const double alpha = std::acos(c), length = 2 * alpha / std::sqrt(1 - c);
  const VectorXd sigma = rim_nodes(problem.mesh);
  const model::Material material = problem.material.with_L1(L);
  const double gap = material.potential.value(0.) - material.potential.value(model::full_order);
  const double width = model::full_order * std::sqrt(material.l1() / (2 * std::max(gap, 0.1)));
  const VectorXd beta =
      model::full_order * ((0.5 - sigma.array()) * length / width).tanh().matrix();
  return problem.unknowns(length, 2 * alpha * sigma, beta);
}

// The branches of sharp rims: kinks, and where these open, the smooth but narrow rims.
class SharpStates {
 public:
  /// Followed down from the largest L; where they melt there already, from a smaller one above `least`.
  SharpStates(const RimProblem& smooth, double largest, double least)
      : smooth_(smooth), kinks_(smooth.material, smooth.reduced_volume, Rim::sharp, smooth.mesh) {
    if (smooth.material.residual_stiffness > 0) return;
    for (double L = largest; L > least && !exist_; L *= 0.8) {
      const auto kink = minimise(kinks_, L, spherical_caps(kinks_, L));
      if (!kink) continue;
      if (const auto open = opened(*kink)) {
        exist_ = true;
        follow_down(*open);
      } else if (record(RimKind::sharp, kinks_, *kink).jump > critical_jump) {
        exist_ = kinks_below_ = true;
        top_of_kinks_ = L;
      }
    }
  }

  const std::optional<RimPathState>& fold() const { return leg_.fold; }
  const RimState& before_fold() const { return leg_.before_fold(); }
  /// Below this L there are none, or so near their fold that they are not followed.
  double lowest() const { return leg_.fold ? leg_.states.back().L : 0; }

  std::optional<RimRecord> at(double L, RimKind kind = RimKind::sharp) const {
    if (!exist_) return {};
    if (const auto s = leg_.at(smooth_, L)) return record(kind, smooth_, *s);
    if (!kinks_below_ || L > top_of_kinks_) return {};
    const auto kink = minimise(kinks_, L, spherical_caps(kinks_, L));
    if (!kink) return {};
    const RimRecord r = record(kind, kinks_, *kink);
    return r.jump > critical_jump ? std::optional(r) : std::nullopt;
  }

 private:
  // The minimum with β > 0 at the rim next to a kink that is none.
  std::optional<RimState> opened(const RimState& kink) const {
    const VectorXd psi = kinks_.angles_at_nodes(kink.y), beta = kinks_.order_at_nodes(kink.y);
    for (const double order : {0.03, 0.01, 0.003, 0.001, 0.1}) {
      const auto turn = (beta.array() / order).atan() * 2 / pi;  // 0 at the rim, 1 far from it
      const VectorXd round = pi / 2 - (pi / 2 - psi.array()) * turn;
      const VectorXd filled = (beta.array().square() + order * order).sqrt();
      auto s = minimise(smooth_, kink.L, smooth_.unknowns(kink.y[0], round, filled));
      if (s && order_at_rim(smooth_, *s) > smallest_order) return s;
    }
    return {};
  }

  void follow_down(const RimState& from) {
    auto start = with_tangent(smooth_, from);
    if (!start) return;
    if (start->slope() > 0) start->tangent *= -1;
    leg_ = axisym::follow(smooth_, *start, [this](const RimState& s) {
      return s.L < smallest_L || order_at_rim(smooth_, s) < smallest_order;
    });
    top_of_kinks_ = leg_.states.back().L;
    kinks_below_ = !leg_.fold && order_at_rim(smooth_, leg_.states.back()) < smallest_order;
  }

  RimProblem smooth_, kinks_;
  bool exist_ = false, kinks_below_ = false;
  double top_of_kinks_ = 0;
  Leg leg_;
};

// The sharp state of the smooth one's energy, at the largest L of those.
std::optional<RimRecord> meeting(const RimProblem& problem, const Leg& smooth,
                                 const SharpStates& sharp) {
  const auto gap = [&](double L) -> std::optional<double> {
    const auto a = smooth.at(problem, L);
    const auto b = sharp.at(L);
    if (!a || !b) return {};
    return expand(problem.at(L), a->y)->energy - b->energy;
  };
  constexpr int samples = 12;
  const double top = smooth.states.back().L;
  std::optional<double> above = gap(top);
  double high = top;
  for (int k = 1; k < samples && above && high > sharp.lowest(); ++k) {
    const double low = std::max(top * double(samples - k) / samples, sharp.lowest());
    const auto below = gap(low);
    if (below && *above * *below < 0) {
      bool known = true;
      const auto f = [&](double L) {
        const auto here = gap(L);
        known = known && here;
        return here.value_or(0);  // ends the search
      };
      const double L = model::root_between(f, low, high, 40).middle();
      return known ? sharp.at(L, RimKind::equal_energy) : std::nullopt;
    }
    above = below;
    high = low;
  }
  return {};
}

}  // namespace

std::vector<RimRecord> beyond_fold(const model::Material& material, double reduced_volume,
                                   std::span<const double> asked) {
  if (!(reduced_volume > 0.51 && reduced_volume < 1))
    throw std::invalid_argument("beyond_fold: reduced volume " + std::to_string(reduced_volume)
                                + ": must lie between 0.51 and 1");
  const RimProblem problem(material, reduced_volume, Rim::smooth, {});
  const Leg smooth = smooth_leg(problem);
  if (!smooth.fold) return {};
  std::vector<RimRecord> rows{record(RimKind::fold, problem, *smooth.fold)};
  rows[0].negative_directions = negative_directions(problem, smooth.before_fold());

  const Leg saddle = follow(problem, *smooth.beyond, [&](const RimState& s) {
    return s.L < smallest_L || order_at_rim(problem, s) < smallest_order;
  });
  for (const double L : asked)
    if (const auto s = saddle.at(problem, L)) rows.push_back(record(RimKind::saddle, problem, *s));

  const double L_fold = smooth.fold->L;
  const SharpStates sharp(problem, std::max(2 * L_fold, asked.empty() ? 0 : asked.back()), L_fold);
  if (sharp.fold()) {
    rows.push_back(record(RimKind::second_fold, problem, *sharp.fold()));
    rows.back().negative_directions = negative_directions(problem, sharp.before_fold());
  }
  for (const double L : asked)
    if (const auto row = sharp.at(L)) rows.push_back(*row);
  if (const auto row = meeting(problem, smooth, sharp)) rows.push_back(*row);
  return rows;
}

}  // namespace sbeh::axisym
