// When a run is at rest: relative to how fast its membrane moves, whatever the units.
#include "model/order_step.h"
#include "model/relaxation.h"
#include "tests/axisym/cases.h"

#include <functional>

namespace sbeh::axisym {
namespace {

using namespace test;

struct Slow {
  const char* what;
  std::function<void(Material&)> change;
};

FlowResult spheroid_run(const Material& material, Model model, const Numerics& numerics,
                        double end_time) {
  return run_flow(material, model, ordered_spheroid(0.8, numerics.elements), target_of(0.8),
                  numerics, {.end_time = end_time, .output_times = {}});
}

TEST(Rest, is_not_where_a_membrane_is_only_slow) {
  const std::vector<Slow> cases{
      {"L = 4e-20", [](Material& m) { m = m.with_L(4e-20); }},
      {"L = 1e-9", [](Material& m) { m = m.with_L(1e-9); }},
      {"viscosity 1000", [](Material& m) { m.viscosity = 1000; }},
      {"viscosity 1e4", [](Material& m) { m.viscosity = 1e4; }},
      {"viscosity 1e8", [](Material& m) { m.viscosity = 1e8; }},
      {"frictions 1e6", [](Material& m) { m.friction_normal = m.friction_tangential = 1e6; }},
      {"order viscosity 300", [](Material& m) { m.order_viscosity = 300; }},
      {"all energies times 1e-8",
       [](Material& m) {
         m = m.with_L(5e-10);
         m.potential = model::Potential::landau_de_gennes(0, -27e-8, 13.5e-8);
       }},
  };
  for (const Model model : {Model::SBEH, Model::SSH})
    for (const auto& [what, change] : cases) {
      Material material;
      change(material);
      const FlowResult run = spheroid_run(material, model, with_elements(16), 0.3);
      EXPECT_EQ(run.stop, FlowStop::end_time) << what << ", " << name(model);
    }
}

TEST(Rest, is_where_the_order_has_come_to_rest_too) {
  // The sphere cannot move; its order, disturbed, comes to rest with the rate 18/M. What is left of the way is
  // the speed of rest over that rate, or less where the shape would be slower.
  const double left = Numerics().rest_speed / model::relaxation_rate({}, Model::SBEH);
  for (const double immobility : {1., 100., 1e4}) {
    Material material = paper_material(0.05);
    material.immobility = immobility;
    State start = ordered_spheroid(1, 16);
    start.beta.setConstant(0.6);
    Numerics numerics = with_elements(16);
    numerics.largest_step = 0.05 * immobility;
    const FlowResult run = run_flow(material, Model::SBEH, start, target_of(1), numerics,
                                    {.end_time = 10 * immobility, .output_times = {}});
    EXPECT_EQ(run.stop, FlowStop::at_rest) << immobility;
    EXPECT_NEAR(run.state.beta.mean(), *model::sphere_rest_order(material), left) << immobility;
  }
}

struct Unit {
  double energy, time;  // of the material, in those of the default
};

TEST(Rest, comes_at_the_same_state_in_any_units_of_energy_and_time) {
  const FlowResult in_default =
      spheroid_run(paper_material(0.05), Model::SBEH, with_elements(16), 50);
  ASSERT_EQ(in_default.stop, FlowStop::at_rest);
  for (const auto& [energy, time] :
       std::vector<Unit>{{1e-3, 1e3}, {1, 100}, {1e3, 1e-2}, {1e-3, 1}}) {
    Material m = paper_material(0.05 * energy);
    m.potential = model::Potential::landau_de_gennes(0, -27 * energy, 13.5 * energy);
    for (double* drag : {&m.viscosity, &m.immobility, &m.friction_normal, &m.friction_tangential})
      *drag *= energy * time;
    Numerics numerics = with_elements(16);
    numerics.first_step *= time;
    numerics.largest_step *= time;
    numerics.smallest_step *= time;
    const FlowResult run = spheroid_run(m, Model::SBEH, numerics, 50 * time);
    ASSERT_EQ(run.stop, FlowStop::at_rest) << energy << ' ' << time;
    // But for the mesh, whose time to settle is not in units of the membrane: 0.02 of about 10, and its error.
    EXPECT_NEAR(run.last.time / (time * in_default.last.time), 1, 0.01);
    EXPECT_NEAR(run.last.energy.total() / (energy * in_default.last.energy.total()), 1, 1e-6);
  }
}

}  // namespace
}  // namespace sbeh::axisym
