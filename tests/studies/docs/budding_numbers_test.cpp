// What studies/docs/budding.md has of the sharp interface, computed anew; tests/axisym/budding_test.cpp has the interfaces with a width.
#include "tests/axisym/shooting/two_domains.h"
#include "tests/studies/docs/document.h"

namespace sbeh::studies {
namespace {

using namespace test;

axisym::shooting::TwoDomainVesicle soft_cap(double line_tension, double gauss_jump,
                                            double reduced_volume) {
  return axisym::shooting::open_vesicle({.fraction = 0.2,
                                         .kappa_a = 0.2,
                                         .gauss_jump = gauss_jump,
                                         .line_tension = line_tension,
                                         .reduced_volume = reduced_volume});
}

TEST(BuddingTables, have_the_sharp_interface_of_shooting) {
  const auto folds = table_below("studies/docs/budding.md", "| λ | V_r of the fold |");
  ASSERT_EQ(folds.size(), 6u);
  for (std::size_t k = 0; k + 1 < folds.size(); ++k) {
    SCOPED_TRACE(folds[k][0]);
    const auto end = soft_cap(std::stod(folds[k][0]), 0, 0.785);
    ASSERT_EQ(end.is_fold, k > 0);
    if (k == 0) continue;
    expect_printed(folds[k][1], end.reduced_volume, 1e-8);
    expect_printed(folds[k][2], end.neck_radius, 1e-6);
  }
  const auto widths = table_below("studies/docs/budding.md", "| w | V_r of the fold |");
  ASSERT_EQ(widths.back()[0], "sharp");
  const auto fold = soft_cap(2.6, 0, 0.785), open = soft_cap(2.6, 0, 0.82);
  expect_printed(widths.back()[1], fold.reduced_volume, 1e-8);
  expect_printed(widths.back()[2], fold.energy, 1e-7);
  expect_printed(widths.back()[3], open.energy, 1e-7);
  for (const auto& row : table_below("studies/docs/budding.md", "| Δ | w |")) {
    if (row[1] != "sharp") continue;
    const auto moved = soft_cap(2.6, printed(row[0]).value, 0.82);
    expect_printed(row[2], moved.neck_offset, 1e-6);
    expect_printed(row[3], moved.neck_radius, 1e-6);
    expect_printed(row[4], moved.energy, 1e-7);
  }
}

}  // namespace
}  // namespace sbeh::studies
