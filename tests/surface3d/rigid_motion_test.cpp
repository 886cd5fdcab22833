// Where and how a surface stands in space does not matter; without friction nothing holds it.
#include "tests/surface3d/cases.h"

#include <Eigen/Cholesky>

namespace sbeh::surface3d {
namespace {

using namespace test;

// Nothing about it is symmetric.
Surface bumpy(int triangles) {
  const std::vector<meshing::Harmonic> modes{{2, 1, 0.2}, {3, -2, 0.15}, {4, 3, 0.1}};
  Surface s = surface_of(meshing::harmonic_sphere(modes, {.triangles = triangles}));
  for (Eigen::Index i = 0; i < s.state.beta.size(); ++i)
    s.state.beta[i] = 0.6 + 0.05 * s.state.X(0, i) - 0.03 * s.state.X(2, i);
  return s;
}

struct Motion {
  Eigen::Matrix3d turn;
  Eigen::Vector3d shift;
  Nodes operator()(const Nodes& X) const { return (turn * X).colwise() + shift; }
};
const Motion motion{
    .turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(),
    .shift = {0.7, -0.4, 1.3}};

Material with_friction(double friction) {
  Material m = paper_material(0.05);
  m.friction_tangential = m.friction_normal = friction;
  return m;
}

TEST(RigidMotion, of_the_start_is_that_of_the_result) {
  const Surface s = bumpy(80);
  Surface moved = s;
  moved.state.X = motion(s.state.X);
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic})
    for (const double friction : {0.1, 0.}) {
      const Material material = with_friction(friction);
      TimeStepper stepper(s.mesh, material, Model::SBEH,
                          numerics_of(scheme, Factorisation::lagged, 1e-10));
      State here = s.state, there = moved.state;
      for (int k = 0; k < 3; ++k) {
        const FlowStep a = stepper.step(here, s.target(), 1e-3);
        const FlowStep b = stepper.step(there, s.target(), 1e-3);
        ASSERT_TRUE(a.ok() && b.ok());
        EXPECT_NEAR(a.dissipation.total() / b.dissipation.total(), 1, 1e-9);
        here = a.state;
        there = b.state;
      }
      const double X = (motion(here.X) - there.X).cwiseAbs().maxCoeff();
      const double beta = (here.beta - there.beta).cwiseAbs().maxCoeff();
      std::printf("friction %.1f: positions differ by %.1e, order by %.1e\n", friction, X, beta);
      // Rounding times the condition number of the flow.
      EXPECT_LT(X, 1e-10);
      EXPECT_LT(beta, 1e-10);
    }
}

// V − (a + b × x), so that neither (V, 1) nor (x × V, 1) is left; |(V, 1)|/A, and |b|.
struct Moments {
  Nodes rest;
  double shift, turn;
};
Moments moments(const Surface& s, const Nodes& V) {
  Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> sums = Eigen::Matrix<double, 6, 1>::Zero();
  for_each_point(*s.mesh, s.state.X, assembly_points(),
                 [&](int e, const ShapeValues& v, const SurfacePoint& p) {
                   Eigen::Matrix<double, 3, 6> R;  // e_k, e_k × x
                   for (int k = 0; k < 3; ++k) {
                     R.col(k) = Eigen::Vector3d::Unit(k);
                     R.col(3 + k) = Eigen::Vector3d::Unit(k).cross(p.x);
                   }
                   mass += p.dS * R.transpose() * R;
                   sums += p.dS * R.transpose() * value_at(on_element(*s.mesh, e, V), v);
                 });
  const Eigen::Matrix<double, 6, 1> c = mass.llt().solve(sums);
  Nodes rest = V;
  for (Eigen::Index i = 0; i < V.cols(); ++i)
    rest.col(i) -= c.head<3>() + c.tail<3>().cross(s.state.X.col(i));
  return {rest, sums.head<3>().norm() / s.target().area, c.tail<3>().norm()};
}

Nodes velocity(const Surface& s, double friction, Scheme scheme) {
  TimeStepper stepper(s.mesh, with_friction(friction), Model::SBEH,
                      numerics_of(scheme, Factorisation::lagged, 1e-8));
  // So short that a turn of the surface, which friction allows, does not matter to the curvature.
  const FlowStep r = stepper.step(s.state, s.target(), 1e-5);
  EXPECT_TRUE(r.ok());
  EXPECT_EQ(r.dissipation.friction == 0, friction == 0);
  return stepper.fields().V;
}

