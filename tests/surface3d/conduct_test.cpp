// What a step and a run do with states and steps that are no good.
#include "tests/surface3d/cases.h"

#include <limits>
#include <stdexcept>

namespace sbeh::surface3d {
namespace {

using namespace test;

using model::FlowFault;
constexpr auto every_step = Factorisation::every_step;  // equal bits need equal factors
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Step, of_a_state_with_a_number_that_is_none_is_not_ok_and_leaves_no_trace) {
  const Surface s = ordered_spheroid(0.8, 80);
  const Material material = paper_material(0.05);
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
    TimeStepper stepper(s.mesh, material, Model::SBEH, numerics_of(scheme, every_step)),
        fresh(s.mesh, material, Model::SBEH, numerics_of(scheme, every_step));
    State lost = s.state, disordered = s.state;
    lost.X(2, 17) = nan;
    disordered.beta[5] = nan;
    EXPECT_EQ(stepper.step(lost, s.target(), 1e-3).fault, FlowFault::degenerate);
    EXPECT_EQ(stepper.step(disordered, s.target(), 1e-3).fault, FlowFault::linear_solve);
    EXPECT_EQ(stepper.step(s.state, s.target(), nan).fault, FlowFault::linear_solve);
    const FlowStep a = stepper.step(s.state, s.target(), 1e-3),
                   b = fresh.step(s.state, s.target(), 1e-3);
    ASSERT_TRUE(a.ok() && b.ok());
    EXPECT_TRUE(a.state.X == b.state.X);
    EXPECT_TRUE(a.state.beta == b.state.beta);
  }
}

TEST(Step, of_a_collapsed_surface_is_not_ok) {
  const Surface s = ordered_spheroid(0.8, 80);
  State flat = s.state;
  flat.X.setZero();
  TimeStepper stepper(s.mesh, paper_material(0.05), Model::SSH);
  EXPECT_EQ(stepper.step(flat, s.target(), 1e-3).fault, FlowFault::degenerate);
}

TEST(Step, that_turns_triangles_over_is_not_ok) {
  const Surface s = ordered_spheroid(0.8, 80);
  const Target squeezed{s.target().area, 0.1 * s.target().volume};
  for (const Model model : {Model::SSH, Model::SBEH}) {
    const Numerics numerics = numerics_of(Scheme::split, every_step);
    TimeStepper stepper(s.mesh, paper_material(0.05), model, numerics),
        fresh(s.mesh, paper_material(0.05), model, numerics);
    const FlowStep large = stepper.step(s.state, s.target(), 1);
    ASSERT_TRUE(large.ok());
    EXPECT_GT(mesh_quality(*s.mesh, large.state.X), degenerate_quality);
    for (const double tau : {1., 1e4, 1e8}) EXPECT_FALSE(stepper.step(s.state, squeezed, tau).ok());
    const FlowStep a = stepper.step(s.state, s.target(), 1e-3),
                   b = fresh.step(s.state, s.target(), 1e-3);
    ASSERT_TRUE(a.ok() && b.ok());
    EXPECT_TRUE(a.state.X == b.state.X);
    EXPECT_TRUE(a.state.beta == b.state.beta);
  }
}

TEST(Flow, forgets_rejected_steps) {
  const Surface s = ordered_spheroid(0.8, 320);
  const Material material = paper_material(0.05);
  const auto first_step = [&](double tried) {
    Numerics numerics;
    numerics.tolerance = 1e-3;
    numerics.first_step = tried;
    numerics.factorisation = every_step;
    return run_flow(
        material, Model::SBEH, s.moment(), numerics, {.end_time = 1, .output_times = {}},
        [](const FlowRecord& r, const State&, const StepView&, bool) { return r.time == 0; });
  };
  const FlowResult rejecting = first_step(0.05);
  EXPECT_EQ(rejecting.stop, FlowStop::interrupted);
  EXPECT_GT(rejecting.last.rejected, 0);
  const FlowResult at_once = first_step(rejecting.last.time_step);
  EXPECT_EQ(at_once.last.rejected, 0);
  EXPECT_TRUE(rejecting.state.X == at_once.state.X);
  EXPECT_TRUE(rejecting.state.beta == at_once.state.beta);
}

TEST(Flow, keeps_area_and_volume_to_rounding_while_the_energy_falls) {
  const Surface s = ordered_spheroid(0.8, 320);
  const Target target = s.target();
  double before = std::numeric_limits<double>::infinity();
  Numerics numerics;
  numerics.tolerance = 1e-3;
  const FlowResult run = run_flow(paper_material(0.05), Model::SBEH, s.moment(), numerics,
                                  {.end_time = 0.02, .output_times = {}},
                                  [&](const FlowRecord& r, const State& x, const StepView&, bool) {
                                    EXPECT_NEAR(area(*s.mesh, x.X) / target.area, 1, 1e-12);
                                    EXPECT_NEAR(volume(*s.mesh, x.X) / target.volume, 1, 1e-12);
                                    EXPECT_LT(r.energy.total(), before);
                                    before = r.energy.total();
                                    return true;
                                  });
  EXPECT_EQ(run.stop, FlowStop::end_time);
  std::printf("%d steps, %d rejected\n", run.steps, run.last.rejected);
}

