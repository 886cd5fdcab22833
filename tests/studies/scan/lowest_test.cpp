// The lowest branch at every point, and what is said where it is not among those found.

#include "studies/scan/lowest.h"

#include "studies/scan/scan.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using model::Model;

constexpr auto stationary = PointStatus::stationary;

// A row whose energy is elastic · L − 4π.
PointResult row_of(const PointKey& key, double elastic, PointStatus status = stationary) {
  PointResult row{.key = key, .status = status, .fold_side = "before"};
  row.diagnostics.emplace();
  row.diagnostics->energy = {
      .distortion = 0, .bending = elastic * key.L, .thermotropic = -4 * std::numbers::pi};
  row.diagnostics->volume = 4 * std::numbers::pi / 3 * key.reduced_volume;
  return row;
}
double energy_of(double elastic, double L) { return elastic * L - 4 * std::numbers::pi; }

// The rows of one model at V_r = 0.55 of a table.
std::vector<LowestRow> lowest_of(const std::vector<PointResult>& rows, Model model,
                                 double residual_stiffness = 0) {
  const sbeh::test::TemporaryFolder folder;
  ScanTable table = scan_table(OutputFolder(folder.path()));
  StateGrid grid;
  grid.reduced_volume = {0.55};
  grid.models = {model};
  grid.branches = {Branch::oblate, Branch::prolate, Branch::stomatocyte};
  grid.material.residual_stiffness = residual_stiffness;
  for (const PointResult& row : rows) {
    table.append(row);
    if (grid.L.empty() || grid.L.back() < row.key.L) grid.L.push_back(row.key.L);
  }
  return find_lowest(grid, table, {});
}

TEST(LowestBranch, is_not_found_where_another_state_of_the_scan_is_lower_as_a_trial) {
  const PointKey oblate{0.55, 0.02, Model::SBEH, Branch::oblate};
  const auto elsewhere = [&](double L, Model model, Branch branch, double elastic) {
    return row_of({0.55, L, model, branch}, elastic);
  };
  PointResult fold = elsewhere(0.02, Model::SBEH, Branch::stomatocyte, 0);
  fold.status = PointStatus::unresolved;
  fold.fold_side = "at";
  fold.fold_L = 0.0002;
  fold.diagnostics->energy.bending = 70 * *fold.fold_L;
  PointResult other = elsewhere(0.02, Model::SBEH, Branch::prolate, 70);  // of another class
  other.status = PointStatus::failed;
  const std::vector<std::pair<PointResult, std::string>> members{
      {elsewhere(0.02, Model::SSH, Branch::stomatocyte, 70), "SSH stomatocyte"},
      {elsewhere(0.02, Model::SSH, Branch::prolate, 70), "SSH prolate"},
      {elsewhere(0.02, Model::SSH, Branch::oblate, 70), "SSH oblate"},
      {elsewhere(0.01, Model::SSH, Branch::stomatocyte, 70), "SSH stomatocyte of L = 0.01"},
      {elsewhere(0.01, Model::SBEH, Branch::oblate, 70), "SBEH oblate of L = 0.01"},
      {elsewhere(0.01, Model::SBEH, Branch::prolate, 70), "SBEH prolate of L = 0.01"},
      {elsewhere(0.03, Model::SBEH, Branch::prolate, 70), "SBEH prolate of L = 0.03"},
      {fold, "SBEH stomatocyte of L = 0.0002"},
      {other, "SBEH prolate"}};
  for (const auto& [trial, name] : members) {
    SCOPED_TRACE(name);
    std::vector<PointResult> rows{trial, row_of(oblate, 80)};
    std::ranges::sort(rows, {}, &PointResult::key);
    for (const LowestRow& row : lowest_of(rows, Model::SBEH)) {
      if (row.L != 0.02) continue;
      EXPECT_EQ(row.branch, not_found);
      EXPECT_TRUE(std::isnan(row.energy));
      EXPECT_DOUBLE_EQ(row.bound, energy_of(70, 0.02));
      EXPECT_EQ(row.bound_of, name);
    }
  }
}

