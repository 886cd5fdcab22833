#include "studies/rest_states/rest_branch.h"

#include "axisym/stationary/stationary_case.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace sbeh::studies {

using surface3d::Eigenmode;
using surface3d::Path;
using surface3d::PathPoint;

namespace {

constexpr double shortest = 1e-3,
                 begins = 0.03;  // steps, in the length of surface3d/stationary/path.h
constexpr std::size_t most_paths = 12;

// A path that is still to be followed.
struct Begin {
  PathPoint first;
  int from;  // the branching point's row
};

class Branches {
 public:
  Branches(const StatesInput& input, const surface3d::Triangulation& mesh,
           const std::function<int()>& number, const TakeState& take)
      : input_(input),
        number_(number),
        take_(take),
        path_(
            mesh, input.model,
            [&input](double mu) { return input.material.with_L(place_on_way(input, mu).L); },
            [&input](double mu) {
              return axisym::target_of(place_on_way(input, mu).reduced_volume);
            }) {}

  std::string run(const surface3d::StationaryState& start) {
    const auto first = settled(path_, start, 0);
    if (!first) return "there is no branch through the first state: a fold is there";
    waiting_.push_back({*first, 0});
    while (!waiting_.empty() && !interrupt_signal()) {
      const Begin begin = waiting_.front();
      waiting_.pop_front();
      ++count_;
      follow(begin);
    }
    return {};
  }

 private:
  bool take(RestPoint kind, const PathPoint& point) {
    return take_({count_, kind, from_, point}).empty() && !interrupt_signal();
  }

  void follow(const Begin& begin) {
    from_ = begin.from;
    PathPoint at = begin.first;
    if (!take(RestPoint::first, at)) return;
    const double longest = input_.follow->longest_step;
    double ds = std::min(longest, begin.from == 0 ? 1. : begins);
    for (int states = 1; states < input_.follow->most_states && !interrupt_signal();) {
      const auto next = advance(path_, at, ds, shortest);
      if (!next) return;
      const Between between = what_is_between(at, *next, ds);
      if (!between.is_clear && ds > 2 * shortest) {  // two in one step
        ds /= 2;
        continue;
      }
      if (!take_between(between)) return;
      if (next->mu > 1 || next->mu < 0) {
        if (const auto end = settled(path_, *next, next->mu > 1 ? 1 : 0))
          take(RestPoint::last, *end);
        return;
      }
      if (!take(RestPoint::step, *next)) return;
      ++states;
      at = *next;
      ds = std::min(1.5 * ds, longest);
    }
  }

  // What a step has gone past, in its range.
  struct Between {
    std::optional<PathPoint> fold;
    bool joins = false;  // the fold is a state with an axis
    std::optional<surface3d::BranchingPoint> branching;
    bool is_clear = true;  // all changes of negative directions are accounted for
  };

  Between what_is_between(const PathPoint& at, const PathPoint& next, double ds) {
    const auto in_range = [](const PathPoint& p) { return p.mu >= 0 && p.mu <= 1; };
    const int change = std::abs(at.negative_directions - next.negative_directions);
    Between between;
    if (at.slope() * next.slope() < 0) {
      const PathPoint fold = locate_fold(path_, at, next, ds);
      // The other half of what has left a state with an axis is the same once more, turned.
      between.joins = rigid_count(fold) < 6 && rigid_count(at) == 6;
      between.is_clear = between.joins || change == 1;
      if (in_range(fold)) between.fold = fold;
    } else if (change > 0) {
      const auto found = locate_branching(path_, at, next, ds);
      between.is_clear = found && change <= 2;
      if (found && in_range(found->at)) between.branching = found;
    }
    return between;
  }

  // False where the path ends there.
  bool take_between(const Between& between) {
    if (between.fold && between.joins) return take(RestPoint::joins, *between.fold), false;
    if (between.fold) return take(RestPoint::fold, *between.fold);
    if (!between.branching) return true;
    const int row = number_();
    if (!take(RestPoint::branching, between.branching->at)) return false;
    if (input_.follow->switches) leave(*between.branching, row);
    return true;
  }

  int rigid_count(const PathPoint& p) {
    path_.system->set_material(path_.material(p.mu));
    path_.system->linearise(p, p.normals);
    return path_.system->rigid_count();
  }

  // Two modes alike are one, turned. Of one mode both sides are different states, unless a symmetry makes them alike.
  void leave(const surface3d::BranchingPoint& at, int row) {
    constexpr double alike = 1e-6;
    std::optional<double> other;
    for (const double side : {1., -1.}) {
      if (count_ + int(waiting_.size()) >= int(most_paths)) return;
      for (const double amplitude : {begins, begins / 3, 2 * begins, begins / 10}) {
        const auto first = switched(path_, at.at, at.modes.front(), side * amplitude);
        if (!first) continue;
        if (other && std::abs(*other - first->mu) < alike) break;
        waiting_.push_back({*first, row});
        other = first->mu;
        break;
      }
      if (at.modes.size() > 1) break;
    }
    if (!other)
      tell(
          fmt::format("sbeh: number {}: no state is found on the branch that leaves there\n", row));
  }

  const StatesInput& input_;
  const std::function<int()>& number_;
  const TakeState& take_;
  Path path_;
  std::deque<Begin> waiting_;
  int count_ = 0, from_ = 0;
};

}  // namespace

axisym::PlanePoint place_on_way(const StatesInput& input, double mu) {
  axisym::PlanePoint at{input.reduced_volume.front(), input.L.front()};
  double& moves = input.follow->parameter == FollowedParameter::L ? at.L : at.reduced_volume;
  moves += mu * (input.follow->to - moves);
  return at;
}

std::string follow_branches(const StatesInput& input, const surface3d::Triangulation& mesh,
                            const surface3d::StationaryState& start,
                            const std::function<int()>& number, const TakeState& take) {
  return Branches(input, mesh, number, take).run(start);
}

}  // namespace sbeh::studies
