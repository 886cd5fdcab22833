// Scans over further numbers of the material: what is read, refused, and left in the folder.
#include "studies/scan/scan_stack.h"

#include "studies/io/csv.h"
#include "studies/scan/scan_cost.h"
#include "tests/studies/parameters/input_file.h"
#include "tests/temporary_folder.h"

namespace sbeh::studies {
namespace {

using namespace test;

const std::string stack =
    "[scan]\nmodels = ['SSH']\nmodes = 0\nL = 0.05\n"
    "axes = { reduced_volume = [0.8, 0.9], H0 = [-0.2, 0, 0.2] }\n";

TEST(ScanAxes, are_read_back_from_their_description) {
  for (const std::string& text :
       {stack,
        std::string("[scan]\nreduced_volume = 0.8\nmodels = ['SBEH']\n"
                    "axes = { L = [0.01, 0.05], flexoelectric_1 = [0, 0.1], L2 = 0.01 }\n")}) {
    const ScanInput input = read_scan(written(text));
    EXPECT_EQ(read_scan(written(describe(input, "1.2.3"))), input);
  }
  EXPECT_EQ(point_count(read_scan(written(stack))), 6U);
}

TEST(ScanAxes, that_are_wrong_are_refused) {
  expect_messages(
      read_scan, "[scan]\nreduced_volume = 0.8\nL = 0.05\n",
      {{"axes = { L = 0.01 }", ":3: [scan] L = 0.05: must not be given twice: it is among axes"},
       {"axes = { H0 = 0.1 }\n[material]\nspontaneous_curvature = 1",
        ":6: [material] spontaneous_curvature = 1: must not be given: H0 is among the axes of the "
        "scan"},
       {"axes = { W2 = -26 }", ":4: [scan] axes.W2 = -26: needs area_difference in [material]"},
       {"axes = { kappa_0 = 1 }\nmodels = ['SBEH']",
        ":4: [scan] axes.kappa_0 = 1: needs kappa in [material]"},
       {"axes = { flexoelectric_0 = 1 }",
        ":4: [scan] axes.flexoelectric_0 = 1: needs models = [\"SBEH\"]: SSH, of uniform order, "
        "has "
        "all its shapes by spontaneous_curvature"},
       {"axes = { potential_4 = -1 }",
        ":4: [scan] axes.potential_4 = -1: is no potential bounded below at -1"},
       {"axes = { L2 = -1 }",
        ":4: [scan] axes.L2 = -1: is no material at -1: 6 L1 + L2 + L3 = -0.7: must be > 0 "
        "(distortion energy)"}});
}

// States with a spontaneous curvature are followed to it: of three layers two cost more.
TEST(ScanAxes, cost_what_their_layers_cost) {
  const ScanInput input = read_scan(written(stack));
  const std::vector<ScanLayer> layers = layers_of(input);
  ASSERT_EQ(layers.size(), 3U);
  const double plain = seconds_of(layers[1].input), curved = seconds_of(layers[0].input);
  EXPECT_GT(curved, 1.5 * plain);
  EXPECT_NEAR(seconds_of(input), plain + 2 * curved, 1e-12);
}

TEST(ScanAxes, leave_the_tables_of_all_layers) {
  const sbeh::test::TemporaryFolder folder;
  const ScanInput input = read_scan(written(stack));
  const ScanSummary first = run_scan(input, folder.path() / "a", "1.2.3");
  EXPECT_EQ(first.points, 6);
  EXPECT_EQ(first.stationary, 6);
  const CsvTable table = read_csv(folder.path() / "a/scan.csv");
  ASSERT_EQ(table.rows.size(), 6U);
  const auto column = [&](const char* name, std::size_t row) {
    return table.rows[row][table.find(name).value()];
  };
  EXPECT_EQ(table.columns.front(), "H0");
  EXPECT_EQ(column("H0", 0), "-0.2");
  EXPECT_EQ(column("H0", 5), "0.2");
  EXPECT_EQ(column("reduced_volume", 5), "0.9");
  // Each as a scan of its own with this H₀ has it.
  ScanInput one = layers_of(input)[2].input;
  EXPECT_EQ(one.material.spontaneous_curvature, 0.2);
  run_scan(one, folder.path() / "b", "1.2.3");
  const CsvTable alone = read_csv(folder.path() / "b/scan.csv");
  EXPECT_EQ(alone.rows[1][alone.find("energy").value()], column("energy", 5));
  // Nothing is computed twice.
  EXPECT_EQ(run_scan(input, folder.path() / "a", "1.2.3").computed, 0);
}

}  // namespace
}  // namespace sbeh::studies
