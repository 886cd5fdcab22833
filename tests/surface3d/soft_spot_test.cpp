// Where the order nearly vanishes and the layer is soft, steps are corrected once.
#include "tests/surface3d/cases.h"

namespace sbeh::surface3d {
namespace {

using namespace test;

// An oblate with a soft rim. The order is held where it is: it hardly moves.
struct SoftRim {
  Surface surface = ordered_spheroid(0.6, 320);
  Material material = paper_material(0.05);

  SoftRim() {
    material.immobility = 1e4;
    material.residual_stiffness = 0.004;
    const Eigen::VectorXd r = surface.state.X.topRows<2>().colwise().norm();
    for (Eigen::Index i = 0; i < r.size(); ++i) {
      const double inside = (r.maxCoeff() - r[i]) / 0.15;
      surface.state.beta[i] = 0.02 + (model::full_order - 0.02) * (1 - std::exp(-inside * inside));
    }
  }
  // Equal steps of 0.03, whatever their error.
  FlowResult run(int steps, const FlowMoment& start, const FlowObserver& observe) const {
    Numerics numerics;
    numerics.tolerance = 1e9;
    numerics.first_step = numerics.largest_step = 0.03;
    return run_flow(material, Model::SBEH, start, numerics,
                    {.end_time = 0.03 * steps, .output_times = {}, .stop_at_rest = false}, observe);
  }
};

// Without the correction the rim wavers for good: its speed is 0.05 at that time and later.
TEST(SoftSpot, the_rim_comes_to_rest) {
  const SoftRim rim;
  const FlowResult run = rim.run(16, rim.surface.moment(), {});
  ASSERT_EQ(run.stop, FlowStop::end_time);
  EXPECT_LT(run.last.normal_speed, 2e-3);
}

TEST(SoftSpot, a_resumed_run_repeats_every_bit) {
  const SoftRim rim;
  FlowMoment middle = rim.surface.moment();
  const FlowResult whole =
      rim.run(6, rim.surface.moment(),
              [&](const FlowRecord& record, const State& state, const StepView& view, bool) {
                if (record.time >= 0.1) return true;
                middle.state = state;
                middle.record = record;
                middle.memory = view.memory;
                return true;
              });
  const FlowResult resumed = rim.run(6, middle, {});
  ASSERT_EQ(whole.steps, 6);
  ASSERT_EQ(resumed.steps, 3);
  EXPECT_TRUE((whole.state.X.array() == resumed.state.X.array()).all());
  EXPECT_TRUE((whole.state.beta.array() == resumed.state.beta.array()).all());
}

}  // namespace
}  // namespace sbeh::surface3d
