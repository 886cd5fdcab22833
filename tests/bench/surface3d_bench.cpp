// What a step of the 3D solver costs over a run from r = 1 + 0.5 Y₅³ (SSH, L = 0.05), against the
// reference: the monolithic scheme, factored in every step, over the same sequence of time steps.
//
//   surface3d_bench [END [REFERENCE_STEPS [THREADS [TRIANGLES ...]]]]
//
// For each mesh: a run to time END by its own step control, with all that belongs to it (rejected steps,
// error estimates, energies); and some of its steps by the reference, the step alone. Then
// its last REFERENCE_STEPS once more, by all schemes, from the same states. Seconds are wall-clock
// seconds: other work on the machine spoils them.

#include "meshing/shapes.h"
#include "meshing/spherical_harmonics.h"
#include "model/time/multi_step.h"
#include "surface3d/flow.h"
#include "surface3d/linear/direct_solver.h"

#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace {

using namespace sbeh;
using namespace sbeh::surface3d;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

double seconds_of(const std::function<void()>& part) {
  constexpr int times = 3;
  const double start = seconds();
  for (int i = 0; i < times; ++i) part();
  return (seconds() - start) / times;
}

struct Case {
  std::shared_ptr<const Triangulation> mesh;
  State start;
  model::Material material;
};

Case harmonic(int triangles) {
  const std::vector<meshing::Harmonic> modes{{5, 3, 0.5}};
  const auto mesh = meshing::harmonic_sphere(modes, {.triangles = triangles});
  return {.mesh = std::make_shared<Triangulation>(mesh),
          .start = {mesh.nodes, Field::Constant(mesh.node_count(), model::full_order)},
          .material = {}};
}

// A step of a run: its states before and after, and the one it was extrapolated from.
struct Taken {
  State at, from;
  double tau;
};

// The reference's factors fill up at the tiny first time steps (5120 triangles, τ = 1e-5: hours).
constexpr double sample_from = 0.01;
constexpr int sample_every = 20;

struct Replay {
  double seconds_per_step = 0, iterations_per_step = 0;
  int factorisations = 0;
  Field radius;  // of the last state, for comparison
};

Replay replay(const Case& c, const std::vector<Taken>& steps, Scheme scheme,
              Factorisation factorisation, double solver_tolerance = Numerics().solver_tolerance) {
  Numerics numerics;
  numerics.scheme = scheme;
  numerics.factorisation = factorisation;
  numerics.solver_tolerance = solver_tolerance;
  TimeStepper stepper(c.mesh, c.material, model::Model::SSH, numerics);
  Replay r;
  if (factorisation == Factorisation::every_step)  // the analysis of the structure is done once
    (void)stepper.step(steps[0].at, steps[0].from, steps[0].tau);
  const double start = seconds();
  for (const Taken& s : steps) {
    const FlowStep result = stepper.step(s.at, s.from, s.tau);
    if (!result.ok()) std::puts("  a step failed");
    r.iterations_per_step += stepper.memory().last_iterations / double(steps.size());
    if (stepper.memory().solves == 1) ++r.factorisations;
    r.radius = result.state.X.colwise().norm();
  }
  r.seconds_per_step = (seconds() - start) / double(steps.size());
  return r;
}

void print_parts(const Case& c) {
  const Curvature curvature = *curvature_of(*c.mesh, c.start.X);
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
    CoupledSystem system(*c.mesh, c.material, scheme);
    const double assembly = seconds_of([&] {
      system.assemble(*c.mesh, c.start, curvature, c.start.beta, {c.start.X, curvature.H}, 1e-3,
                      {0, 0, true, 4 * std::numbers::pi});
    });
    const bool reference = scheme == Scheme::monolithic;
    DirectSolver flow(Symmetry::general, reference ? Precision::full : Precision::single);
    if (!flow.factor(system.flow().matrix)) std::puts("  singular");
    const double factoring = seconds_of([&] { (void)flow.factor(system.flow().matrix); });
    Eigen::MatrixXd x = system.flow().rhs;
    const double solving = seconds_of([&] { flow.solve(x); });
    std::printf(
        "  %-10s %7ld unknowns: assembly %.3f s, factors %.3f s (%.1e operations, %.0f MB), their "
        "application %.4f s\n",
        name(scheme), long(system.flow().rhs.size()), assembly, factoring, flow.flops(),
        (reference ? 8e-6 : 4e-6) * flow.entries(), solving);
  }
  std::printf("  curvature %.4f s, area and volume %.4f s\n",
              seconds_of([&] { (void)curvature_of(*c.mesh, c.start.X); }), seconds_of([&] {
                (void)area(*c.mesh, c.start.X);
                (void)volume(*c.mesh, c.start.X);
              }));
}

