// Uniform order on a sphere: the sphere stays, and the order follows an ordinary differential equation.
#include "tests/model/sphere_theory.h"
#include "tests/surface3d/cases.h"

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr double start_order = 0.45, end_time = 0.15, L = 0.05;

double largest_bump(const Nodes& X) { return (X.colwise().norm().array() - 1).abs().maxCoeff(); }

// Cubic interpolation at equidistant nodes: what the radius of the mesh misses between its nodes.
double mesh_bump(const Surface& s) {
  double bump = 0;
  for_each_point(*s.mesh, s.state.X, diagnostic_points(),
                 [&](int, const ShapeValues&, const SurfacePoint& p) {
                   bump = std::max(bump, std::abs(p.x.norm() - 1));
                 });
  return bump;
}

void expect_rest(Model model, Scheme scheme) {
  const Material material = paper_material(L);
  const double beta =
      model == Model::SSH ? model::full_order : model::sphere_rest_order(material).value();
  const Surface s = uniform_sphere(beta, 320);
  TimeStepper stepper(s.mesh, material, model, numerics_of(scheme));
  State now = s.state;
  double speed = 0;
  for (int k = 0; k < 5; ++k) {
    const FlowStep r = stepper.step(now, s.target(), 0.02);
    ASSERT_TRUE(r.ok());
    speed = stepper.fields().V.colwise().norm().maxCoeff();
    EXPECT_EQ(stepper.fields().lambda, 0);
    const double e = 2 * material.kappa(beta) + material.potential.value(beta);  // (E2) + (E4)
    EXPECT_NEAR((stepper.fields().p.mean() - e) / (-2 * material.kappa(beta)), 1, 0.01);
    now = r.state;
  }
  const double change = (now.beta.array() - beta).abs().maxCoeff();
  std::printf("%s: speed %.1e, bump %.1e of %.1e in the mesh, order %.1e\n", name(model), speed,
              largest_bump(now.X), mesh_bump(s), change);
  EXPECT_LT(speed, 1e-4);  // of several 1e-3 in the first step, in which the mesh settles
  EXPECT_LT(largest_bump(now.X), 2 * mesh_bump(s));
  EXPECT_LT(change, 10 * L * mesh_bump(s));  // the order feels the curvature through L
}

TEST(Sphere, of_full_order_stays_at_rest) { expect_rest(Model::SSH, Scheme::split); }

TEST(Sphere, at_its_rest_order_stays_at_rest) { expect_rest(Model::SBEH, Scheme::monolithic); }

TEST(Sphere, lets_uniform_order_follow_its_equation_at_first_order_in_tau) {
  const Material material = paper_material(L);
  const double expected = model::test::order_on_sphere(material, start_order, end_time);
  EXPECT_GT(expected, start_order + 0.1);
  OrderTable table("order at the end", "tau");
  for (const int steps : {10, 20, 40}) {
    const Surface s = uniform_sphere(start_order, 80);
    TimeStepper stepper(s.mesh, material, Model::SBEH);
    State now = s.state;
    for (int k = 0; k < steps; ++k) {
      FlowStep r = stepper.step(now, s.target(), end_time / steps);
      ASSERT_TRUE(r.ok());
      now = r.state;
    }
    const Diagnostics d = diagnose(*s.mesh, material, now);
    EXPECT_LT(d.order_max - d.order_min, 1e-3);
    std::printf("%d steps: order %.8f, exactly %.8f, spread %.1e\n", steps, d.order_mean, expected,
                d.order_max - d.order_min);
    table.add(end_time / steps, d.order_mean - expected);
  }
  EXPECT_NEAR(table.print(), 1, 0.1);
}

TEST(Sphere, follows_the_equation_at_second_order) {
  const Material material = paper_material(L);
  const double expected = model::test::order_on_sphere(material, start_order, end_time);
  for (const Method method : {Method::extrapolated, Method::two_step}) {
    OrderTable table(method == Method::two_step ? "order at the end, two-step"
                                                : "order at the end, extrapolated",
                     "tau");
    for (const int steps : {6, 12}) {
      const Surface s = uniform_sphere(start_order, 80);
      const FlowResult run = run_of_equal_steps(s, material, Model::SBEH, end_time, steps, method);
      table.add(end_time / steps, diagnose(*s.mesh, material, run.state).order_mean - expected);
    }
    EXPECT_NEAR(table.print(), 2, 0.3);
  }
}

}  // namespace
}  // namespace sbeh::surface3d
