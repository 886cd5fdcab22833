#include "studies/evolution/relax.h"

#include "axisym/start_shapes.h"
#include "model/rest_order.h"
#include "studies/evolution/frame_file.h"
#include "studies/evolution/series_file.h"
#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/scan/scan_table.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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

// Writes what the observer sees at the times asked for.
class Recorder {
 public:
  Recorder(const RelaxInput& input, const RelaxStart& start, const OutputFolder& folder)
      : input_(input),
        material_(start.material),
        folder_(folder),
        series_(folder / "series.csv"),
        index_(folder / "profiles.csv"),
        terminal_(isatty(STDERR_FILENO) != 0) {
    make_folder(folder / "profiles");
    series_.append(header_of(series_columns()));
    index_.append(header_of(frame_columns()));
  }

  bool operator()(const axisym::FlowRecord& record, const State& state, bool exact) {
    if (input_.times.every_step || (exact && contains(input_.times.rows, record.time)))
      write_row(record, state);
    if (exact && contains(input_.times.states, record.time)) write_state(record, state);
    if (terminal_ && ++steps_ % 20 == 0)
      tell(fmt::format("\r\033[Kt = {:.4g} of {:.4g}, time step {:.2g}, energy {:.8g}", record.time,
                       input_.times.end, record.time_step, record.energy.total()));
    return interrupt_signal() == 0;
  }

  /// The last state, unless its time is there already.
  void finish(const axisym::FlowResult& run) {
    if (run.last.time != last_row_) write_row(run.last, run.state);
    if (run.last.time != last_profile_) write_state(run.last, run.state);
    if (terminal_ && steps_ >= 20) tell("\n");
  }
  int profiles() const { return profiles_; }

 private:
  void write_row(const axisym::FlowRecord& record, const State& state) {
    series_.append(series_line(record, axisym::diagnose(material_, state)));
    last_row_ = record.time;
  }
  void write_state(const axisym::FlowRecord& record, const State& state) {
    const std::string file = fmt::format("profiles/{:04d}.csv", profiles_);
    write_profile(folder_ / file, state);
    index_.append(line_of(frame_columns(), FrameEntry{record.time, file, profiles_++}));
    last_profile_ = record.time;
  }

  const RelaxInput& input_;
  model::Material material_;
  const OutputFolder& folder_;
  AppendFile series_, index_;
  bool terminal_;
  int profiles_ = 0, steps_ = 0;
  double last_row_ = -1, last_profile_ = -1;
};

}  // namespace

RelaxStart start_of(const RelaxInput& input) {
  RelaxStart start{.state = std::visit([&](const auto& s) { return make(s, input); }, input.start),
                   .target = {},
                   .material = input.material};
  start.target = {axisym::area(start.state.X), axisym::volume(start.state.X)};
  return start;
}

RelaxSummary run_relax(const RelaxInput& input, const std::filesystem::path& path,
                       std::string_view version) {
  const RelaxStart start = start_of(input);
  const OutputFolder folder(path);
  for (const char* result : {"run.toml", "series.csv", "scan.csv"})
    if (std::filesystem::exists(folder / result))
      throw OutputError(
          fmt::format("{}: already holds a run (see its {}), which is not overwritten; "
                      "choose another folder with -o or move it away",
                      path.string(), result));
  write_file(folder / "run.toml", describe(input, version));

  Recorder recorder(input, start, folder);
  axisym::Numerics numerics = input.numerics;
  numerics.elements = axisym::element_count(start.state.X);
  const axisym::FlowResult run = axisym::run_flow(
      start.material, input.model, start.state, start.target, numerics, schedule_of(input.times),
      [&](const auto& record, const State& state, bool exact) {
        return recorder(record, state, exact);
      });
  recorder.finish(run);
  return {run, recorder.profiles()};
}

}  // namespace sbeh::studies