TEST(Frictionless, flow_does_not_move_or_turn_the_surface_in_the_mean) {
  const Surface s = bumpy(80);
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
    const Nodes V = velocity(s, 0, scheme);
    const Moments m = moments(s, V);
    const double size = V.colwise().norm().maxCoeff();
    EXPECT_LT(m.shift, 1e-10 * size);
    EXPECT_LT(m.turn, 1e-10 * size);
  }
}

TEST(Frictionless, flow_is_the_limit_of_small_friction) {
  const Surface s = bumpy(80);
  const Nodes limit = velocity(s, 0, Scheme::split);
  OrderTable table("difference of velocities but for rigid motions, relative", "friction");
  for (const double friction : {1e-2, 1e-3, 1e-4}) {
    const Moments m = moments(s, velocity(s, friction, Scheme::split));
    table.add(friction, (m.rest - limit).norm() / limit.norm());
    // Forces add up to zero exactly, torques up to the error of the curvature, against friction.
    std::printf("friction %.0e: shift %.1e, turn %.1e\n", friction, m.shift, m.turn);
    EXPECT_LT(m.shift, 1e-10 / friction);
    EXPECT_LT(m.turn, 1e-5 / friction);
  }
  EXPECT_NEAR(table.print(), 1, 0.05);
}

// A body of revolution turns about its axis at no cost, a sphere about any; what the normal friction of its
// mesh finds of a turn is nothing but errors.
TEST(NormalFriction, does_not_turn_what_it_cannot_hold) {
  Material m = paper_material(0.05);
  m.friction_tangential = 0;
  const std::vector surfaces{uniform_sphere(model::full_order, 80),
                             uniform_sphere(model::full_order, 320), ordered_spheroid(0.99, 320),
                             ordered_spheroid(0.8, 80), ordered_spheroid(0.8, 320)};
  for (const Surface& s : surfaces)
    for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
      TimeStepper stepper(s.mesh, m, Model::SBEH, numerics_of(scheme));
      ASSERT_TRUE(stepper.step(s.state, s.target(), 1e-5).ok());
      const Moments of = moments(s, stepper.fields().V);
      const double size = of.rest.colwise().norm().maxCoeff();
      std::printf("%d triangles: turn %.1e, shift %.1e, speed without %.1e\n", s.mesh->count(),
                  of.turn, of.shift, size);
      EXPECT_LT(of.turn, 0.1 * size);  // solver_tolerance over the least share
    }
}

// Also near a sphere, where this friction resists turns no more than along the surface it could.
TEST(NormalFriction, is_the_limit_of_small_tangential_friction) {
  const std::vector<meshing::Harmonic> modes{{2, 1, 0.02}, {3, -2, 0.015}, {4, 3, 0.01}};
  for (const Surface& s :
       {bumpy(80), surface_of(meshing::harmonic_sphere(modes, {.triangles = 80}))}) {
    const auto energy_with = [&](double friction) {
      Material m = paper_material(0.05);
      m.friction_tangential = friction;
      Surface start = s;
      start.state = run_of_equal_steps(s, m, Model::SBEH, 0.01, 5, Method::two_halves).state;
      return energy_of(*s.mesh, m, start.state);
    };
    const double limit = energy_with(0);
    OrderTable table("difference of energies", "friction");
    for (const double friction : {1e-2, 1e-3})  // of 0.1 along the normals
      table.add(friction, energy_with(friction) - limit);
    EXPECT_NEAR(table.print(), 1, 0.15);
  }
}

TEST(Frictionless, sphere_stays) {
  const Surface s = uniform_sphere(model::full_order, 320);
  TimeStepper stepper(s.mesh, with_friction(0), Model::SSH);
  State now = s.state;
  for (int k = 0; k < 4; ++k) {
    const FlowStep r = stepper.step(now, s.target(), 0.02);
    ASSERT_TRUE(r.ok());
    now = r.state;
  }
  EXPECT_LT((now.X.colwise().norm().array() - 1).abs().maxCoeff(), 1e-4);
}

}  // namespace
}  // namespace sbeh::surface3d
