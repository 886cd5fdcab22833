// Uniform order on a sphere: the sphere stays, and the order follows an ordinary differential equation.
#include "tests/axisym/cases.h"
#include "tests/model/sphere_theory.h"

namespace sbeh::axisym {
namespace {

using namespace test;

constexpr double start_order = 0.45, end_time = 0.15;
constexpr int elements = 32;
const Target unit_sphere = target_of(1);

State uniform_sphere(double beta) {
  State s{.X = spheroid(1, false, elements, 0), .beta = {}};
  s.beta = Field::Constant(s.X.cols(), beta);
  return s;
}

struct Evolved {
  State state;
  bool ok;
};
Evolved evolve(const Material& material, State s, double tau, int steps) {
  TimeStepper stepper(material, Model::SBEH, elements);
  for (int k = 0; k < steps; ++k) {
    FlowStep r = stepper.step(s, unit_sphere, tau);
    if (!r.ok()) return {s, false};
    s = r.state;
  }
  return {s, true};
}

// ‖x‖ − 1 at the nodes, about the middle of the axis.
double largest_bump(const Nodes& X) {
  const double middle = (X(1, 0) + X(1, X.cols() - 1)) / 2;
  double bump = 0;
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    bump = std::max(bump, std::abs(std::hypot(X(0, i), X(1, i) - middle) - 1));
  return bump;
}

TEST(Sphere, lets_uniform_order_follow_its_equation_at_first_order_in_tau) {
  const Material material = paper_material(0.05);
  const double expected = model::test::order_on_sphere(material, start_order, end_time);
  std::printf("order from %.2f to %.6f\n", start_order, expected);
  EXPECT_GT(expected, start_order + 0.1);
  OrderTable table("order at the end", "tau");
  for (const int steps : {20, 40, 80, 160}) {
    const auto [s, ok] = evolve(material, uniform_sphere(start_order), end_time / steps, steps);
    ASSERT_TRUE(ok);
    const double mean = diagnose(material, s).order_mean;
    table.add(end_time / steps, mean - expected);
  }
  EXPECT_NEAR(table.print(), 1, 0.1);
}

TEST(Sphere, stays_a_sphere_with_uniform_order) {
  const Material material = paper_material(0.05);
  OrderTable bump("largest | |x| - 1 |", "tau"), spread("max - min of the order", "tau");
  for (const int steps : {20, 80}) {
    const auto [s, ok] = evolve(material, uniform_sphere(start_order), end_time / steps, steps);
    ASSERT_TRUE(ok);
    const Diagnostics d = diagnose(material, s);
    bump.add(end_time / steps, largest_bump(s.X));
    spread.add(end_time / steps, d.order_max - d.order_min);
    // Cubic interpolation of a circle errs by h⁴ max|x(x − 1/3)(x − 2/3)(x − 1)|/4! = h⁴/1944 with
    // h = π/32; ten times that is allowed. The order feels the curvature through L.
    const double h = pi / elements, allowed = std::pow(h, 4) / 194;
    EXPECT_LT(largest_bump(s.X), allowed);
    EXPECT_LT(d.order_max - d.order_min, material.L1 * allowed);
    EXPECT_NEAR(d.area / (4 * pi), 1, 1e-9);
  }
  bump.print();
  spread.print();
}

TEST(Sphere, ends_at_the_root_of_the_rest_equation) {
  for (const double L : {0.01, 0.05, 0.3}) {
    const Material material = paper_material(L);
    const auto [s, ok] = evolve(material, uniform_sphere(model::full_order), 0.05, 400);
    ASSERT_TRUE(ok);
    // Larger root of 60.75 β² − 40.5 β + 9L = 0
    const double root = (40.5 + std::sqrt(40.5 * 40.5 - 4 * 60.75 * 9 * L)) / (2 * 60.75);
    const double mean = diagnose(material, s).order_mean;
    std::printf("L = %.2f: order at rest %.9f, root %.9f\n", L, mean, root);
    EXPECT_NEAR(mean, root, 1e-6);
    EXPECT_NEAR(model::sphere_rest_order(material).value(), root, 1e-14);
  }
  EXPECT_NEAR(model::sphere_rest_order(paper_material(0.05)).value(), 0.6553639, 5e-8);
  EXPECT_FALSE(model::sphere_rest_order(paper_material(0.76)).has_value());
}

TEST(Sphere, runs_under_step_control_like_any_other_shape) {
  const Material material = paper_material(0.05);
  const FlowResult run = run_flow(
      material, Model::SBEH, uniform_sphere(start_order), unit_sphere, with_elements(elements),
      {.end_time = end_time, .output_times = {}, .stop_at_rest = false});
  EXPECT_EQ(run.stop, FlowStop::end_time);
  EXPECT_NEAR(diagnose(material, run.state).order_mean,
              model::test::order_on_sphere(material, start_order, end_time), 1e-4);
}

}  // namespace
}  // namespace sbeh::axisym