TEST(LowestBranch, is_found_where_the_trial_is_not_lower_or_no_state_of_this_point) {
  const PointKey oblate{0.55, 0.02, Model::SBEH, Branch::oblate};
  const PointKey trial{0.55, 0.02, Model::SSH, Branch::stomatocyte};
  PointResult crossed = row_of(trial, 70), elsewhere = crossed, unresolved = crossed;
  crossed.self_contact = true;
  elsewhere.fold_side = "at";  // a fold along V_r
  elsewhere.status = PointStatus::unresolved;
  elsewhere.diagnostics->volume *= 1.1;
  unresolved.status = PointStatus::unresolved;
  PointResult failed = crossed;
  failed.status = PointStatus::failed;
  failed.diagnostics.reset();
  for (const PointResult& other :
       {row_of(trial, 80), row_of(trial, 90), crossed, elsewhere, unresolved, failed,
        row_of({0.5, 0.02, Model::SSH, Branch::stomatocyte}, 70)}) {
    const auto rows = lowest_of({other, row_of(oblate, 80)}, Model::SBEH);
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].branch, "oblate");
    EXPECT_EQ(rows[0].energy, energy_of(80, 0.02));
  }
}

TEST(LowestBranch, of_SSH_is_not_bounded_by_ordered_states_but_by_its_own_at_other_L) {
  const PointKey oblate{0.55, 0.02, Model::SSH, Branch::oblate};
  const auto ordered = lowest_of(
      {row_of({0.55, 0.02, Model::SBEH, Branch::prolate}, 70), row_of(oblate, 80)}, Model::SSH);
  ASSERT_EQ(ordered.size(), 1u);
  EXPECT_EQ(ordered[0].branch, "oblate");
  EXPECT_TRUE(std::isnan(ordered[0].bound));
  const auto own = lowest_of(
      {row_of({0.55, 0.01, Model::SSH, Branch::prolate}, 70), row_of(oblate, 80)}, Model::SSH);
  ASSERT_EQ(own.size(), 2u);
  EXPECT_EQ(own[1].branch, not_found);
}

TEST(LowestBranch, takes_no_trial_from_larger_L_with_a_residual_stiffness) {
  for (const double trial_L : {0.01, 0.03}) {
    std::vector<PointResult> rows{row_of({0.55, trial_L, Model::SBEH, Branch::prolate}, 70),
                                  row_of({0.55, 0.02, Model::SBEH, Branch::oblate}, 80)};
    std::ranges::sort(rows, {}, &PointResult::key);
    for (const LowestRow& row : lowest_of(rows, Model::SBEH, 1e-3))
      EXPECT_EQ(row.branch == not_found, row.L == 0.02 && trial_L < 0.02) << trial_L << row.branch;
  }
}

struct Tables {
  std::vector<LowestRow> lowest;
  std::vector<PointResult> points;
};
Tables scanned(const ScanInput& input) {
  const sbeh::test::TemporaryFolder folder;
  run_scan(input, folder.path() / "scan", "test");
  return {read_rows(lowest_columns(), folder.path() / "scan/lowest.csv"),
          read_rows(scan_columns(), folder.path() / "scan/scan.csv")};
}

// Row by row: the table's lowest branch against the rows of scan.csv.
TEST(LowestBranch, is_that_of_least_energy_among_the_stationary_ones) {
  ScanInput input;
  input.reduced_volume = {0.45, 0.6, 0.7};
  input.L = {0.02, 0.06};
  input.branches = {Branch::oblate, Branch::prolate};
  input.numerics.elements = 32;
  const auto [lowest, points] = scanned(input);
  EXPECT_EQ(lowest.size(), 12u);
  for (const LowestRow& row : lowest)
    for (const PointResult& point : points) {
      const PointKey& key = point.key;
      if (key != PointKey{row.reduced_volume, row.L, row.model, key.branch}) continue;
      if (name(key.branch) == row.branch) {
        EXPECT_EQ(point.status, stationary);
        EXPECT_EQ(point.diagnostics->energy.total(), row.energy);
      } else if (point.status == stationary && row.branch != not_found) {
        EXPECT_GT(point.diagnostics->energy.total(), row.energy);
      }
    }
  // The oblate at 0.45 passes through itself: it is marked, and the prolate is offered in spite of its energy.
  const auto crossed = std::ranges::find(points, PointKey{0.45, 0.02, Model::SSH, Branch::oblate},
                                         &PointResult::key);
  ASSERT_NE(crossed, points.end());
  EXPECT_TRUE(crossed->self_contact);
  EXPECT_NE(crossed->status, stationary);
}

