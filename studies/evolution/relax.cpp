#include "studies/evolution/relax.h"

#include "axisym/shape_class.h"
#include "axisym/start_shapes.h"
#include "model/order_step.h"
#include "studies/evolution/evolution_files.h"
#include "studies/evolution/flow_progress.h"
#include "studies/io/description.h"
#include "studies/io/interrupt.h"
#include "studies/states/profile_file.h"
#include "studies/states/revolved_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sbeh::studies {

namespace {

axisym::Nodes spheroid(const Ellipsoid& shape, const axisym::Numerics& n) {
  if (shape.reduced_volume)
    return axisym::spheroid(*shape.reduced_volume, shape.prolate, n.elements, n.grading);
  const double equatorial = shape.axes[0], polar = shape.axes[1];
  const double longest = std::max(equatorial, polar);
  return axisym::spheroid(equatorial / longest, polar / longest, n.elements, n.grading);
}

axisym::State make(const Ellipsoid& shape, const RelaxInput& input) {
  const axisym::Nodes X = spheroid(shape, input.numerics);
  return {X, axisym::Field::Constant(X.cols(), input.initial_order)};
}

axisym::Nodes harmonic_sphere(const Harmonics& sphere, const axisym::Numerics& n) {
  try {
    if (sphere.reduced_volume)
      return axisym::harmonic_sphere(sphere.shape, *sphere.reduced_volume, n.elements, n.grading);
    return axisym::harmonic_sphere(sphere.shape, n.elements, n.grading);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[start] modes: {}", error.what()));
  }
}

axisym::State make(const Harmonics& sphere, const RelaxInput& input) {
  axisym::State state{harmonic_sphere(sphere, input.numerics), {}};
  double order = model::full_order;
  if (model::has_free_order(input.model)) {
    const auto rest = sphere.order ? sphere.order : model::sphere_rest_order(input.material);
    if (!rest)
      throw std::invalid_argument(
          "[start] order: no ordered state rests on the sphere with this "
          "material; give the order");
    order = *rest;
  }
  state.beta.resize(state.X.cols());
  for (Eigen::Index i = 0; i < state.beta.size(); ++i) {
    const double theta = std::atan2(state.X(0, i), state.X(1, i));
    state.beta[i] = order + axisym::zonal_sum(sphere.order_modes, theta);
    if (!(std::abs(state.beta[i]) <= 1))
      throw std::invalid_argument(fmt::format(
          "[start] order_modes: the order is {:.3g} at theta = {:.3g}: must be in -1 ... 1",
          state.beta[i], theta));
  }
  return state;
}

axisym::State make(const ScanRow& row, const RelaxInput&) { return state_of(row); }

// Domains, and the mean of a conserved order.
void complete_order(const RelaxInput& input, axisym::State& state) {
  try {
    complete_order(input.material, input.order_pattern, state);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[start] {}", error.what()));
  }
}

// What the input asks for, perturbed.
axisym::State made(const RelaxInput& input) {
  axisym::State state =
      std::visit([&](const auto& start) { return make(start, input); }, input.start);
  if (model::has_free_order(input.model) && !std::holds_alternative<ScanRow>(input.start))
    complete_order(input, state);
  if (axisym::crosses_itself(state.X))
    throw std::invalid_argument("[start] the surface passes through itself");
  if (input.perturbation.empty()) return state;
  try {
    state.X = axisym::perturbed(state.X, input.perturbation);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        fmt::format("[start] perturbation: is too large: {}", error.what()));
  }
  return state;
}

// A run.toml alone is no run yet, where it is that of this one.
void refuse_other_results(const OutputFolder& folder, const std::string& description) {
  refuse_results(folder, {"series.csv", "scan.csv"});
  const auto there = folder / "run.toml";
  if (exists(there) && !studies::mismatch(read_file(there), description, "").empty())
    refuse_results(folder, {"run.toml"});
}

}  // namespace

RelaxStart start_of(const RelaxInput& input) {
  const axisym::State brought = made(input);
  RelaxStart start{.state = brought, .remarks = {}};
  if (!model::has_free_order(input.model)) start.state.beta.setConstant(model::full_order);
  if (const auto origin = origin_of_any(input.start)) {
    const auto energies = [&]() -> StartEnergies {
      return {axisym::diagnose(origin->physics->material, brought).energy.total(),
              axisym::diagnose(input.material, start.state).energy.total()};
    };
    if (const auto remark = remark_on(*origin, input, energies)) start.remarks.push_back(*remark);
  }
  return start;
}

double seconds_per_step(const RelaxInput& input) {
  constexpr double of_an_element = 3.8e-5;
  return of_an_element * input.numerics.elements;
}

RelaxSummary run_relax(const RelaxInput& input, const std::filesystem::path& path,
                       std::string_view version) {
  const auto [start, remarks] = start_of(input);
  const OutputFolder folder(path);
  const std::string description = describe(input, version);
  refuse_other_results(folder, description);
  write_file(folder / "run.toml", with_remarks(description, remarks));
  for (const std::string& remark : remarks) tell(fmt::format("sbeh: {}\n", remark));

  SeriesWriter series(folder, input.times);
  StateFiles profiles(folder, "profiles", ".csv", input.times.states);
  BriefProgress progress(input.times.end);
  axisym::Numerics numerics = input.numerics;
  numerics.elements = axisym::element_count(start.X);
  const axisym::FlowResult run = axisym::run_flow(
      input.material, input.model, start, {axisym::area(start.X), axisym::volume(start.X)},
      numerics, schedule_of(input.times),
      [&](const axisym::FlowRecord& record, const axisym::State& state, bool exact) {
        series.see(record, exact, [&] { return axisym::diagnose(input.material, state); });
        profiles.see(record.time, exact, [&](const auto& file) { write_profile(file, state); });
        progress.see(record);
        return interrupt_signal() == 0;
      });
  series.finish(run.last, [&] { return axisym::diagnose(input.material, run.state); });
  profiles.finish(run.last.time, [&](const auto& file) { write_profile(file, run.state); });
  progress.finish();
  return {run, int(profiles.entries().size())};
}

}  // namespace sbeh::studies
