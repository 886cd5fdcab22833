#include "studies/witnesses/evolution.h"

#include "meshing/spherical_harmonics.h"
#include "model/numerics/root.h"
#include "studies/evolution/flow_progress.h"
#include "studies/evolution/run_start.h"
#include "studies/io/interrupt.h"
#include "studies/states/series_file.h"
#include "surface3d/harmonic/flow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::studies {

using meshing::harmonic_sum;
using surface3d::HarmonicMechanics;
using surface3d::HarmonicMembrane;

namespace {

constexpr double unit_area = 4 * std::numbers::pi;
constexpr int coarser = 2;  // degrees less, to see what the degree does

Measures measures_of_row(const SeriesRow& row) {
  return measures_of(row.record.energy, row, -row.record.lambda);
}

// ---- the start of harmonics ---------------------------------------------------------------------

Eigen::Matrix3Xd star(const HarmonicMechanics& mechanics, const HarmonicSphere& sphere,
                      double factor) {
  Eigen::Matrix3Xd x = mechanics.points();
  for (auto point : x.colwise()) point *= 1 + factor * harmonic_sum(sphere.modes, point);
  return x;
}

double reduced_volume(const HarmonicMechanics& mechanics, const HarmonicMembrane& membrane) {
  const auto measures = mechanics.measure(membrane);
  if (!measures) throw std::invalid_argument("the surface of the harmonics is degenerate");
  return surface3d::reduced_volume(measures->area, measures->volume);
}

Eigen::Matrix3Xd points_of(const HarmonicMechanics& mechanics, const HarmonicSphere& sphere) {
  if (!sphere.reduced_volume) return star(mechanics, sphere, 1);
  double deepest = 0;
  for (const auto point : mechanics.points().colwise())
    deepest = std::min(deepest, harmonic_sum(sphere.modes, point));
  const auto excess = [&](double factor) {
    const Eigen::Matrix3Xd x = star(mechanics, sphere, factor);
    return reduced_volume(mechanics, mechanics.through(x, Eigen::VectorXd::Zero(x.cols())))
         - *sphere.reduced_volume;
  };
  constexpr double least = 1e-6, nearly_all = 0.999;
  const double most = -nearly_all / deepest;
  if (!(excess(least) > 0 && excess(most) < 0))
    throw std::invalid_argument(fmt::format("reduced_volume = {}: no factor of the modes gives it",
                                            *sphere.reduced_volume));
  return star(mechanics, sphere, model::root_between(excess, least, most).middle());
}

Eigen::Matrix3Xd points_of(const HarmonicMechanics& mechanics, const Ellipsoid& ellipsoid) {
  const Eigen::Vector3d axes =
      ellipsoid.reduced_volume == 1 ? Eigen::Vector3d::Ones()
      : ellipsoid.reduced_volume
          ? surface3d::harmonic_spheroid(*ellipsoid.reduced_volume, ellipsoid.prolate, 4)
                .ellipsoid.diagonal()
          : Eigen::Vector3d(ellipsoid.axes.data());
  return axes.asDiagonal() * mechanics.points();
}

HarmonicMembrane start_of(const RunInput& run, const HarmonicMechanics& mechanics) {
  const auto* sphere = std::get_if<HarmonicSphere>(&run.start);
  const Eigen::Matrix3Xd x =
      sphere ? points_of(mechanics, *sphere) : points_of(mechanics, std::get<Ellipsoid>(run.start));
  const double order = has_free_order(run.model) ? run.initial_order : model::full_order;
  HarmonicMembrane membrane = mechanics.through(x, Eigen::VectorXd::Constant(x.cols(), order));
  const auto measures = mechanics.measure(membrane);
  if (!measures) throw std::invalid_argument("the surface of the harmonics is degenerate");
  membrane.X *= std::sqrt(unit_area / measures->area);
  return membrane;
}

// ---- the flow of harmonics ----------------------------------------------------------------------

struct HarmonicEvolution {
  surface3d::HarmonicFlowStop stop{};
  std::vector<EnergyAt> history{};
  surface3d::HarmonicMoment last{};
  double imbalance = 0;  // of the energy, largest
};

HarmonicEvolution flow(const RunInput& run, const HarmonicFlowMethod& method, int degree) {
  const HarmonicMechanics mechanics(run.material, run.model, degree);
  surface3d::HarmonicSchedule schedule{.times = {}, .tolerance = method.tolerance};
  std::ranges::copy_if(run.times.rows, std::back_inserter(schedule.times),
                       [](double time) { return time > 0; });
  BriefProgress progress(run.times.end, fmt::format("harmonics l <= {}: ", degree));
  schedule.goes_on = [&](double time) {
    model::FlowRecord record;
    record.time = time;
    progress.see(record);
    return interrupt_signal() == 0;
  };
  HarmonicEvolution evolution;
  evolution.stop = flow_harmonics(
      mechanics, start_of(run, mechanics), schedule, [&](const surface3d::HarmonicMoment& at) {
        evolution.history.push_back({at.time, at.measures.energy.total()});
        evolution.imbalance = std::max(
            evolution.imbalance, std::abs(at.energy_before - evolution.history.front().energy));
        evolution.last = at;
      });
  if (evolution.stop == surface3d::HarmonicFlowStop::interrupted) throw Interrupted("interrupted");
  return evolution;
}

}  // namespace

