#include "studies/evolution/relax_start.h"

#include "axisym/start_shapes.h"
#include "model/order_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

using axisym::State;

namespace {

std::vector<axisym::Mode> modes_of(const std::vector<std::pair<int, double>>& pairs) {
  std::vector<axisym::Mode> modes;
  modes.reserve(pairs.size());
  for (const auto& [l, amplitude] : pairs) modes.push_back({l, amplitude});
  return modes;
}

axisym::Nodes spheroid(const Ellipsoid& shape, const axisym::Numerics& n) {
  if (shape.reduced_volume)
    return axisym::spheroid(*shape.reduced_volume, shape.prolate, n.elements, n.grading);
  const double equatorial = shape.axes[0], polar = shape.axes[1];
  const double longest = std::max(equatorial, polar);
  return axisym::spheroid(equatorial / longest, polar / longest, n.elements, n.grading);
}

State make(const Ellipsoid& shape, const RelaxInput& input) {
  const axisym::Nodes X = spheroid(shape, input.numerics);
  return {X, axisym::Field::Constant(X.cols(), input.initial_order)};
}

axisym::Nodes harmonic_sphere(const Harmonics& sphere, const axisym::Numerics& n) {
  try {
    return axisym::harmonic_sphere(modes_of(sphere.shape), n.elements, n.grading);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[start] modes: {}", error.what()));
  }
}

State make(const Harmonics& sphere, const RelaxInput& input) {
  State state{harmonic_sphere(sphere, input.numerics), {}};
  double order = model::full_order;
  if (model::has_free_order(input.model)) {
    const auto rest = sphere.order ? sphere.order : model::sphere_rest_order(input.material);
    if (!rest)
      throw std::invalid_argument(
          "[start] order: no ordered state rests on the sphere with this "
          "material; give the order");
    order = *rest;
  }
  const auto order_modes = modes_of(sphere.order_modes);
  state.beta.resize(state.X.cols());
  for (Eigen::Index i = 0; i < state.beta.size(); ++i) {
    const double theta = std::atan2(state.X(0, i), state.X(1, i));
    state.beta[i] = order + axisym::zonal_sum(order_modes, theta);
    if (!(std::abs(state.beta[i]) <= 1))
      throw std::invalid_argument(fmt::format(
          "[start] order_modes: the order is {:.3g} at theta = {:.3g}: must be in -1 ... 1",
          state.beta[i], theta));
  }
  return state;
}

State make(const ScanRow& row, const RelaxInput& input) {
  State state = state_of(row);
  if (!model::has_free_order(input.model)) state.beta.setConstant(model::full_order);
  return state;
}

}  // namespace

RelaxStart start_of(const RelaxInput& input) {
  RelaxStart start{.state = std::visit([&](const auto& s) { return make(s, input); }, input.start),
                   .target = {},
                   .material = input.material};
  start.target = {axisym::area(start.state.X), axisym::volume(start.state.X)};
  return start;
}

}  // namespace sbeh::studies