TEST(Flow, stops_when_the_step_it_may_take_is_too_large_for_the_tolerance) {
  const Surface s = ordered_spheroid(0.8, 80);
  Numerics numerics;
  numerics.tolerance = 1e-12;
  numerics.first_step = numerics.smallest_step = numerics.largest_step = 1e-2;
  const FlowResult run = run_flow(paper_material(0.05), Model::SSH, s.moment(), numerics,
                                  {.end_time = 1, .output_times = {}});
  EXPECT_EQ(run.stop, FlowStop::step_too_small);
  EXPECT_EQ(run.fault, FlowFault::error);
  EXPECT_EQ(run.steps, 0);
  EXPECT_TRUE(run.state.X == s.state.X);
}

TEST(Flow, is_not_at_rest_because_its_membrane_is_slow) {
  const auto with = [](auto change) {
    Material m;
    change(m);
    return m;
  };
  const std::vector<Material> slow{
      paper_material(4e-20),
      with([](Material& m) { m.viscosity = 1e8; }),
      with([](Material& m) { m.friction_normal = m.friction_tangential = 1e9; }),
      with([](Material& m) {
        m = m.with_L(5e-11);
        m.potential = model::Potential::landau_de_gennes(0, -27e-9, 13.5e-9);
      }),
  };
  const Surface s = ordered_spheroid(0.8, 80);
  for (const Model model : {Model::SBEH, Model::SSH})
    for (const Material& material : slow) {
      const FlowResult run =
          run_flow(material, model, s.moment(), {}, {.end_time = 0.01, .output_times = {}});
      EXPECT_EQ(run.stop, FlowStop::end_time)
          << name(model) << " L = " << material.L1 << ", viscosity " << material.viscosity;
    }
}

TEST(CorrectAreaVolume, reaches_what_is_asked_or_leaves_the_surface_alone) {
  Surface s = ordered_spheroid(0.8, 80);
  const Target t = s.target();
  Nodes X = s.state.X;
  ASSERT_TRUE(correct_area_volume(*s.mesh, X, t.area * 1.001, t.volume * 0.999));
  EXPECT_NEAR(area(*s.mesh, X) / t.area, 1.001, 2e-12);
  EXPECT_NEAR(volume(*s.mesh, X) / t.volume, 0.999, 2e-12);
  X = s.state.X;
  EXPECT_FALSE(correct_area_volume(*s.mesh, X, t.area, t.volume * 2));  // more than a sphere holds
  EXPECT_TRUE(X == s.state.X);
  EXPECT_FALSE(correct_area_volume(*s.mesh, X, nan, t.volume));
  EXPECT_TRUE(X == s.state.X);
}

TEST(Diagnostics, of_a_degenerate_surface_throw) {
  Surface s = ordered_spheroid(0.8, 80);
  s.state.X(0, 3) = nan;
  EXPECT_THROW(diagnose(*s.mesh, paper_material(0.05), s.state), std::runtime_error);
}

TEST(MeshQuality, is_one_for_flat_equilateral_triangles_and_negative_where_one_is_turned_over) {
  const Surface s = uniform_sphere(0, 20);
  Nodes flat = s.state.X;
  const Eigen::Matrix2Xd at = (Eigen::Matrix2Xd(2, 10) << 0, 3, 0, 1, 2, 2, 1, 0, 0, 1,  //
                               0, 0, 3, 0, 0, 1, 2, 2, 1, 1)
                                  .finished()
                            / 3;
  for (int e = 0; e < s.mesh->count(); ++e) {
    const ElementNodes x = on_element(*s.mesh, e, s.state.X);
    for (int a = 0; a < 10; ++a)
      flat.col(s.mesh->triangles(a, e)) =
          (1 - at.col(a).sum()) * x.col(0) + at(0, a) * x.col(1) + at(1, a) * x.col(2);
  }
  EXPECT_NEAR(mesh_quality(*s.mesh, flat), 1, 1e-13);
  EXPECT_GT(mesh_quality(*s.mesh, s.state.X), 0.5);
  Nodes folded = s.state.X;
  folded.col(s.mesh->triangles(9, 0)) += 2 * (folded.col(0) - folded.col(s.mesh->triangles(9, 0)));
  EXPECT_LT(mesh_quality(*s.mesh, folded), 0);
}

TEST(Numerics, refuse_values_out_of_range) {
  EXPECT_NO_THROW(Numerics{}.validate());
  const auto refused = [](auto member, double value) {
    Numerics n;
    n.*member = value;
    EXPECT_THROW(n.validate(), std::invalid_argument) << value;
  };
  refused(&Numerics::tolerance, 0.);
  refused(&Numerics::tolerance, nan);
  refused(&Numerics::first_step, 0.);
  refused(&Numerics::smallest_step, 0.5);
  refused(&Numerics::rest_speed, 0.);
}

}  // namespace
}  // namespace sbeh::surface3d
