#include "surface3d/stationary/rest_ahead.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::surface3d {

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

}  // namespace sbeh::surface3d
