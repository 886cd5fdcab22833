// Steps by Onsager's principle: what they dissipate, where they lead, and that the energy falls.
#include "surface3d/stationary/stationary.h"
#include "surface3d/variational/growth_rates.h"
#include "surface3d/variational/variational_stepper.h"
#include "tests/surface3d/cases.h"

#include <random>
#include <stdexcept>

namespace sbeh::surface3d::test {
namespace {

Material viscous_material() {
  Material material = paper_material(0.05);
  material.viscosity = 0.7;
  material.friction_normal = 0.4;
  material.friction_tangential = 0.2;
  return material;
}

double energy_in(const VariationalStepper& stepper, const Surface& s, const State& state) {
  return stepper.energy(state, curvature_of(*s.mesh, state.X).value()).total();
}

// The quadratic form against what is dissipated by the motion that it means.
TEST(VariationalStep, has_half_the_dissipation_of_any_motion) {
  const Material material = viscous_material();
  const double tau = 0.3;
  Surface s = ordered_spheroid(0.8, 80);
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto some = [&](Eigen::Index n) {
    return Eigen::VectorXd::NullaryExpr(n, [&] { return number(engine); }).eval();
  };
  for (int i = 0; i < s.mesh->nodes; ++i) s.state.beta[i] = 0.5 + 0.1 * s.state.X(2, i);
  const Curvature curvature = curvature_of(*s.mesh, s.state.X).value();
  const auto tangents = node_tangents(curvature.node_normals);
  const Nodes Y = 0.01 * tangents[0] * some(s.mesh->nodes).asDiagonal();
  const StepLayout layout(*s.mesh, material, Model::SBEH);
  StepResistance form;
  assemble(material, layout, {s.state, curvature, tangents, Y, tau}, form);

  Eigen::VectorXd still = Eigen::VectorXd::Zero(layout.size());
  still(layout.all(node_beta)) = s.state.beta;
  const auto of_motion = [&](const Eigen::VectorXd& x) {
    Nodes u = curvature.node_normals * x(layout.all(node_d)).asDiagonal();
    const Nodes mesh = Y + u;
    for (int k = 0; k < 2; ++k)
      u += tangents[std::size_t(k)] * x(layout.all(layout.state.per_node + k)).asDiagonal();
    return tau / 2
         * dissipation_of(*s.mesh, material, s.state,
                          {.velocity = u / tau,
                           .slip = (u - mesh) / tau,
                           .order_rate = (x(layout.all(node_beta)) - s.state.beta) / tau,
                           .order = s.state.beta})
               .total();
  };
  const auto of_form = [&](const Eigen::VectorXd& x) {
    return x.dot(form.matrix * x) / 2 + form.linear.dot(x);
  };
  Eigen::VectorXd x = still + 0.1 * some(layout.size());
  x.tail(s.mesh->quadratic_nodes).setZero();
  EXPECT_NEAR(of_form(x) - of_form(still), of_motion(x) - of_motion(still), 1e-12 * of_motion(x));
}

TEST(VariationalStep, lets_the_energy_fall_by_half_of_what_is_dissipated_at_least_however_long) {
  for (const Model model : {Model::SBEH, Model::SSH}) {
    Surface s = ordered_spheroid(0.8, 80);
    VariationalStepper stepper(s.mesh, viscous_material(), model, {});
    double before = energy_in(stepper, s, s.state);
    const Target target = s.target();
    for (const double tau : {1e-3, 0.01, 0.1, 1.}) {
      const FlowStep step = stepper.step(s.state, target, tau);
      ASSERT_TRUE(step.ok()) << tau << " " << describe(step.fault);
      const double after = energy_in(stepper, s, step.state);
      EXPECT_LT(after + tau / 2 * step.dissipation.total(), before) << tau;
      s.state = step.state;
      before = after;
    }
  }
}

// Energies, since the nodes of both are not in the same places. What is left for τ → 0 is of the mesh.
TEST(VariationalStep, has_the_flow_of_the_split_scheme_in_the_first_order_of_its_length) {
  const Material material = viscous_material();
  const Surface s = relaxed_oblate(material, Model::SBEH, 320);
  const double duration = 0.02;
  const auto parts = [&](const State& x) {
    const Energy e = energy(*s.mesh, material, x, curvature_of(*s.mesh, x.X).value());
    return Eigen::Vector3d(e.distortion, e.bending, e.thermotropic);
  };
  const Eigen::Vector3d exact =
      parts(run_of_equal_steps(s, material, Model::SBEH, duration, 20, Method::extrapolated).state);
  VariationalStepper stepper(s.mesh, material, Model::SBEH, {});
  const auto off = [&](int steps) -> Eigen::Vector3d {
    State state = s.state;
    for (int i = 0; i < steps; ++i) {
      const FlowStep step = stepper.step(state, s.target(), duration / steps);
      EXPECT_TRUE(step.ok());
      state = step.state;
    }
    return (parts(state) - exact).cwiseQuotient(exact - parts(s.state));
  };
  const Eigen::Vector3d two = off(2), four = off(4);
  EXPECT_GT(two.cwiseAbs().minCoeff(), 0.03);
  EXPECT_LT((2 * four - two).cwiseAbs().maxCoeff(), 0.02);
}

// What is left of a solution is a thousandth of the tolerance and of the step: both runs are so near to each other.
TEST(VariationalStep, is_with_the_matrix_of_earlier_steps_what_it_is_with_its_own) {
  const Material material = viscous_material();
  const Surface s = relaxed_oblate(material, Model::SBEH, 80);
  Numerics numerics;
  numerics.tolerance = 1e-3;
  const auto after_ten = [&](Factorisation factorisation) {
    numerics.factorisation = factorisation;
    VariationalStepper stepper(s.mesh, material, Model::SBEH, numerics);
    State state = s.state;
    for (int i = 0; i < 10; ++i) {
      const FlowStep step = stepper.step(state, s.target(), 0.01 + 0.001 * i);
      EXPECT_TRUE(step.ok()) << describe(step.fault);
      state = step.state;
    }
    if (factorisation == Factorisation::lagged) {
      EXPECT_GT(stepper.memory().solves, 2);
    }
    return state;
  };
  const State exact = after_ten(Factorisation::every_step),
              lagged = after_ten(Factorisation::lagged);
  const auto largest = [](const State& a, const State& b) {
    return std::max((a.X - b.X).cwiseAbs().maxCoeff(), (a.beta - b.beta).cwiseAbs().maxCoeff());
  };
  const double moved = largest(exact, s.state), apart = largest(exact, lagged);
  EXPECT_GT(moved, 1e-3);
  EXPECT_GT(apart, 0);
  EXPECT_LT(apart, 1e-3 * moved);
}

// The oblate of V_r = 0.8 falls towards the prolate: within the time in which this grows there are steps, in longer ones nothing
// is minimal.
TEST(VariationalStep,
     next_to_a_saddle_has_a_fault_where_it_exceeds_the_time_in_which_perturbations_grow) {
  const Material material = viscous_material();
  const Surface s = ordered_spheroid(0.8, 80);
  NewtonSystem system(*s.mesh, material, Model::SSH);
  const NewtonResult saddle =
      solve_stationary(system, s.target(), guess_from(*s.mesh, material, Model::SSH, s.state));
  ASSERT_EQ(saddle.status, NewtonStatus::converged);
  ASSERT_EQ(saddle.negative_directions, 2);
  const auto rates = growth_rates(material, *s.mesh, Model::SSH, saddle.state, 1);
  ASSERT_TRUE(rates);
  const double time = 1 / rates->front().rate;
  ASSERT_GT(time, 0);
  VariationalStepper stepper(s.mesh, material, Model::SSH, {});
  State state = saddle.state;
  for (const double tau : {0.2 * time, 0.3 * time, 0.9 * time}) {
    const FlowStep step = stepper.step(state, s.target(), tau);
    ASSERT_TRUE(step.ok()) << describe(step.fault);
    state = step.state;
  }
  for (const double tau : {1.1 * time, 10 * time})
    EXPECT_EQ(stepper.step(state, s.target(), tau).fault, model::FlowFault::energy_rises);
  EXPECT_TRUE(stepper.step(state, s.target(), 0.9 * time).ok());
}

TEST(VariationalStep, comes_to_rest_in_few_steps) {
  const Material material = paper_material(0.05);
  const Surface s = ordered_spheroid(0.7, 80);  // a minimum; above 0.75 oblates are saddles
  Numerics numerics;
  numerics.integrator = Integrator::variational;
  numerics.tolerance = 1e-2;
  numerics.largest_step = 10;
  const FlowResult run = run_flow(material, Model::SSH, s.moment(), numerics,
                                  {.end_time = 1000, .output_times = {}, .stop_at_rest = true});
  EXPECT_EQ(run.stop, FlowStop::at_rest);
  EXPECT_LT(run.steps, 40);
  NewtonSystem system(*s.mesh, material, Model::SSH);
  const NewtonResult rest =
      solve_stationary(system, s.target(), guess_from(*s.mesh, material, Model::SSH, run.state));
  ASSERT_EQ(rest.status, NewtonStatus::converged);
  EXPECT_LT((rest.state.X - run.state.X).cwiseAbs().maxCoeff(), 1e-5);
  // As multiplier of the flow λ is −P.
  EXPECT_NEAR(run.last.lambda, -rest.state.pressure, 1e-4);
  // What still moves is the mesh along itself, which changes U by an error of discretisation: 3e-7 in the end.
  EXPECT_NEAR(run.last.energy.total(), energy(material, *s.mesh, rest.state).total(), 1e-6);
}

TEST(VariationalStep, is_not_for_a_global_area_constraint) {
  Numerics numerics;
  numerics.integrator = Integrator::variational;
  EXPECT_THROW(
      run_flow({}, Model::HelfrichGlobal, ordered_spheroid(0.8, 80).moment(), numerics, {}),
      std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::surface3d::test
