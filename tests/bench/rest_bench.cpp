// From an ellipsoid to the SSH shapes at rest, in 3D with 320 triangles: seconds of one core, and the
// error of the energy against the axisymmetric solver's.

#include "axisym/flow.h"
#include "axisym/start_shapes.h"
#include "meshing/shapes.h"
#include "surface3d/flow.h"

#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>

namespace {

using namespace sbeh;

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

double axisymmetric_energy(double reduced_volume, bool prolate) {
  axisym::Numerics numerics;
  numerics.tolerance = 1e-4;
  const axisym::State start{
      axisym::spheroid(reduced_volume, prolate, numerics.elements, numerics.grading),
      axisym::Field::Constant(3 * numerics.elements + 1, model::full_order)};
  const axisym::Target target{axisym::area(start.X), axisym::volume(start.X)};
  return axisym::run_flow({}, model::Model::SSH, start, target, numerics,
                          {.end_time = 100, .output_times = {}})
      .last.energy.total();
}

void measure(double reduced_volume, bool prolate) {
  using namespace surface3d;
  const double expected = axisymmetric_energy(reduced_volume, prolate);
  const double start = cpu_seconds();
  const auto nodes = meshing::ellipsoid(reduced_volume, prolate, {.triangles = 320});
  const auto mesh = std::make_shared<const Triangulation>(nodes);
  Numerics numerics;  // coarse in time: the state of rest does not depend on the way
  numerics.tolerance = 1e-3;
  numerics.first_step = 1e-4;
  numerics.largest_step = 0.1;
  numerics.rest_speed = 1e-5;
  double reached = 0;
  const FlowResult run =
      run_flow({}, model::Model::SSH,
               {.mesh = mesh,
                .state = {nodes.nodes, Field::Constant(mesh->nodes, model::full_order)},
                .target = area_and_volume(*mesh, nodes.nodes)},
               numerics, {.end_time = 20, .output_times = {}},
               [&](const FlowRecord& record, const State&, const StepView&, bool) {
                 const bool near = std::abs(record.energy.total() / expected - 1) < 2e-5;
                 if (near && reached == 0) reached = cpu_seconds() - start;
                 if (!near) reached = 0;
                 return true;
               });
  std::printf(
      "%-8s V_r %.2f: within 2e-5 of the energy %.9f after %4.1f s; %s at t = %.1f after %d steps "
      "and "
      "%.1f s, off by %.1e\n",
      prolate ? "prolate" : "oblate", reduced_volume, expected, reached, describe(run.stop).c_str(),
      run.last.time, run.steps, cpu_seconds() - start, run.last.energy.total() / expected - 1);
}

}  // namespace

int main() {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  for (const bool prolate : {false, true})
    for (const double reduced_volume : {0.65, 0.8}) measure(reduced_volume, prolate);
}
