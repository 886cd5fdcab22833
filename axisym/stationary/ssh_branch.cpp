#include "axisym/stationary/ssh_branch.h"

#include "axisym/curvature.h"
#include "axisym/diagnostics.h"
#include "axisym/shape_class.h"
#include "axisym/stationary/arclength.h"
#include "axisym/stationary/limit_shape.h"
#include "axisym/stationary/stability.h"
#include "axisym/stationary/symmetry.h"
#include "model/numerics/root.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace sbeh::axisym {

using model::Model;

namespace {

constexpr double spacing = 1 / 20.;
constexpr int highest = 19;  // 0.95
constexpr int lowest = 6;    // 0.3: from here upwards all branches are there without H₀

double volume_at(int k) { return k / 20.; }
int below(double reduced_volume) {
  return std::clamp(int(std::floor(reduced_volume / spacing)), 1, highest);
}

// Of what closes the necks: where H₀ is more, no waypoint is worth the steps that so narrow a neck takes.
constexpr double dear = 0.95;

// A value of the map, computed where it is not there yet.
template <class Compute>
const std::optional<BranchState>& kept(std::map<int, std::optional<BranchState>>& in, int k,
                                       Compute&& compute) {
  if (const auto there = in.find(k); there != in.end()) return there->second;
  std::optional<BranchState> value = compute();
  return in.emplace(k, std::move(value)).first->second;
}

}  // namespace

SshBranch::SshBranch(Branch branch, const model::Material& material, const Numerics& numerics)
    : branch_(branch), material_(material), classical_material_(material), numerics_(numerics) {
  classical_material_.spontaneous_curvature = 0;
  classical_material_.flexoelectric = {};
  classical_material_.area_difference = {};
}

bool SshBranch::is_classical() const {
  return material_.preferred_curvature() == 0 && !material_.area_difference.is_there();
}

const std::optional<BranchState>& SshBranch::entry() {
  if (!entry_) {
    const auto found = enter_branch(branch_, classical_material_, numerics_);
    entry_ = found ? std::optional(found->state) : std::nullopt;
  }
  return *entry_;
}

FollowResult SshBranch::along(const BranchState& from, double reduced_volume) const {
  return follow(material_, Model::SSH, from, {reduced_volume, material_.L1}, numerics_);
}

FollowResult SshBranch::with_H0(const BranchState& classical) const {
  return follow(Line{.material = material_,
                     .model = Model::SSH,
                     .from = classical.at,
                     .to = classical.at,
                     .first_H0 = 0,
                     .first_W2 = diagnose(material_, classical).W2,  // where no moment acts
                     .first_coupling = 0,
                     .symmetric = branch_ != Branch::stomatocyte},
                classical, numerics_);
}

bool SshBranch::is_ours(const FollowResult& found) const {
  const std::string_view shape = name(classify(found.state.X));
  return found.arrival == Arrival::reached && shape == name(branch_);
}

bool SshBranch::is_better(const BranchState& a, const BranchState& b) const {
  const int falls_a = negative_directions(material_, Model::SSH, a),
            falls_b = negative_directions(material_, Model::SSH, b);
  const auto energy_of = [&](const BranchState& s) { return energy(material_, s, s.H).total(); };
  return falls_a != falls_b ? falls_a < falls_b : energy_of(a) < energy_of(b);
}

SshBranch::Waypoint SshBranch::better(const Waypoint& a, const FollowResult& b) const {
  if (!is_ours(b)) return a;
  return a && !is_better(b.state, *a) ? a : b.state;
}

const SshBranch::Waypoint& SshBranch::classical(int k) {
  return kept(classical_, k, [&]() -> Waypoint {
    const bool first = !entry() || volume_at(k + 1) > entry()->at.reduced_volume;
    const Waypoint& above = first ? entry() : classical(k + 1);
    if (!above || volume_at(k) > above->at.reduced_volume) return {};
    const FollowResult found =
        follow(classical_material_, Model::SSH, *above, {volume_at(k), material_.L1}, numerics_);
    return found.arrival == Arrival::reached ? Waypoint(found.state) : Waypoint{};
  });
}

const SshBranch::Waypoint& SshBranch::downward(int k) {
  return kept(downward_, k, [&] {
    Waypoint best;
    if (share_of_closing(volume_at(k)) > dear) return best;
    if (k < highest)
      if (const Waypoint& above = downward(k + 1)) best = better(best, along(*above, volume_at(k)));
    const Waypoint& there = classical(k);
    return there ? better(best, with_H0(*there)) : best;
  });
}

