// What a time step, its parts, and a stationary point cost; `tools/bench` prints the table.

#include "axisym/curvature.h"
#include "axisym/diagnostics.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/continuation.h"
#include "axisym/stationary/newton_system.h"

#include <benchmark/benchmark.h>

#include <stdexcept>

namespace {

using namespace sbeh;
using namespace sbeh::axisym;
using model::Model;

const model::Material material;  // the paper's, L = 0.05

State spheroid_state(int elements) {
  return {spheroid(0.8, false, elements, 0.5),
          Field::Constant(3 * elements + 1, model::full_order)};
}

// The oblate of a model at a point of the plane, reached as a scan does.
BranchState oblate(Model model, PlanePoint at) {
  const Numerics numerics;
  const State start{spheroid(0.95, false, numerics.elements, numerics.grading),
                    Field::Constant(3 * numerics.elements + 1, model::full_order)};
  const auto solved = [](Model m, PlanePoint where, const State& near) {
    const auto r = solve_stationary(material.with_L(where.L), m, target_of(where.reduced_volume),
                                    guess_from(material.with_L(where.L), m, near));
    if (r.status != NewtonStatus::converged) throw std::runtime_error("no stationary state");
    return BranchState{r.state, where, r.determinant_sign};
  };
  const BranchState entry = solved(Model::SSH, {0.95, 0.01}, start);
  const FollowResult classical =
      follow(material, Model::SSH, entry, {at.reduced_volume, 0.01}, numerics);
  return follow(material, model, solved(model, classical.state.at, classical.state), at, numerics)
      .state;
}

void curvature(benchmark::State& run) {
  const State state = spheroid_state(int(run.range(0)));
  for (auto _ : run) benchmark::DoNotOptimize(mean_curvature(state.X));
  run.SetComplexityN(run.range(0));
}

void diagnostics(benchmark::State& run) {
  const State state = spheroid_state(int(run.range(0)));
  for (auto _ : run) benchmark::DoNotOptimize(diagnose(material, state));
  run.SetComplexityN(run.range(0));
}

void time_step(benchmark::State& run) {
  const int elements = int(run.range(0));
  const State state = spheroid_state(elements);
  TimeStepper stepper(material, Model::SBEH, elements);
  for (auto _ : run) benchmark::DoNotOptimize(stepper.step(state, target_of(0.8), 1e-4));
  run.SetComplexityN(run.range(0));
}

void newton_assembly(benchmark::State& run) {
  const int elements = int(run.range(0));
  const StationaryState state = guess_from(material, Model::SBEH, spheroid_state(elements));
  const Nodes normals = node_normals(state.X);
  LagrangianDerivatives derivatives({elements, false});
  for (auto _ : run) assemble(material, state, normals, derivatives);
  run.SetComplexityN(run.range(0));
}

void newton_iteration(benchmark::State& run) {
  const int elements = int(run.range(0));
  const StationaryState state = guess_from(material, Model::SBEH, spheroid_state(elements));
  NewtonSystem system(material, Model::SBEH, {elements, false});
  Increment step;
  for (auto _ : run) {
    benchmark::DoNotOptimize(system.linearise(state));
    benchmark::DoNotOptimize(system.newton_step(target_of(0.8), step));
  }
  run.SetComplexityN(run.range(0));
}

// From a point of the map to its neighbour, redistribution and second solve included.
void warm_point(benchmark::State& run, Model model) {
  const BranchState from = oblate(model, {0.75, 0.05});
  for (auto _ : run) {
    const FollowResult next = follow(material, model, from, {0.75, 0.0515}, Numerics{});
    if (next.arrival != Arrival::reached) run.SkipWithError("the next point was not reached");
  }
}

}  // namespace

BENCHMARK(curvature)->RangeMultiplier(2)->Range(32, 1024)->Complexity(benchmark::oN);
BENCHMARK(diagnostics)->RangeMultiplier(2)->Range(32, 1024)->Complexity(benchmark::oN);
BENCHMARK(time_step)->RangeMultiplier(2)->Range(32, 1024)->Complexity(benchmark::oN);
BENCHMARK(newton_assembly)->RangeMultiplier(2)->Range(32, 1024)->Complexity(benchmark::oN);
BENCHMARK(newton_iteration)->RangeMultiplier(2)->Range(32, 1024)->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(warm_point, SBEH, Model::SBEH)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(warm_point, SSH, Model::SSH)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
