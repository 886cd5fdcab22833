// Results do not depend on the number of threads, bit for bit.
#include "tests/surface3d/cases.h"

#include <tbb/global_control.h>

namespace sbeh::surface3d {
namespace {

using namespace test;

TEST(Threads, change_no_bit_of_the_assembly_or_of_a_step) {
  const Surface s = ordered_spheroid(0.8, 180);  // some chunks of triangles
  const Material material = paper_material(0.05);
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
    const auto result = [&](std::size_t threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      CoupledSystem system(*s.mesh, material, scheme);
      const Curvature curvature = *curvature_of(*s.mesh, s.state.X);
      system.assemble(*s.mesh, s.state, curvature, s.state.beta, {s.state.X, curvature.H}, 1e-3,
                      {.area_rate = 0.1, .volume_rate = 0.1, .keep_volume = true, .area = 4 * pi});
      TimeStepper stepper(s.mesh, material, Model::SBEH, numerics_of(scheme));
      FlowStep step = stepper.step(s.state, s.target(), 1e-3);
      EXPECT_TRUE(step.ok());
      return std::tuple{system.flow(), std::move(step), stepper.fields()};
    };
    const auto [system, step, fields] = result(1);
    for (const std::size_t threads : {2, 4}) {
      const auto [same_system, same_step, same_fields] = result(threads);
      EXPECT_TRUE((system.matrix.coeffs() == same_system.matrix.coeffs()).all());
      EXPECT_TRUE(system.rhs == same_system.rhs);
      EXPECT_TRUE(step.state.X == same_step.state.X);
      EXPECT_TRUE(step.state.beta == same_step.state.beta);
      EXPECT_TRUE(fields.V == same_fields.V);
      EXPECT_TRUE(fields.p == same_fields.p);
      EXPECT_EQ(step.dissipation.total(), same_step.dissipation.total());
    }
  }
}

TEST(Step, forgets_solutions_that_are_not_of_its_systems) {
  const Surface s = ordered_spheroid(0.8, 80);
  TimeStepper stepper(s.mesh, paper_material(0.05), Model::SBEH);
  ASSERT_TRUE(stepper.step(s.state, s.target(), 1e-3).ok());
  StepperMemory memory = stepper.memory();
  memory.last.motion.conservativeResize(2 * memory.last.motion.size());
  ASSERT_TRUE(stepper.recall(memory));
  EXPECT_EQ(stepper.memory().last.flow.size(), 0);
  EXPECT_TRUE(stepper.step(s.state, s.target(), 1e-3).ok());
}

TEST(Step, is_a_function_of_the_state_alone) {
  // A stepper that has made other steps before, and factors again, gives the bits of a fresh one.
  const Surface s = ordered_spheroid(0.8, 80);
  const Material material = paper_material(0.05);
  const Numerics numerics = numerics_of(Scheme::split, Factorisation::every_step);
  TimeStepper used(s.mesh, material, Model::SBEH, numerics),
      fresh(s.mesh, material, Model::SBEH, numerics);
  const FlowStep first = used.step(s.state, s.target(), 3e-2);
  ASSERT_TRUE(first.ok());
  ASSERT_TRUE(used.step(first.state, s.target(), 1e-2).ok());
  const FlowStep a = used.step(s.state, s.target(), 1e-4),
                 b = fresh.step(s.state, s.target(), 1e-4);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_TRUE(a.state.X == b.state.X);
  EXPECT_TRUE(a.state.beta == b.state.beta);
}

}  // namespace
}  // namespace sbeh::surface3d
