// How the result converges with the time step: by three steps faster than by two, whose order is the second, as by extrapolation, first by two half steps.
#include "model/time/multi_step.h"
#include "surface3d/lipids.h"
#include "tests/surface3d/cases.h"

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

// Two modes on a sphere exchange their excess area.
Surface two_modes() {
  const std::vector<meshing::Harmonic> modes{{2, 2, 0.15}, {3, -1, 0.12}};
  return surface_of(meshing::harmonic_sphere(modes, {.triangles = 80}), 0.655);
}

// ∫ x² − y² dS, of the mode (2, 2); ∫ y (5z² − 1) dS, of the mode (3, −1).
Eigen::Array2d moments(const Surface& s, const State& state) {
  Eigen::Array2d sum = Eigen::Array2d::Zero();
  for_each_point(*s.mesh, state.X, diagnostic_points(),
                 [&](int, const ShapeValues&, const SurfacePoint& p) {
                   const double x = p.x[0], y = p.x[1], z = p.x[2];
                   sum += p.dS * Eigen::Array2d(x * x - y * y, y * (5 * z * z - 1));
                 });
  return sum;
}

const char* words(Method method) {
  switch (method) {
    case Method::two_step:
      return ", two-step";
    case Method::extrapolated:
      return ", extrapolated";
    case Method::two_halves:
      return ", two half steps";
  }
  return "";
}

// The order at the end of the table. (That of the order is tested on the sphere.)
double observed_order(Model model, Method method) {
  const Material material = paper_material(0.05);
  const Surface start = two_modes();
  const double duration = 0.26;
  OrderTable table(
      std::string(name(model)) + words(method) + ": change of both modes from twice the step",
      "tau");
  const auto end = [&](int steps) {
    return moments(start,
                   run_of_equal_steps(start, material, model, duration, steps, method).state);
  };
  const int fewest = 8;
  Eigen::Array2d before = end(fewest);
  for (const int steps : {2 * fewest, 4 * fewest}) {
    const Eigen::Array2d now = end(steps);
    table.add(duration / steps, (now - before).matrix().norm());
    before = now;
  }
  return table.print();
}

TEST(TimeStep, extrapolated_is_of_second_order) {
  EXPECT_NEAR(observed_order(Model::SSH, Method::extrapolated), 2, 0.2);
  EXPECT_NEAR(observed_order(Model::SBEH, Method::extrapolated), 2, 0.2);
}

TEST(TimeStep, of_two_steps_is_of_second_order) {
  EXPECT_NEAR(observed_order(Model::SSH, Method::two_step), 2, 0.2);
  EXPECT_NEAR(observed_order(Model::SBEH, Method::two_step), 2, 0.2);
}

// What an integrator asks of a solver.
struct Stepping {
  using State = surface3d::State;

  std::shared_ptr<const Triangulation> mesh;
  Material material;
  TimeStepper stepper;

  FlowStep step(const auto&... of) { return stepper.step(of...); }
  bool restore(State& state, const Target& target) const {
    return correct_lipids_volume(*mesh, material, stepper.fields().H, target, state);
  }
  model::Distance distance(const State& a, const State& b) const {
    return {(b.X - a.X).cwiseAbs().maxCoeff(), (b.beta - a.beta).cwiseAbs().maxCoeff()};
  }
};

// The moments after equal steps by a formula of two or three steps; so small a tolerance would never have two instead of three. The start
// has lost the short waves that its triangles make.
Eigen::Array2d end_of_equal_steps(const Surface& start, Model model, double duration, int steps,
                                  int steps_of_formula) {
  const Material material = paper_material(0.05);
  Numerics numerics;
  numerics.solver_tolerance = 1e-11;
  numerics.tolerance = 1e-11;
  numerics.largest_step = 1e3;
  Stepping solver{start.mesh, material, TimeStepper(start.mesh, material, model, numerics)};
  model::MultiStep integrator(solver, area_and_volume(*start.mesh, start.state.X), numerics,
                              steps_of_formula);
  State state = start.state;
  const double tau = duration / steps;
  for (int k = 0; k < steps; ++k) {
    const FlowStep step = integrator.advance(state, tau);
    EXPECT_TRUE(step.ok());
    integrator.accept(state, step, tau);
    state = step.state;
  }
  return moments(start, state);
}

TEST(TimeStep, of_three_steps_has_a_fraction_of_the_error_of_two_that_falls_with_the_step) {
  for (const Model model : {Model::SSH, Model::SBEH}) {
    Surface start = two_modes();
    start.state =
        run_of_equal_steps(start, paper_material(0.05), model, 0.1, 100, Method::extrapolated)
            .state;
    constexpr double duration = 0.4;
    const auto end = [&](int steps, int of) {
      return end_of_equal_steps(start, model, duration, steps, of);
    };
    const Eigen::Array2d limit = end(256, 3);
    double before = 1;
    for (const int steps : {16, 32, 64}) {
      const double two = (end(steps, 2) - limit).matrix().norm(),
                   three = (end(steps, 3) - limit).matrix().norm();
      std::printf("%s, %d steps: error of two %.3e, of three %.3e\n", name(model), steps, two,
                  three);
      EXPECT_LT(three, 0.25 * two);
      EXPECT_LT(three, before);
      before = three;
    }
  }
}

TEST(TimeStep, in_two_halves_is_of_first_order) {
  EXPECT_NEAR(observed_order(Model::SSH, Method::two_halves), 1, 0.1);
  EXPECT_NEAR(observed_order(Model::SBEH, Method::two_halves), 1, 0.1);
}

}  // namespace
}  // namespace sbeh::surface3d
