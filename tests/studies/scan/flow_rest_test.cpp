// The evolutions of a scan with method = "flow": what is slow is not stationary.
#include "studies/scan/branch_points.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using model::Model;

PointOutcome evolved(const model::Material& material, Model model, Branch branch, double end_time) {
  axisym::StationaryCase of{.model = model, .branch = branch, .reduced_volume = 0.8};
  of.material = material;
  of.numerics.elements = 16;
  of.numerics.tolerance = 1e-4;
  std::vector<SeriesRow> history;
  const auto point = flow_to_rest(of, end_time, history);
  EXPECT_TRUE(point);
  return point.value_or(failed_point(""));
}

TEST(Evolution, of_a_slow_membrane_that_has_not_come_to_rest_is_not_called_stationary) {
  std::vector<model::Material> slow(5);
  slow[0] = slow[0].with_L(4e-20);
  slow[1].viscosity = 1000;
  slow[2].viscosity = 1e4;
  slow[3].friction_normal = slow[3].friction_tangential = 1e5;
  slow[4] = slow[4].with_L(1e-7);
  for (const Model model : {Model::SSH, Model::SBEH})
    for (const Branch branch : {Branch::oblate, Branch::prolate})
      for (std::size_t k = 0; k < slow.size(); ++k) {
        const PointOutcome point = evolved(slow[k], model, branch, 1);
        EXPECT_EQ(point.row.status, PointStatus::unresolved) << name(model) << ' ' << k;
        EXPECT_EQ(point.row.stop_reason, "end time reached at t = 1");
      }
  EXPECT_EQ(evolved({}, Model::SSH, Branch::oblate, 100).row.status, PointStatus::stationary);
}

}  // namespace
}  // namespace sbeh::studies