const SshBranch::Waypoint& SshBranch::waypoint(int k) {
  if (is_classical()) return classical(k);
  return kept(waypoints_, k, [&] {
    Waypoint best = downward(k);
    if (share_of_closing(volume_at(k)) > dear) return best;
    if (k > lowest)
      if (const Waypoint& below = best ? downward(k - 1) : waypoint(k - 1))
        best = better(best, along(*below, volume_at(k)));
    return best;
  });
}

std::optional<FollowResult> SshBranch::at(double reduced_volume) {
  if (!entry()) return {};
  const bool classical_only = is_classical();
  std::optional<FollowResult> best;
  const auto ends_nearer = [&](const FollowResult& a, const FollowResult& b) {
    return std::abs(a.state.at.reduced_volume - reduced_volume)
         < std::abs(b.state.at.reduced_volume - reduced_volume);
  };
  const auto is_preferred = [&](const FollowResult& a, const FollowResult& b) {
    if (is_ours(a) != is_ours(b)) return is_ours(a);
    if (is_ours(a)) return is_better(a.state, b.state);
    const bool a_lost = a.arrival == Arrival::lost, b_lost = b.arrival == Arrival::lost;
    return a_lost != b_lost ? b_lost : ends_nearer(a, b);
  };
  const auto offer = [&](const BranchState& from) {
    FollowResult found = along(from, reduced_volume);
    if (!best || is_preferred(found, *best)) best = std::move(found);
  };
  if (classical_only && reduced_volume > entry()->at.reduced_volume - spacing) {
    offer(*entry());
    return best;
  }
  // From the nearest above and, where one way may not reach it, below.
  for (int k = below(reduced_volume) + 1; k <= highest; ++k)
    if (const Waypoint& above = waypoint(k)) {
      offer(*above);
      break;
    }
  for (int k = below(reduced_volume);
       k >= (classical_only ? 1 : lowest) && !(classical_only && best); --k)
    if (const Waypoint& there = waypoint(k)) {
      offer(*there);
      break;
    }
  if (!best) best = end_towards_H0(reduced_volume);
  const double share = share_of_closing(reduced_volume);
  if (best && best->arrival == Arrival::neck && share > 0 && share < 1)
    if (const Waypoint& open = with_open_neck())
      if (FollowResult found = along(*open, reduced_volume); found.arrival != Arrival::neck)
        best = std::move(found);
  return best;
}

double SshBranch::share_of_closing(double reduced_volume) const {
  if (branch_ != Branch::stomatocyte) return 0;
  return material_.preferred_curvature() / closing_H0(sphere_in_sphere(reduced_volume));
}

const SshBranch::Waypoint& SshBranch::with_open_neck() {
  constexpr double share = 0.8;
  constexpr int first = 12;  // 0.6
  return kept(open_, 0, [&]() -> Waypoint {
    constexpr double highest_volume = 0.9999;
    Waypoint here = classical(first);
    if (!here || share_of_closing(volume_at(first)) < share
        || share_of_closing(highest_volume) > share)
      return {};
    const double last = model::root_between([&](double v) { return share_of_closing(v) - share; },
                                            volume_at(first), highest_volume)
                            .middle();
    double part = 0;  // of H₀ and f
    const auto go = [&](double v) {
      const double next = v == last ? 1 : share / share_of_closing(v);
      Line line{.material = material_,
                .model = Model::SSH,
                .from = here->at,
                .to = {v, material_.L1},
                .first_H0 = part * material_.spontaneous_curvature,
                .first_coupling = part / next};
      if (v != last) {
        line.material.spontaneous_curvature *= next;
        line.material.flexoelectric = material_.flexoelectric.times(next);
      }
      part = next;
      const FollowResult found = follow(line, *here, numerics_);
      here = found.arrival == Arrival::reached ? Waypoint(found.state) : Waypoint{};
    };
    for (int k = first; here && volume_at(k) < last; ++k) go(volume_at(k));
    if (here) go(last);
    return here;
  });
}

std::optional<FollowResult> SshBranch::end_towards_H0(double reduced_volume) {
  for (int k = below(reduced_volume); k >= 1; --k)
    if (const Waypoint& there = classical(k)) {
      FollowResult end = with_H0(*there);
      if (end.arrival == Arrival::reached) end = along(end.state, reduced_volume);
      if (end.arrival == Arrival::reached && !is_ours(end)) end.arrival = Arrival::lost;
      return end;
    }
  return {};
}

}  // namespace sbeh::axisym
