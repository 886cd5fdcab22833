#include "studies/rest_states/rest_search.h"

#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "surface3d/curvature.h"
#include "surface3d/flow.h"
#include "surface3d/lipids.h"
#include "surface3d/stationary/rest_ahead.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

namespace sbeh::studies {

using surface3d::Eigenmode;
using surface3d::PathSolution;
using surface3d::State;
using Mesh = std::shared_ptr<const surface3d::Triangulation>;

namespace {

constexpr int modes_of_each = 6;
constexpr std::array shares{0.25, 0.375, 0.5, 0.75, 1.};  // of the reach
constexpr int most_iterations = 40;
constexpr double far = 10;  // changes from which it still comes back now and then

// A state, from which others are looked for.
struct Found {
  int number;
  Mesh mesh;
  PathSolution state;
};

class Search {
 public:
  Search(const StatesInput& input, const std::function<int()>& number, const TakeState& take)
      : input_(input),
        at_(places_of(input).front().at),
        material_(input.material.with_L1(at_.L)),
        target_(axisym::target_of(at_.reduced_volume)),
        number_(number),
        take_(take) {}

  void run(const RestState& first) {
    keep(first.mesh, solution(first.state, first.normals), 0);
    while (!waiting_.empty() && !ended()) {
      const Found from = std::move(waiting_.front());
      waiting_.pop_front();
      look_around(from);
    }
  }

 private:
  static PathSolution solution(const surface3d::StationaryState& state,
                               const surface3d::Nodes& normals) {
    PathSolution found;
    static_cast<surface3d::StationaryState&>(found) = state;
    found.normals = normals;
    return found;
  }

  bool ended() const {
    return interrupt_signal() || int(known_.size()) >= input_.search->most_states;
  }

  void keep(const Mesh& mesh, PathSolution state, int from) {
    known_.push_back(marks_of(*mesh, state));
    const Found found{number_(), mesh, std::move(state)};
    take_({1, RestPoint::step, from, found.state, found.mesh, {}});
    waiting_.push_back(found);
  }

  void look_around(const Found& from) {
    surface3d::NewtonSystem system(*from.mesh, material_, input_.model);
    if (!system.linearise(from.state, from.state.normals)) return;
    const bool has_axis = system.rigid_count() < 6;
    const auto modes =
        surface3d::lowest_modes(system, from.state, from.state.normals, modes_of_each);
    if (!modes) return;
    for (std::size_t k = 0; k < modes->size(); ++k) {
      const Eigenmode& mode = (*modes)[k];
      // About an axis two of one m are one, turned.
      if (has_axis && k > 0 && alike(mode.eigenvalue, (*modes)[k - 1].eigenvalue)) continue;
      line_.show(fmt::format("{} states; around state {}: mode {} of {}", known_.size(),
                             from.number, k + 1, modes->size()));
      for (const double side : {1., -1.}) look_along(from, mode, side);
    }
  }

  void look_along(const Found& from, const Eigenmode& mode, double side) {
    for (const double share : shares)
      if (!ended()) by_newton(from, from.mesh, displaced(from, mode, share * side), known_);
    if (mode.eigenvalue < 0 && !ended())
      by_flow(from, displaced(from, mode, shares.front() * side));
  }

  static bool alike(double a, double b) {
    constexpr double apart = 1e-3;
    return std::abs(a - b) < apart * (1 + std::abs(a));
  }

  State displaced(const Found& from, const Eigenmode& mode, double share) const {
    const double largest = std::max(mode.u.cwiseAbs().maxCoeff(), mode.b.cwiseAbs().maxCoeff()),
                 scale = share * input_.search->reach / largest;
    State start = from.state;
    start.X += from.state.normals * (scale * mode.u).asDiagonal();
    start.beta += scale * mode.b;
    surface3d::correct_lipids_volume(*from.mesh, effective(material_, input_.model), from.state.H,
                                     target_, start);
    return start;
  }

  void by_newton(const Found& from, const Mesh& mesh, const State& start,
                 const surface3d::KnownStates& kept_away_from) {
    if (!surface3d::curvature_of(*mesh, start.X)) return;
    surface3d::NewtonSystem system(*mesh, material_, input_.model);
    const auto found = surface3d::solve_stationary(
        system, target_, surface3d::guess_from(*mesh, material_, input_.model, start),
        {.most_iterations = most_iterations, .far = far, .known = kept_away_from});
    if (found.status != surface3d::NewtonStatus::converged || is_there(*mesh, found.state)) return;
    if (resolved_by(*mesh, found.state.X)) {
      keep(mesh, solution(found.state, found.normals), from.number);
      return;
    }
    const RestState there =
        rest_state_from(input_, at_, remeshed_start(*mesh, found.state, material_, mesh->count()));
    if (there.failure.empty() && !is_there(*there.mesh, there.state))
      keep(there.mesh, solution(there.state, there.normals), from.number);
  }

  bool is_there(const surface3d::Triangulation& mesh,
                const surface3d::StationaryState& state) const {
    return surface3d::is_known(known_, marks_of(mesh, state));
  }

  // Down to where it is slow, from there by Newton's method.
  void by_flow(const Found& from, const State& start) {
    constexpr double longest = 200;
    const surface3d::FlowMoment begin{from.mesh, start, target_};
    surface3d::Numerics numerics;
    numerics.remesh = true;
    surface3d::RestWatch rest(material_, input_.model, target_);
    Mesh mesh = from.mesh;
    State last = start;
    surface3d::run_flow(material_, input_.model, begin, numerics, {.end_time = longest},
                        [&](const auto& record, const State& state, const auto& view, bool) {
                          mesh = view.mesh;
                          last = state;
                          return !interrupt_signal() && !rest.near(record, *mesh, state);
                        });
    if (!interrupt_signal()) by_newton(from, mesh, last, {});
  }

  const StatesInput& input_;
  axisym::PlanePoint at_;
  model::Material material_;
  surface3d::Target target_;
  const std::function<int()>& number_;
  const TakeState& take_;
  surface3d::KnownStates known_{};
  std::deque<Found> waiting_{};
  ProgressLine line_{};
};

}  // namespace

void search_states(const StatesInput& input, const RestState& first,
                   const std::function<int()>& number, const TakeState& take) {
  Search(input, number, take).run(first);
}

}  // namespace sbeh::studies