std::string no_harmonic_flow(const RunInput& run) {
  if (!std::holds_alternative<HarmonicSphere>(run.start)
      && !std::holds_alternative<Ellipsoid>(run.start))
    return "its start is no shape = \"harmonics\" or \"ellipsoid\"";
  if (!run.perturbation.empty()) return "its start has a perturbation";
  if (run.order_pattern.is_there()) return "its order has a pattern";
  try {
    HarmonicMechanics(run.material, run.model, 4);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

WitnessState evolution_on_triangles(const RunInput& run) {
  const RunStart start = studies::start_of(run);
  BriefProgress progress(run.times.end, "surface3d: ");
  WitnessState found{.witness = Witness::surface3d};
  Times times = run.times;
  times.exact_rows = true;
  model::FlowSchedule schedule = schedule_of(times);
  schedule.stop_at_rest = false;
  int triangles = start.moment.mesh->count();
  const surface3d::FlowResult result =
      surface3d::run_flow(run.material, run.model, start.moment, run.numerics, schedule,
                          [&](const surface3d::FlowRecord& record, const surface3d::State& state,
                              const surface3d::StepView& view, bool exact) {
                            progress.see(record);
                            triangles = view.mesh->count();
                            if (exact && contains(run.times.rows, record.time)) {
                              found.history.push_back({record.time, record.energy.total()});
                              found.measures = measures_of_row(series_row(
                                  record, surface3d::diagnose(*view.mesh, run.material, state)));
                            }
                            return interrupt_signal() == 0;
                          });
  if (result.stop == surface3d::FlowStop::interrupted) throw Interrupted("interrupted");
  (result.stop == surface3d::FlowStop::end_time ? found.remark : found.failure) =
      fmt::format("{} triangles, {} at t = {:.4g} after {} steps", triangles,
                  surface3d::describe(result.stop), result.last.time, result.steps);
  return found;
}

WitnessState evolution_of_folder(const RunInput& run, const std::string& folder) {
  WitnessState found{.witness = Witness::surface3d, .remark = fmt::format("from {}", folder)};
  const auto rows = read_rows(series_columns(), std::filesystem::path(folder) / "series.csv");
  if (rows.empty()) {
    found.failure = fmt::format("{} has no rows yet", folder);
    return found;
  }
  const double last = rows.back().record.time;
  if (std::abs(last - run.times.end) > model::same_time * run.times.end) {
    found.failure = fmt::format(
        "{} ends at t = {:.6g}, not at {:.6g}: lengthen it by sbeh run --resume, or give its input",
        folder, last, run.times.end);
    return found;
  }
  for (const SeriesRow& row : rows)
    found.history.push_back({row.record.time, row.record.energy.total()});
  found.measures = measures_of_row(rows.back());
  return found;
}

WitnessState evolution_by_harmonics(const RunInput& run, const HarmonicFlowMethod& method) {
  WitnessState found{.witness = Witness::harmonic_flow};
  const HarmonicEvolution less = flow(run, method, method.degree - coarser),
                          evolution = flow(run, method, method.degree);
  found.history = evolution.history;
  if (evolution.stop == surface3d::HarmonicFlowStop::degenerate) {
    found.failure = fmt::format(
        "l <= {}: the surface has no normal somewhere, or no step is small "
        "enough, after t = {:.4g}",
        method.degree, evolution.last.time);
    return found;
  }
  double error = 0;
  for (std::size_t k = 0; k < evolution.history.size(); ++k)
    error = std::fmax(error, k < less.history.size()
                                 ? std::abs(less.history[k].energy - evolution.history[k].energy)
                                 : not_known);
  found.remark = fmt::format(
      "l <= {}, energies to {:.1e} those of l <= {}; {} solutions, energy balance to {:.1e}",
      method.degree, error, method.degree - coarser, evolution.last.evaluations,
      evolution.imbalance);
  const HarmonicMechanics::Measures& last = evolution.last.measures;
  found.measures = measures_of(last.energy, last, not_known);
  return found;
}

}  // namespace sbeh::studies
