// What a mesh of a shape costs, its report included; `tools/bench` prints the table.

#include "meshing/quality.h"
#include "tests/meshing/cases.h"

#include <benchmark/benchmark.h>

namespace {

using namespace sbeh::meshing;

void mesh_of_y53(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(quality_of(test::y53({.triangles = int(state.range(0))})));
}

}  // namespace

BENCHMARK(mesh_of_y53)->Arg(5120)->Arg(20480)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
