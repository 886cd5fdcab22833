// How the result converges with the time step: second order by two steps or by extrapolation, first
// by two half steps.
#include "tests/surface3d/cases.h"

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

TEST(TimeStep, in_two_halves_is_of_first_order) {
  EXPECT_NEAR(observed_order(Model::SSH, Method::two_halves), 1, 0.1);
  EXPECT_NEAR(observed_order(Model::SBEH, Method::two_halves), 1, 0.1);
}

}  // namespace
}  // namespace sbeh::surface3d
