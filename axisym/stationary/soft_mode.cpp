#include "axisym/stationary/soft_mode.h"

#include <cmath>
#include <numbers>

namespace sbeh::axisym {

namespace {

// A motion that is odd about the equator and no translation: cos 3πs along the curve.
Increment antisymmetric_seed(Eigen::Index nodes) {
  Increment seed;
  seed.d.resize(nodes);
  for (Eigen::Index i = 0; i < nodes; ++i)
    seed.d[i] = std::cos(3 * std::numbers::pi * double(i) / double(nodes - 1));
  seed.Lambda = seed.H = seed.beta = Field::Zero(nodes);
  return seed;
}

double product(const Field& areas, const Increment& a, const Increment& b) {
  return areas.dot(a.d.cwiseProduct(b.d) + a.beta.cwiseProduct(b.beta));
}

}  // namespace

std::optional<SoftMode> antisymmetric_mode(const model::Material& material, model::Model model,
                                           const StationaryState& state) {
  const Eigen::Index nodes = state.beta.size();
  NewtonSystem system(material, model, {element_count(state.X), false});
  if (!system.linearise(state)) return {};
  const Field areas = node_areas(state.X);
  Increment x = antisymmetric_seed(nodes);
  double eigenvalue = 0;
  for (int iteration = 0; iteration < 40; ++iteration) {
    x = scaled(x, 1 / std::sqrt(product(areas, x, x)));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(node_unknowns * nodes);
    for (Eigen::Index i = 0; i < nodes; ++i) {
      load[index(i, node_d)] = areas[i] * x.d[i];
      load[index(i, node_beta)] = areas[i] * x.beta[i];
    }
    Increment next;
    if (!system.tangent(-load, 0, 0, next)) return {};
    next.mu = 0;
    const double estimate = 1 / product(areas, x, next);
    x = next;
    if (std::abs(estimate - eigenvalue) <= 1e-9 * std::abs(estimate) + 1e-12) {
      x = scaled(x, 1 / std::sqrt(product(areas, x, x)));
      return SoftMode{estimate, x};
    }
    eigenvalue = estimate;
  }
  return {};
}

PathState along_mode(const LineState& state, const SoftMode& mode) {
  const Field weights = weights_of(state);
  return {state, scaled(mode.direction, 1 / length_of(mode.direction, weights)), weights, 0};
}

}  // namespace sbeh::axisym
