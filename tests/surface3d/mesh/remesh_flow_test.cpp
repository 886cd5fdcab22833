// A run that goes on with new triangles.
#include "surface3d/mesh/remesh.h"
#include "tests/surface3d/cases.h"

namespace sbeh::surface3d {
namespace {

using namespace test;

TEST(RemeshedRun, goes_on_downhill_to_the_energy_of_the_run_with_the_old_triangles) {
  const Material material = paper_material(0.05);
  const auto go_on = [&](const Surface& from, double duration, int steps) -> Surface {
    return {from.mesh,
            run_of_equal_steps(from, material, Model::SBEH, duration, steps, Method::extrapolated)
                .state};
  };
  const Surface old = go_on(ordered_spheroid(0.8, 320), 0.02, 20);
  const RemeshResult fresh =
      remesh(*old.mesh, old.state, material, {.triangles = 320, .grading = 0});
  ASSERT_TRUE(fresh.mesh) << fresh.refusal;
  const double before = energy_of(*old.mesh, material, old.state);
  const double after_old = energy_of(*old.mesh, material, go_on(old, 0.004, 4).state);
  const double after_new =
      energy_of(*fresh.mesh, material, go_on({fresh.mesh, fresh.state}, 0.004, 4).state);
  std::printf("energy %.6f, remeshed %.6f; later %.6f, remeshed %.6f\n", before,
              fresh.report.energy_after, after_old, after_new);
  EXPECT_LT(after_new, fresh.report.energy_after);
  EXPECT_LT(after_new, before);
  // What the transfer adds are short waves, which decay: less than half of it is left.
  EXPECT_LT(std::abs(after_new - after_old), std::abs(fresh.report.energy_after - before) / 2);
}

}  // namespace
}  // namespace sbeh::surface3d
