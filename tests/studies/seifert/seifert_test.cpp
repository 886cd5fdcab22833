// The classical diagram as `sbeh seifert` leaves it: what of its shapes is a minimum without an axis too.
#include "studies/seifert/seifert.h"

#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using axisym::Parity;

TEST(Seifert, has_the_limits_of_stability_of_its_branches) {
  const sbeh::test::TemporaryFolder folder;
  const auto results = folder.path() / "seifert";
  run_seifert(results, 48);
  const auto limits = read_rows(classical_threshold_columns(), results / "stability_lines.csv");
  ASSERT_EQ(limits.size(), 2u);
  const auto expect = [](const ClassicalThreshold& limit, int m, Parity parity, double volume) {
    EXPECT_EQ(limit.branch, Branch::oblate);
    EXPECT_EQ(limit.m, m);
    EXPECT_EQ(limit.parity, parity);
    EXPECT_NEAR(limit.point.reduced_volume, volume, 1e-9);
    EXPECT_LE(limit.point.error, 1e-9);
  };
  expect(limits[0], 2, Parity::even, 0.749729050);
  expect(limits[1], 0, Parity::odd, 0.510438922);

  int told = 0;
  for (const BranchRow& row : read_rows(branch_columns(), results / "branches.csv")) {
    if (!row.modes.negative_directions) continue;  // of slender shapes 48 elements do not tell
    ++told;
    EXPECT_EQ(row.witness, "elements");
    const double v = row.shape.reduced_volume;
    const bool is_oblate = row.shape.branch == Branch::oblate;
    const int expected = is_oblate && v > 0.74973 ? 2 : is_oblate && v < 0.5104 ? 1 : 0;
    EXPECT_EQ(row.modes.negative_directions, expected) << name(row.shape.branch) << ' ' << v;
  }
  EXPECT_GE(told, 45);
}

}  // namespace
}  // namespace sbeh::studies
