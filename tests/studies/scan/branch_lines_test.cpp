// The lines of the diagram: folds and equal energies, as a scan leaves them.

#include "axisym/shooting/seifert_shooting.h"
#include "studies/io/csv_line.h"
#include "studies/io/output.h"
#include "studies/scan/scan.h"
#include "studies/scan/scan_table.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(const fs::path& file, const std::string& header) {
  std::istringstream text(read_file(file));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, header);
  Rows rows;
  while (std::getline(text, line)) rows.push_back(split_csv(line));
  return rows;
}

struct Lines {
  Rows folds, meetings;
};
Lines lines_of(ScanInput input, int elements) {
  input.numerics.elements = elements;
  const sbeh::test::TemporaryFolder folder;
  const ScanSummary summary = run_scan(input, folder.path() / "scan", "test");
  EXPECT_EQ(summary.failed, 0);
  return {rows_of(folder.path() / "scan/folds.csv",
                  "reduced_volume,L,energy,order_min,H_abs_max,branch"),
          input.branches.size() > 1 ? rows_of(folder.path() / "scan/equal_energy.csv",
                                              "first,second,L,reduced_volume,energy")
                                    : Rows{}};
}

TEST(FoldLine, of_the_oblates_is_found_to_four_digits_and_does_not_move_under_refinement) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.65, 0.7, 0.75, 0.8};
  input.L = {0.05};
  input.models = {model::Model::SBEH};
  const Rows coarse = lines_of(input, 48).folds, fine = lines_of(input, 72).folds;
  ASSERT_EQ(coarse.size(), 5u);
  ASSERT_EQ(fine.size(), 5u);
  double before = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const double L = std::stod(coarse[k][1]), refined = std::stod(fine[k][1]);
    std::printf("  V_r = %s: L* = %.9f, with 72 elements %.9f\n", coarse[k][0].c_str(), L, refined);
    EXPECT_NEAR(L / refined, 1, 1e-6);
    EXPECT_GT(L, before);  // rounder shapes hold out longer
    before = L;
  }
  EXPECT_NEAR(std::stod(fine[0][1]), 0.070637, 1e-6);  // one percent above the paper's largest L
}

TEST(EqualEnergies, of_oblate_and_prolate_start_at_the_classical_point_and_are_exact) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.65, 0.7, 0.75};
  input.L = {1e-6, 0.01, 0.05, 0.09};
  input.models = {model::Model::SBEH};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate};
  const Rows coarse = lines_of(input, 48).meetings, fine = lines_of(input, 72).meetings;
  ASSERT_EQ(coarse.size(), 4u);
  ASSERT_EQ(fine.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(coarse[k][0], "oblate");
    EXPECT_EQ(coarse[k][1], "prolate");
    EXPECT_NEAR(std::stod(coarse[k][3]), std::stod(fine[k][3]), 1e-6) << "L = " << coarse[k][2];
    std::printf("  L = %s: V_r = %s\n", fine[k][2].c_str(), fine[k][3].c_str());
  }
  // As L → 0 the order is full and the shapes are the classical ones; the distance is linear in L.
  const double classical = axisym::shoot_special_points().prolate_oblate.reduced_volume;
  EXPECT_NEAR(std::stod(fine[0][3]), classical, 1e-6);
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
  const Rows lowest =
      rows_of(folder.path() / "scan/lowest.csv", "model,L,reduced_volume,branch,energy");
  const ScanTable table{OutputFolder(folder.path() / "scan")};
  EXPECT_EQ(lowest.size(), 12u);
  for (const auto& row : lowest) {
    const model::Model model = row[0] == "SBEH" ? model::Model::SBEH : model::Model::SSH;
    const double L = std::stod(row[1]), v = std::stod(row[2]), energy = std::stod(row[4]);
    for (const axisym::Branch branch : input.branches) {
      const PointResult* point = table.find({v, L, model, branch});
      ASSERT_TRUE(point);
      if (name(branch) == row[3]) {
        EXPECT_EQ(point->status, PointStatus::stationary);
        EXPECT_EQ(point->diagnostics->energy.total(), energy);
      } else if (point->status == PointStatus::stationary) {
        EXPECT_GT(point->diagnostics->energy.total(), energy);
      }
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
  const Rows states = rows_of(folder.path() / "scan/beyond_fold.csv",
                              "reduced_volume,L,kind,energy,order_rim,H_rim,H_abs_max,resolution,"
                              "status,jump,pressure,negative_directions");
  std::vector<std::string> kinds;
  for (const auto& row : states) {
    EXPECT_EQ(row[0], "0.6");  // at 0.8 the fold is at L = 0.137
    EXPECT_EQ(row[8], "stationary");
    kinds.push_back(row[2]);
    EXPECT_TRUE(
        fs::exists(folder.path() / "scan/beyond_fold" / (row[2] + "_v0.6_L" + row[1] + ".csv")));
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"fold", "saddle", "saddle", "saddle", "sharp", "sharp",
                                             "sharp", "equal_energy"}));
  const Rows lowest =
      rows_of(folder.path() / "scan/lowest.csv", "model,L,reduced_volume,branch,energy");
  ASSERT_EQ(lowest.size(), 6u);  // by L, then by reduced volume
  for (const auto& [row, branch] :
       {std::pair{0, "oblate"}, {1, "oblate"}, {2, "sharp_oblate"}, {4, "sharp_oblate"}})
    EXPECT_EQ(lowest[std::size_t(row)][3], branch) << row;
}

}  // namespace
}  // namespace sbeh::studies
