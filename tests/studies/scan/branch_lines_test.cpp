// The lines of the diagram: folds and equal energies, as a scan leaves them.

#include "studies/scan/branch_lines.h"

#include "axisym/shooting/seifert_shooting.h"
#include "studies/scan/beyond_fold.h"
#include "studies/scan/lowest.h"
#include "studies/scan/scan.h"
#include "tests/temporary_folder.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
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

// The header and the lines without wall_seconds.
std::vector<std::string> without_times(const fs::path& file) {
  const CsvTable table = read_csv(file);
  const auto time = *table.find("wall_seconds");
  std::vector<std::string> lines;
  for (auto fields : table.rows) {
    fields.erase(fields.begin() + std::ptrdiff_t(time));
    lines.push_back(fmt::format("{}", fmt::join(fields, ",")));
  }
  return lines;
}

TEST(FoldLine, gives_its_L_to_the_rows_before_it_and_the_same_to_a_resumed_scan) {
  ScanInput input;
  input.reduced_volume = {0.55, 0.6, 0.86, 1};
  input.L = {1e-4, 0.03, 0.1, 0.2};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate, axisym::Branch::stomatocyte};
  const sbeh::test::TemporaryFolder folder;
  const fs::path scan = folder.path() / "scan", table = scan / "scan.csv";
  run_scan(input, scan, "test");
  const auto folds = read_rows(fold_columns(), scan / "folds.csv");
  int before = 0, at = 0;
  for (const PointResult& row : read_rows(scan_columns(), table)) {
    const auto fold = std::ranges::find_if(folds, [&](const FoldRow& f) {
      return f.branch == row.key.branch && f.reduced_volume == row.key.reduced_volume;
    });
    SCOPED_TRACE(stem(row.key));
    if (row.key.model == model::Model::SSH || row.fold_side.empty() || fold == folds.end()) {
      EXPECT_FALSE(row.fold_L);
      continue;
    }
    EXPECT_EQ(row.fold_L, fold->L);
    (row.fold_side == "before" ? before : at) += 1;
    EXPECT_EQ(row.fold_side, row.key.L < fold->L ? "before" : "at");
  }
  EXPECT_GE(before, 12);
  EXPECT_GE(at, 8);

  const std::string whole = read_file(table), lines = read_file(scan / "folds.csv");
  run_scan(input, scan, "test");
  EXPECT_EQ(read_file(table), whole);
  const auto rows = without_times(table);
  for (const double share : {0.2, 0.7, 0.95}) {  // killed within a line
    write_file(table, whole.substr(0, std::size_t(share * double(whole.size()))));
    run_scan(input, scan, "test");
    EXPECT_EQ(without_times(table), rows) << share;
    EXPECT_EQ(read_file(scan / "folds.csv"), lines) << share;
  }
}

TEST(FoldLine, is_of_another_kind_where_the_whole_surface_melts_or_a_pole) {
  ScanInput input;
  input.reduced_volume = {0.8, 0.84, 0.86, 0.9};
  input.L = {0.05};
  input.models = {model::Model::SBEH};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate};
  std::vector<std::string> kinds;
  for (const FoldRow& fold : lines_of(input, 48).folds)
    kinds.emplace_back(fold.kind ? name(*fold.kind) : "none");
  EXPECT_EQ(kinds, (std::vector<std::string>{"rim", "rim", "whole", "whole", "pole", "pole", "pole",
                                             "pole"}));
}

