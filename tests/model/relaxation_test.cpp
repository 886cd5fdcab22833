// At what speed a membrane is at rest: in proportion to how fast it relaxes.
#include "model/relaxation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sbeh::model {
namespace {

struct Named {
  std::string what;
  Material material;
};

template <class Change>
Named changed(const char* what, Change&& change) {
  Material m;
  change(m);
  return {what, m};
}

// Each relaxes more slowly than the default.
std::vector<Named> slow_materials() {
  return {
      changed("L = 4e-20", [](Material& m) { m = m.with_L(4e-20); }),
      changed("L = 1e-4", [](Material& m) { m = m.with_L(1e-4); }),
      changed("viscosity 1000", [](Material& m) { m.viscosity = 1000; }),
      changed("viscosity 1e4", [](Material& m) { m.viscosity = 1e4; }),
      changed("friction_normal 1e4", [](Material& m) { m.friction_normal = 1e4; }),
      changed("friction_tangential 1e4", [](Material& m) { m.friction_tangential = 1e4; }),
      changed("order_viscosity 100", [](Material& m) { m.order_viscosity = 100; }),
  };
}

std::vector<Named> materials() {
  std::vector<Named> all = slow_materials();
  all.push_back({"default", {}});
  all.push_back(changed("immobility 1e5", [](Material& m) { m.immobility = 1e5; }));
  all.push_back(changed("eta(2/3) = 0", [](Material& m) { m.order_viscosity = -3; }));
  all.push_back(changed("melted", [](Material& m) { m = m.with_L(2); }));
  all.push_back(changed("three constants, k0, H0", [](Material& m) {
    m.L2 = 0.02, m.L3 = -0.03, m.residual_stiffness = 0.01, m.spontaneous_curvature = -2.4;
  }));
  all.push_back(changed("one well", [](Material& m) { m.potential = Potential({5, -18, 13.5}); }));
  return all;
}

constexpr auto models = {Model::SBEH, Model::SSH, Model::HelfrichLocal, Model::HelfrichGlobal};

Material with_energies_times(double c, Material m) {
  for (double* energy : {&m.L1, &m.L2, &m.L3, &m.residual_stiffness}) *energy *= c;
  std::vector<double> u = m.potential.coefficients();
  for (double& coefficient : u) coefficient *= c;
  m.potential = Potential(u);
  return m;
}

Material with_drags_times(double c, Material m) {
  for (double* drag : {&m.viscosity, &m.immobility, &m.friction_normal, &m.friction_tangential})
    *drag *= c;
  return m;
}

TEST(RelaxationRate, grows_with_all_energies_and_falls_with_all_drags) {
  for (const auto& [what, m] : materials())
    for (const Model model : models)
      for (const double c : {1e-9, 0.03, 7., 1e6}) {
        const double rate = relaxation_rate(m, model);
        ASSERT_GT(rate, 0) << what;
        EXPECT_NEAR(relaxation_rate(with_energies_times(c, m), model) / (c * rate), 1, 1e-9)
            << what << ' ' << name(model) << ' ' << c;
        if (!has_own_drag(model)) {
          EXPECT_NEAR(relaxation_rate(with_drags_times(c, m), model) * c / rate, 1, 1e-9)
              << what << ' ' << name(model) << ' ' << c;
        }
      }
}

TEST(SpeedAtRest, is_the_number_asked_for_with_the_default_material) {
  EXPECT_EQ(speed_at_rest(1e-6, {}, Model::SBEH), 1e-6);
  EXPECT_NEAR(speed_at_rest(1e-6, {}, Model::SSH), 1e-6, 0.1e-6);
  EXPECT_EQ(speed_at_rest(1e-5, {}, Model::SBEH), 1e-5);
}

TEST(SpeedAtRest, is_lower_where_the_shape_moves_slowly_by_itself) {
  for (const auto& [what, m] : slow_materials())
    for (const Model model : {Model::SBEH, Model::SSH})
      EXPECT_LT(speed_at_rest(1e-6, m, model), 1e-8) << what;
}

TEST(SpeedAtRest, is_lower_where_the_order_changes_slowly_by_itself) {
  Material m;
  m.immobility = 1e5;
  EXPECT_LT(speed_at_rest(1e-6, m, Model::SBEH), 1e-8);
  EXPECT_EQ(speed_at_rest(1e-6, m, Model::SSH), speed_at_rest(1e-6, {}, Model::SSH));
}

}  // namespace
}  // namespace sbeh::model