// No row of SBEH may lie above one of SSH: below V_r = 0.59 that is the stomatocyte, whose ordered ones end in a fold at
// tiny L. With SBEH alone its state at that fold tells the same.
TEST(LowestBranch, of_SBEH_is_not_found_where_SSH_s_stomatocyte_is_below_all_ordered_states) {
  ScanInput input;
  input.reduced_volume = {0.5, 0.55, 0.58, 0.62};
  input.L = {0.005, 0.0155, 0.03, 0.05};
  input.branches = {Branch::oblate, Branch::prolate, Branch::stomatocyte};
  const auto [lowest, points] = scanned(input);
  int found = 0, missing = 0;
  for (const LowestRow& row : lowest) {
    SCOPED_TRACE(testing::Message() << row.reduced_volume << " " << row.L);
    if (row.model != Model::SBEH) continue;
    double ssh = std::numeric_limits<double>::infinity(), sbeh = ssh;
    for (const PointResult& point : points)
      if (point.key.reduced_volume == row.reduced_volume && point.key.L == row.L
          && point.status == stationary) {
        double& least = point.key.model == Model::SSH ? ssh : sbeh;
        least = std::min(least, point.diagnostics->energy.total());
      }
    EXPECT_EQ(row.branch == not_found, ssh < sbeh);
    EXPECT_LE(row.bound, ssh);
    (row.branch == not_found ? missing : found) += 1;
    if (row.branch != not_found) {
      EXPECT_EQ(row.energy, sbeh);
    }
  }
  EXPECT_GT(found, 4);
  EXPECT_GT(missing, 4);
  input.models = {Model::SBEH};
  for (const LowestRow& alone : scanned(input).lowest) {
    const auto same = std::ranges::find_if(lowest, [&](const LowestRow& row) {
      return row.model == Model::SBEH && row.L == alone.L
          && row.reduced_volume == alone.reduced_volume;
    });
    ASSERT_NE(same, lowest.end());
    EXPECT_EQ(alone.branch, same->branch) << alone.reduced_volume << " " << alone.L;
  }
}

TEST(LowestBranch, of_SBEH_with_beyond_fold_is_a_sphere_in_a_sphere_where_those_are_lowest) {
  ScanInput input;
  input.reduced_volume = {0.55, 0.9};
  input.L = {0.0155};
  input.models = {Model::SBEH};
  input.branches = {Branch::oblate, Branch::stomatocyte};
  input.beyond_fold = true;
  const sbeh::test::TemporaryFolder folder;
  const auto scan = folder.path() / "scan";
  run_scan(input, scan, "test");
  const auto lowest = read_rows(lowest_columns(), scan / "lowest.csv");
  ASSERT_EQ(lowest.size(), 2u);
  EXPECT_EQ(lowest[0].branch, "nested_spheres");
  EXPECT_NEAR(lowest[0].energy, -11.798438, 1e-6);
  EXPECT_EQ(lowest[1].branch, "oblate");
  const CsvTable beyond = read_csv(scan / "beyond_fold.csv");
  int limits = 0;
  for (std::size_t k = 0; k < beyond.rows.size(); ++k) {
    const bool nested = beyond.text(k, "kind") == "nested_spheres";
    EXPECT_EQ(beyond.text(k, "status") == "limit", nested);
    limits += nested;
  }
  EXPECT_EQ(limits, 2);
}

}  // namespace
}  // namespace sbeh::studies
