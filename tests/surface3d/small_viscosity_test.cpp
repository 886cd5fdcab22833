// With little viscosity, or none, nothing damps a flow along the surface at the scale of the mesh.
#include "tests/surface3d/cases.h"

#include <limits>
#include <ostream>

namespace sbeh::surface3d {
namespace {

using namespace test;

struct Case {
  Model model;
  double viscosity, friction, order_viscosity;
  int triangles;
};
std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << name(c.model) << ", viscosity " << c.viscosity << ", friction " << c.friction
             << ", order viscosity " << c.order_viscosity << ", " << c.triangles << " triangles";
}

class SmallViscosity : public testing::TestWithParam<Case> {};

TEST_P(SmallViscosity, lets_the_energy_fall_in_the_default_scheme) {
  const Case& c = GetParam();
  Material m = paper_material(0.05);
  m.viscosity = c.viscosity;
  m.friction_tangential = m.friction_normal = c.friction;
  m.order_viscosity = c.order_viscosity;
  const FlowResult run = run_flow(m, c.model, ordered_spheroid(0.8, c.triangles).moment(),
                                  Numerics{}, {.end_time = 0.5, .output_times = {}});
  std::printf("%d steps, %d rejected, U = %.6f\n", run.steps, run.last.rejected,
              run.last.energy.total());
  EXPECT_EQ(run.stop, FlowStop::end_time);
  EXPECT_EQ(run.last.rises.sum, 0);
  EXPECT_LE(run.last.rejected, 3);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SmallViscosity,
    testing::Values(Case{Model::SSH, 0.01, 0.1, 0, 180}, Case{Model::SSH, 0.001, 1, 0, 80},
                    Case{Model::SSH, 0.001, 1, 0, 320}, Case{Model::SSH, 1e-5, 0.1, 0, 180},
                    Case{Model::SSH, 0, 0.1, 0, 180}, Case{Model::SBEH, 1, 0.1, -3, 180},
                    Case{Model::SBEH, 0.01, 0.1, 0, 180}, Case{Model::SBEH, 0, 0.1, 0, 80}));

}  // namespace
}  // namespace sbeh::surface3d
