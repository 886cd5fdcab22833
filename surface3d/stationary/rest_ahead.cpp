#include "surface3d/stationary/rest_ahead.h"

#include "model/relaxation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace sbeh::surface3d {

namespace {

// Of a run that begins it is not known.
double speed(const model::FlowRecord& record) {
  return record.time_step == 0 ? std::numeric_limits<double>::infinity() : record.speed();
}

}  // namespace

bool rest_is_ahead(const Triangulation& mesh, const model::Material& material, model::Model model,
                   const State& state, const Target& target) {
  constexpr double near = 0.1, rounding = 1e-10;
  if (is_sphere(mesh, target.area, target.volume)) return false;
  NewtonSystem system(mesh, material, model);
  const StationaryState guess = guess_from(mesh, material, model, state);
  const NewtonResult found =
      solve_stationary(system, target, guess, {.most_iterations = 8, .far = 10 * near});
  if (found.status != NewtonStatus::converged || found.negative_directions > 0) return false;
  const double radius = std::sqrt(target.area / (4 * std::numbers::pi));
  const double moved = (found.state.X - state.X).colwise().norm().maxCoeff() / radius,
               changed = (found.state.beta - state.beta).cwiseAbs().maxCoeff();
  const model::Energy before = energy(material, mesh, guess),
                      after = energy(material, mesh, found.state);
  return std::max(moved, changed) <= near
      && after.total() <= before.total() + rounding * before.magnitude();
}

RestWatch::RestWatch(const model::Material& material, model::Model model, const Target& target,
                     const model::FlowRecord& start)
    : material_(material),
      model_(model),
      target_(target),
      unit_(model::speed_at_rest(1, material, model)),
      before_(speed(start)) {}

bool RestWatch::near(const model::FlowRecord& record, const Triangulation& mesh,
                     const State& state) {
  constexpr std::array tries{1e-2, 1e-3, 1e-4};
  const double before = std::exchange(before_, speed(record));
  return std::ranges::any_of(tries,
                             [&](double t) { return before_ < t * unit_ && t * unit_ <= before; })
      && rest_is_ahead(mesh, material_, model_, state, target_);
}

}  // namespace sbeh::surface3d