// Near V_r = 0.855 the branch turns back for less than a percent of L.
TEST(FoldLine, is_its_first_fold_wherever_the_scan_ends) {
  ScanInput input;
  input.reduced_volume = {0.83, 0.84, 0.85, 0.855};
  input.models = {model::Model::SBEH};
  input.branches = {axisym::Branch::oblate};
  std::vector<std::vector<double>> found;  // by V_r, with each of the largest L
  for (const double L : {0.02, 0.05, 0.1, 0.145, 0.155}) {
    input.L = {L};
    const auto folds = lines_of(input, 48).folds;
    ASSERT_EQ(folds.size(), 4u);
    found.resize(4);
    for (std::size_t k = 0; k < 4; ++k) found[k].push_back(folds[k].L);
  }
  for (const auto& at_one_volume : found)
    for (const double L : at_one_volume) EXPECT_NEAR(L, at_one_volume[0], 1e-7);
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

TEST(BeyondFold, is_tabled_where_the_fold_is_near_the_scan_and_offers_its_sharp_rims) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.8};
  input.L = {0.03, 0.05, 0.06};
  input.models = {model::Model::SBEH};
  input.beyond_fold = true;
  const sbeh::test::TemporaryFolder folder;
  run_scan(input, folder.path() / "scan", "test");
  std::vector<std::string> kinds;
  for (const RimRow& row : read_rows(rim_columns(), folder.path() / "scan/beyond_fold.csv")) {
    EXPECT_EQ(row.reduced_volume, 0.6);  // at 0.8 the fold is at L = 0.137
    EXPECT_LE(row.resolution, axisym::largest_resolution);
    kinds.emplace_back(sbeh::name(row.kind));
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

// What the elements of high degree say of m = 0 is known without those that the modes are computed on.
TEST(BeyondFold, says_what_is_stable_in_3D_but_for_kinks) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.8};
  input.L = {0.03, 0.07, 0.11, 0.13};
  input.models = {model::Model::SBEH};
  const std::vector<FoldRow> folds{{axisym::Branch::oblate, 0.6, 0.0706, 0, 0, 0},
                                   {axisym::Branch::oblate, 0.8, 0.1366, 0, 0, 0}};
  const std::vector<RimRow> rows = find_beyond_fold(input, folds);
  input.numerics.elements *= 2;
  const std::vector<RimRow> finer = find_beyond_fold(input, folds);
  ASSERT_EQ(rows.size(), finer.size());
  int known = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    using axisym::RimKind;
    const RimRow& row = rows[k];
    SCOPED_TRACE(stem(row));
    const bool is_fold = row.kind == RimKind::fold || row.kind == RimKind::second_fold;
    if (is_fold || row.order_rim == 0) {
      EXPECT_FALSE(row.modes.negative_directions);
    }
    if (is_fold || row.order_rim < 0.01) continue;  // sharper ones may be resolved or not
    ASSERT_TRUE(row.modes.negative_directions);
    ++known;
    ASSERT_GE(*row.modes.negative_directions, *row.negative_directions + 2);  // m = 1, at the rim
    EXPECT_EQ(row.modes.unstable.front() == 0, *row.negative_directions > 0);
    EXPECT_LT(row.modes.rigid_residual, 1e-5);
    constexpr double relative = 1e-5;  // 96 elements and |H| of 22
    for (std::size_t m = 0; m <= 4; ++m) {
      const double fine = finer[k].modes.eigenvalue[m];
      EXPECT_NEAR(row.modes.eigenvalue[m], fine, relative * (1 + std::abs(fine))) << m;
    }
  }
  EXPECT_GE(known, 6);
}

TEST(BeyondFold, counts_directions_of_every_m) {
  ScanInput few;
  few.reduced_volume = {0.6};
  few.L = {0.03, 0.05};
  few.models = {model::Model::SBEH};
  ScanInput many = few;
  few.modes = 1, many.modes = axisym::most_modes;
  const std::vector<FoldRow> folds{{axisym::Branch::oblate, 0.6, 0.0706, 0, 0, 0}};
  const auto saddle = [&](const ScanInput& input) { return find_beyond_fold(input, folds).at(1); };
  const RimRow one = saddle(few), all = saddle(many);
  ASSERT_EQ(one.kind, axisym::RimKind::saddle);
  EXPECT_GT(one.modes.unstable.back(), 4);
  EXPECT_EQ(one.modes.unstable, all.modes.unstable);
  EXPECT_EQ(one.modes.negative_directions, all.modes.negative_directions);
}

}  // namespace
}  // namespace sbeh::studies