void measure(int triangles, double end, int reference_steps) {
  const Case c = harmonic(triangles);
  std::printf("%d triangles\n", c.mesh->count());
  print_parts(c);
  std::vector<Taken> steps, sample;
  FlowSchedule schedule;
  schedule.end_time = end;
  schedule.stop_at_rest = false;
  State before = c.start;
  double tau_before = 0, next_print = 1e-3;
  int taken = 0;
  const double start = seconds();
  const FlowResult run = run_flow(
      c.material, model::Model::SSH,
      {.mesh = c.mesh, .state = c.start, .target = area_and_volume(*c.mesh, c.start.X)}, Numerics(),
      schedule, [&](const FlowRecord& record, const State& state, const StepView& view, bool) {
        if (record.time >= next_print) {
          std::printf("    t %.3f: time step %.1e, %d applications of factors %d steps old\n",
                      record.time, record.time_step, view.memory.stepper.last_iterations,
                      view.memory.stepper.solves - 1);
          next_print *= 3;
        }
        if (tau_before > 0 && record.next_step > 0) {
          const double r = record.next_step / record.time_step;
          const auto ahead = [&](double by) -> State {
            return {state.X + by * (state.X - before.X),
                    state.beta + by * (state.beta - before.beta)};
          };
          steps.push_back(
              {ahead(r), ahead(r * r / (1 + 2 * r)), record.next_step * (1 + r) / (1 + 2 * r)});
          if (int(steps.size()) > reference_steps) steps.erase(steps.begin());
          if (record.time >= sample_from && taken++ % sample_every == 0)
            sample.push_back(steps.back());
        }
        before = state;
        tau_before = record.time_step;
        return true;
      });
  const double mean = (seconds() - start) / (run.steps + run.last.rejected);
  const double mean_reference =
      replay(c, sample, Scheme::monolithic, Factorisation::every_step).seconds_per_step;
  std::printf(
      "  run to t = %g: %d steps (%d rejected), %.3f s a step; the reference %.3f s, ratio %.1f\n",
      end, run.steps, run.last.rejected, mean, mean_reference, mean_reference / mean);
  const Replay fast = replay(c, steps, Scheme::split, Factorisation::lagged);
  const Replay reference = replay(c, steps, Scheme::monolithic, Factorisation::every_step);
  const Replay lagged = replay(c, steps, Scheme::monolithic, Factorisation::lagged, 1e-8);
  for (const auto& [what, r] : {std::pair("split, lagged", &fast),
                                {"monolithic, 1e-8", &lagged},
                                {"reference", &reference}})
    std::printf(
        "  %-18s %.3f s a step, %.1f applications, %d factorisations in %d steps; off the "
        "reference "
        "by %.1e\n",
        what, r->seconds_per_step, r->iterations_per_step, r->factorisations, int(steps.size()),
        (r->radius - reference.radius).cwiseAbs().maxCoeff());
  std::printf("  peak memory so far %.0f MB\n", peak_megabytes());
}

}  // namespace

int main(int count, char** arguments) {
  const double end = count > 1 ? std::atof(arguments[1]) : 0.2;
  const int reference_steps = count > 2 ? std::atoi(arguments[2]) : 12;
  const int threads = count > 3 ? std::atoi(arguments[3]) : 1;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::size_t(threads));
  std::vector<int> sizes;
  for (int i = 4; i < count; ++i) sizes.push_back(std::atoi(arguments[i]));
  if (sizes.empty()) sizes = {320, 1280};
  for (const int triangles : sizes) measure(triangles, end, reference_steps);
}
