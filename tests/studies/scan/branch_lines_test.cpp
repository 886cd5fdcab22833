// The lines of the diagram: folds and equal energies, as a scan leaves them.

#include "studies/scan/branch_lines.h"

#include "axisym/shooting/seifert_shooting.h"
#include "studies/scan/scan.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;

struct Lines {
  std::vector<FoldRow> folds;
  std::vector<EqualEnergyRow> meetings;
};
Lines lines_of(ScanInput input, int elements) {
  input.numerics.elements = elements;
  const sbeh::test::TemporaryFolder folder;
  const fs::path scan = folder.path() / "scan";
  const ScanSummary summary = run_scan(input, scan, "test");
  EXPECT_EQ(summary.failed, 0);
  return {read_rows(fold_columns(), scan / "folds.csv"),
          input.branches.size() > 1 ? read_rows(equal_energy_columns(), scan / "equal_energy.csv")
                                    : std::vector<EqualEnergyRow>{}};
}

TEST(FoldLine, of_the_oblates_is_found_to_four_digits_and_does_not_move_under_refinement) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.65, 0.7, 0.75, 0.8};
  input.L = {0.05};
  input.models = {model::Model::SBEH};
  const auto coarse = lines_of(input, 48).folds, fine = lines_of(input, 72).folds;
  ASSERT_EQ(coarse.size(), 5u);
  ASSERT_EQ(fine.size(), 5u);
  double before = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const double L = coarse[k].L, refined = fine[k].L;
    std::printf("  V_r = %g: L* = %.9f, with 72 elements %.9f\n", coarse[k].reduced_volume, L,
                refined);
    EXPECT_NEAR(L / refined, 1, 1e-6);
    EXPECT_GT(L, before);  // rounder shapes hold out longer
    before = L;
  }
  EXPECT_NEAR(fine[0].L, 0.070637, 1e-6);  // one percent above the paper's largest L
}

TEST(EqualEnergies, of_oblate_and_prolate_start_at_the_classical_point_and_are_exact) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.65, 0.7, 0.75};
  input.L = {1e-6, 0.01, 0.05, 0.09};
  input.models = {model::Model::SBEH};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate};
  const auto coarse = lines_of(input, 48).meetings, fine = lines_of(input, 72).meetings;
  ASSERT_EQ(coarse.size(), 4u);
  ASSERT_EQ(fine.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(coarse[k].first, axisym::Branch::oblate);
    EXPECT_EQ(coarse[k].second, axisym::Branch::prolate);
    EXPECT_NEAR(coarse[k].reduced_volume, fine[k].reduced_volume, 1e-6) << "L = " << coarse[k].L;
    std::printf("  L = %g: V_r = %.9f\n", fine[k].L, fine[k].reduced_volume);
  }
  // As L → 0 the order is full and the shapes are the classical ones; the distance is linear in L.
  const double classical = axisym::shoot_special_points().prolate_oblate.reduced_volume;
  EXPECT_NEAR(fine[0].reduced_volume, classical, 1e-6);
}

// Row by row: the table's lowest branch against the rows of scan.csv.
TEST(LowestBranch, is_that_of_least_energy_among_the_stationary_ones) {
  ScanInput input;
  input.reduced_volume = {0.45, 0.6, 0.7};
  input.L = {0.02, 0.06};
  input.models = {model::Model::SBEH, model::Model::SSH};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate};
  input.numerics.elements = 32;
  const sbeh::test::TemporaryFolder folder;
  run_scan(input, folder.path() / "scan", "test");
  const auto lowest = read_rows(lowest_columns(), folder.path() / "scan/lowest.csv");
  const ScanTable table = scan_table(OutputFolder(folder.path() / "scan"));
  EXPECT_EQ(lowest.size(), 12u);
  for (const auto& [model, L, v, lowest_branch, energy] : lowest)
    for (const axisym::Branch branch : input.branches) {
      const PointResult* point = table.find({v, L, model, branch});
      ASSERT_TRUE(point);
      if (name(branch) == lowest_branch) {
        EXPECT_EQ(point->status, PointStatus::stationary);
        EXPECT_EQ(point->diagnostics->energy.total(), energy);
      } else if (point->status == PointStatus::stationary) {
        EXPECT_GT(point->diagnostics->energy.total(), energy);
      }
    }
  // The oblate at 0.45 passes through itself: it is marked, and the prolate is offered in spite of its energy.
  const PointResult* crossed = table.find({0.45, 0.02, model::Model::SSH, axisym::Branch::oblate});
  ASSERT_TRUE(crossed);
  EXPECT_TRUE(crossed->self_contact);
  EXPECT_NE(crossed->status, PointStatus::stationary);
}

TEST(BeyondFold, is_tabled_where_the_fold_is_near_the_scan_and_offers_its_sharp_rims) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.8};
  input.L = {0.03, 0.05, 0.06};
  input.models = {model::Model::SBEH};
  input.beyond_fold = true;
  const sbeh::test::TemporaryFolder folder;
  run_scan(input, folder.path() / "scan", "test");
  std::vector<std::string> kinds;
  for (const axisym::RimRecord& row :
       read_rows(rim_columns(), folder.path() / "scan/beyond_fold.csv")) {
    EXPECT_EQ(row.reduced_volume, 0.6);  // at 0.8 the fold is at L = 0.137
    EXPECT_LE(row.resolution, axisym::largest_resolution);
    kinds.push_back(sbeh::name(row.kind));
    EXPECT_TRUE(fs::exists(folder.path() / "scan/beyond_fold" / (stem(row) + ".csv")));
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"fold", "saddle", "saddle", "saddle", "sharp", "sharp",
                                             "sharp", "equal_energy"}));
  const auto lowest = read_rows(lowest_columns(), folder.path() / "scan/lowest.csv");
  ASSERT_EQ(lowest.size(), 6u);  // by L, then by reduced volume
  for (const auto& [row, branch] :
       {std::pair{0, "oblate"}, {1, "oblate"}, {2, "sharp_oblate"}, {4, "sharp_oblate"}})
    EXPECT_EQ(lowest[std::size_t(row)].branch, branch) << row;
}

}  // namespace
}  // namespace sbeh::studies
