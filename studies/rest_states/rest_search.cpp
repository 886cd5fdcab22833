#include "studies/rest_states/rest_search.h"

#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/rest_states/descent.h"

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
        membrane_{input.material.with_L1(at_.L), input.model,
                  axisym::target_of(at_.reduced_volume)},
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
    take_({1, from == 0 ? RestPoint::first : RestPoint::step, from, found.state, found.mesh, {}});
    waiting_.push_back(found);
  }

  void look_around(const Found& from) {
    surface3d::NewtonSystem system(*from.mesh, membrane_.material, input_.model);
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
    const auto start = [&](double share) {
      return displaced(membrane_, {*from.mesh, from.state, from.state.normals}, mode,
                       share * side * input_.search->reach);
    };
    for (const double share : shares)
      if (!ended()) by_newton(from, from.mesh, start(share), known_);
    if (mode.eigenvalue < 0 && !ended()) by_flow(from, start(shares.front()));
  }

  static bool alike(double a, double b) {
    constexpr double apart = 1e-3;
    return std::abs(a - b) < apart * (1 + std::abs(a));
  }

  void by_newton(const Found& from, const Mesh& mesh, const State& start,
                 const surface3d::KnownStates& kept_away_from) {
    if (!surface3d::curvature_of(*mesh, start.X)) return;
    RestState there =
        rest_state_from(input_, at_, {mesh, start, {}, {}},
                        {.most_iterations = most_iterations, .far = far, .known = kept_away_from});
    if (!there.failure.empty() || is_there(there)) return;
    if (!resolved_by(*there.mesh, there.state.X)) {
      there = on_new_triangles(input_, at_, there);
      if (!there.failure.empty() || is_there(there)) return;
    }
    keep(there.mesh, solution(there.state, there.normals), from.number);
  }

  bool is_there(const RestState& found) const {
    return surface3d::is_known(known_, marks_of(*found.mesh, found.state));
  }

  // Down to where it is slow, from there by Newton's method.
  void by_flow(const Found& from, const State& start) {
    const Descent end = descend(membrane_, from.mesh, start);
    if (!interrupt_signal()) by_newton(from, end.mesh, end.state, {});
  }

  const StatesInput& input_;
  axisym::PlanePoint at_;
  Membrane membrane_;
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
