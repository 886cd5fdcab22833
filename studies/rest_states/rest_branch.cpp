#include "studies/rest_states/rest_branch.h"

#include "axisym/stationary/stationary_case.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/rest_states/rest_state.h"
#include "surface3d/mesh/remesh.h"
#include "surface3d/symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace sbeh::studies {

using surface3d::Eigenmode;
using surface3d::Path;
using surface3d::PathPoint;
using Mesh = std::shared_ptr<const surface3d::Triangulation>;

namespace {

constexpr double shortest = 2e-4,
                 begins = 0.03;  // steps, in the length of surface3d/stationary/path.h
// A first step of so many amplitudes does not fall back to the branch that is left.
constexpr double growth = 10;
constexpr std::size_t most_paths = 12;
constexpr int most_refined = 5;  // fewer than so many times the triangles of the first state

// A path that is still to be followed.
struct Begin {
  PathPoint first;
  Mesh mesh;
  meshing::PointGroup symmetry;  // of the triangles
  int from;                      // the branching point's row
  double step;                   // the first
};

model::Material material_of(const StatesInput& input) {
  return input.material.with_L1(input.L.front());
}

class Branches {
 public:
  Branches(const StatesInput& input, Mesh mesh, const std::function<int()>& number,
           const TakeState& take)
      : input_(input),
        number_(number),
        take_(take),
        mesh_(std::move(mesh)),
        symmetry_(input.symmetry),
        fewest_(mesh_->count()),
        path_(path_on(*mesh_)) {}

  std::string run(const surface3d::StationaryState& start) {
    const auto first = settled(path_, start, 0);
    if (!first) return "there is no branch through the first state: a fold is there";
    waiting_.push_back({*first, mesh_, symmetry_, 0, input_.follow->longest_step});
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
    return take_({count_, kind, from_, point, mesh_, path_.system}).empty() && !interrupt_signal();
  }

  void follow(const Begin& begin) {
    from_ = begin.from;
    use(begin.mesh, begin.symmetry);
    PathPoint at = begin.first;
    if (from_ > 0 && !resolved_by(*mesh_, at.X)) renew(at, mesh_->count());  // what is left was
    int triangles = mesh_->count();                                          // of the next ones
    if (!take(RestPoint::first, at)) return;
    const double longest = input_.follow->longest_step;
    double ds = std::min(longest, begin.step);
    for (int states = 1; states < input_.follow->most_states && !interrupt_signal();) {
      const auto next = advance(path_, at, ds, shortest);
      if (triangles < (next ? most_refined : 2) * fewest_ && !(next && resolved_by(*mesh_, next->X))
          && renew(at, triangles)) {
        if (!take(RestPoint::renewed, at)) return;
        triangles = 2 * mesh_->count();
        ds = std::min(longest, begins);
        continue;
      }
      if (!next) return;
      const Between between = what_is_between(at, *next, ds);
      if (!between.is_clear && ds > 2 * shortest) {  // two in one step
        ds /= 2;
        continue;
      }
      if (!take_between(between)) return;
      if (next->mu > 1 || next->mu < 0) {
        if (const auto end = settled(path_, *next, next->mu > 1 ? 1 : 0, next->phase))
          take(RestPoint::last, *end);
        return;
      }
      if (!take(RestPoint::step, *next)) return;
      if (next->negative_directions > input_.follow->most_negative) return;
      ++states;
      triangles = mesh_->count();
      at.before.reset();
      const auto before = std::make_shared<const PathPoint>(std::move(at));
      at = *next;
      at.before = before;
      ds = std::min(1.5 * ds, longest);
    }
  }

  Path path_on(const surface3d::Triangulation& mesh) const {
    const StatesInput& input = input_;
    return {mesh, input.model, [&input](double mu) { return material_of(input_on_way(input, mu)); },
            [&input](double mu) {
              return axisym::target_of(input_on_way(input, mu).reduced_volume.front());
            }};
  }
  void use(const Mesh& mesh, const meshing::PointGroup& symmetry) {
    if (mesh == mesh_) return;
    path_ = path_on(*mesh);
    mesh_ = mesh;
    symmetry_ = symmetry;
  }

  // New triangles for a state, about so many, or up to twice as many where Newton's method does not find it on these; false where there
  // are none that resolve it.
  bool renew(PathPoint& at, int triangles) {
    const meshing::PointGroup symmetry =
        kept_symmetry(*mesh_, at, symmetry_);  // the rest it has left
    for (const double more : {1., 1.25, 1.5, 2.}) {
      const auto made = surface3d::remesh(
          *mesh_, at, path_.material(at.mu),
          {.triangles = int(more * triangles), .largest_energy_change = 1, .symmetry = symmetry});
      if (!made.mesh) continue;
      const auto there = on_other_triangles(path_on(*made.mesh), made.state, at, begins);
      if (!there || !resolved_by(*made.mesh, there->X)) continue;
      at = *there;
      use(made.mesh, symmetry);
      return true;
    }
    return false;
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
      between.joins = has_axis(fold) && !has_axis(at);
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

  bool has_axis(const PathPoint& p) {
    return rigid_motions(path_.system->layout(), p, p.normals).loads.cols() < 6;
  }

  // Two modes alike are one, turned. Of one mode both sides are different states, unless a symmetry makes them alike.
  void leave(const surface3d::BranchingPoint& at, int row) {
    constexpr double alike = 1e-6;
    std::optional<double> other;
    for (const double side : {1., -1.}) {
      if (count_ + int(waiting_.size()) >= int(most_paths)) return;
      for (const double amplitude : {begins, begins / 3, begins / 10, begins / 30, begins / 100}) {
        const auto first = switched(path_, at, side * amplitude);
        if (!first) continue;
        if (other && std::abs(*other - first->mu) < alike) break;
        waiting_.push_back({*first, mesh_, symmetry_, row, std::min(begins, growth * amplitude)});
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
  Mesh mesh_;
  meshing::PointGroup symmetry_;  // of its triangles
  int fewest_;                    // triangles
  Path path_;
  std::deque<Begin> waiting_;
  int count_ = 0, from_ = 0;
};

}  // namespace

double value_on_way(const StatesInput& input, double mu) {
  const double first = value_of(input, input.follow->parameter);
  return first + mu * (input.follow->to - first);
}

StatesInput input_on_way(const StatesInput& input, double mu) {
  if (!input.follow) return input;
  return at_value(input, input.follow->parameter, value_on_way(input, mu));
}

std::string follow_branches(const StatesInput& input, Mesh mesh,
                            const surface3d::StationaryState& start,
                            const std::function<int()>& number, const TakeState& take) {
  return Branches(input, std::move(mesh), number, take).run(start);
}

}  // namespace sbeh::studies
