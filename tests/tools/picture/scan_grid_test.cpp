// What a picture of a scan takes from its table.
#include "studies/scan/lowest.h"
#include "tests/temporary_folder.h"
#include "tools/picture/options.h"
#include "tools/picture/scan/quantity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sbeh::picture {
namespace {

using axisym::Branch;

PointResult point(double volume, double L, Model model, Branch branch, double energy,
                  PointStatus status = PointStatus::stationary) {
  PointResult row{.key = {volume, L, model, branch}, .status = status, .diagnostics = {}};
  if (status != PointStatus::failed) {
    row.diagnostics.emplace();
    row.diagnostics->energy.bending = energy;
  }
  return row;
}

class ScanGridTest : public testing::Test {
 protected:
  ScanGrid grid_of(const std::vector<PointResult>& rows, const std::string& branch = "") const {
    studies::write_file(folder_.path() / "scan.csv",
                        studies::table_text(studies::scan_columns(), rows));
    return {folder_.path(), branch};
  }
  sbeh::test::TemporaryFolder folder_;
};

TEST_F(ScanGridTest, has_the_branch_of_lowest_energy_among_the_stationary_ones_or_the_chosen_one) {
  const std::vector<PointResult> rows{
      point(0.7, 0.05, Model::SSH, Branch::oblate, 3),
      point(0.7, 0.05, Model::SSH, Branch::prolate, 2),
      point(0.7, 0.05, Model::SSH, Branch::stomatocyte, 1, PointStatus::unresolved),
      point(0.6, 0.05, Model::SSH, Branch::oblate, 5)};
  const ScanGrid all = grid_of(rows);
  EXPECT_EQ(all.reduced_volumes(), (std::vector<double>{0.6, 0.7}));
  EXPECT_EQ(all.branches(), (std::vector<std::string>{"oblate", "prolate", "stomatocyte"}));
  ASSERT_TRUE(all.find(Model::SSH, 1, 0));
  EXPECT_EQ(all.find(Model::SSH, 1, 0)->key.branch, Branch::prolate);
  EXPECT_FALSE(all.find(Model::SBEH, 1, 0));
  EXPECT_FALSE(all.has(Model::SBEH));
  EXPECT_EQ(grid_of(rows, "oblate").find(Model::SSH, 1, 0)->key.branch, Branch::oblate);
  EXPECT_EQ(all.profile(*all.find(Model::SSH, 1, 0)),
            folder_.path() / "points/SSH_prolate_v0.7_L0.05.csv");
}

TEST_F(ScanGridTest, is_refused_without_rows_or_without_the_branch) {
  EXPECT_THROW(grid_of({}), InputError);
  EXPECT_THROW(grid_of({point(0.7, 0.05, Model::SSH, Branch::oblate, 3)}, "prolate"), InputError);
}

TEST_F(ScanGridTest, gives_quantities_with_marks_and_regions) {
  const ScanGrid grid =
      grid_of({point(0.6, 0.01, Model::SSH, Branch::oblate, 5),
               point(0.6, 0.01, Model::SBEH, Branch::oblate, 4),
               point(0.6, 0.02, Model::SSH, Branch::oblate, 5),
               point(0.6, 0.02, Model::SBEH, Branch::oblate, 3, PointStatus::unresolved),
               point(0.7, 0.01, Model::SSH, Branch::oblate, 5),
               point(0.7, 0.01, Model::SBEH, Branch::oblate, 0, PointStatus::failed),
               point(0.7, 0.02, Model::SSH, Branch::oblate, 5)});
  const Quantity gap = energy_gap(grid);
  EXPECT_EQ(gap.marks, (std::vector<std::vector<Mark>>{{Mark::none, Mark::unresolved},
                                                       {Mark::failed, Mark::absent}}));
  EXPECT_EQ(gap.values[0][0], 1);
  EXPECT_TRUE(std::isnan(gap.values[0][1]));
  EXPECT_TRUE(std::isnan(gap.values[1][0]) && std::isnan(gap.values[1][1]));
  EXPECT_EQ(gap.regions, (std::vector<std::vector<int>>{{0, -1}, {-1, -1}}));
  EXPECT_TRUE(gap.has(Mark::failed));
  EXPECT_EQ(gap.range(), (Range{1, 1}));
}

// Order that is free can only lower the energy.
TEST_F(ScanGridTest, knows_the_states_that_are_no_minima_without_an_axis) {
  std::vector<PointResult> rows{point(0.6, 0.05, Model::SBEH, Branch::oblate, 1),
                                point(0.7, 0.05, Model::SBEH, Branch::oblate, 1),
                                point(0.8, 0.05, Model::SBEH, Branch::oblate, 1)};
  rows[0].modes.negative_directions = 0;
  rows[1].modes.negative_directions = 2;  // of the last it is not known
  const Quantity quantity = energy(grid_of(rows), Model::SBEH);
  EXPECT_EQ(quantity.saddles, (std::vector<std::vector<bool>>{{false}, {true}, {false}}));
  EXPECT_TRUE(quantity.has_saddle());
  rows[1].modes.negative_directions = 0;
  EXPECT_FALSE(energy(grid_of(rows), Model::SBEH).has_saddle());
}

TEST_F(ScanGridTest, has_no_gap_where_SSH_is_below_all_of_SBEH) {
  struct Gap {
    double ssh, sbeh;
    Mark mark;
  };
  const std::vector<Gap> gaps{{5, 4, Mark::none},
                              {5, 5, Mark::none},
                              {4, 5, Mark::not_found},
                              {-11.414, -11.363, Mark::not_found},
                              {-12, -11.3, Mark::not_found},
                              {-11.3, -12, Mark::none},
                              {5, 5 + 1e-9, Mark::none}};  // as far as rows may be off
  std::vector<PointResult> rows;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const double L = 0.01 * double(k + 1);
    rows.push_back(point(0.6, L, Model::SSH, Branch::stomatocyte, gaps[k].ssh));
    rows.push_back(point(0.6, L, Model::SBEH, Branch::oblate, gaps[k].sbeh));
  }
  const Quantity gap = energy_gap(grid_of(rows));
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    EXPECT_EQ(gap.marks[0][k], gaps[k].mark) << k;
    EXPECT_EQ(std::isnan(gap.values[0][k]), gaps[k].mark == Mark::not_found) << k;
    EXPECT_EQ(gap.regions[0][k] == -1, gaps[k].mark == Mark::not_found) << k;
  }
}

TEST_F(ScanGridTest, has_a_map_whose_cells_are_marked_where_the_lowest_is_not_found) {
  const ScanGrid grid = grid_of({point(0.6, 0.01, Model::SBEH, Branch::oblate, 5),
                                 point(0.6, 0.02, Model::SBEH, Branch::oblate, 5),
                                 point(0.6, 0.03, Model::SBEH, Branch::oblate, 5),
                                 point(0.6, 0.02, Model::SBEH, Branch::prolate, 6)});
  using studies::LowestRow;
  studies::write_file(
      folder_.path() / "lowest.csv",
      studies::table_text(studies::lowest_columns(),
                          std::vector<LowestRow>{{Model::SBEH, 0.01, 0.6, "oblate", 5},
                                                 {Model::SBEH, 0.02, 0.6, studies::not_found,
                                                  studies::not_known, 4, "SSH oblate"},
                                                 {Model::SBEH, 0.03, 0.6, "nested_spheres", 3}}));
  const auto map = lowest_branches(grid, Model::SBEH);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->names, (std::vector<std::string>{"oblate", "prolate", "nested_spheres"}));
  EXPECT_EQ(map->quantity.marks[0], (std::vector<Mark>{Mark::none, Mark::not_found, Mark::none}));
  EXPECT_EQ(map->quantity.values[0][0], 0);
  EXPECT_TRUE(std::isnan(map->quantity.values[0][1]));
  EXPECT_EQ(map->quantity.values[0][2], 2);
  Quantity order = smallest_order(grid);
  EXPECT_TRUE(std::isfinite(order.values[0][1]));
  order = smallest_order(grid, map);
  EXPECT_EQ(order.marks[0], (std::vector<Mark>{Mark::none, Mark::not_found, Mark::singular}));
  EXPECT_TRUE(std::isfinite(order.values[0][0]));
  EXPECT_TRUE(std::isnan(order.values[0][1]) && std::isnan(order.values[0][2]));
  const Quantity energies = energy(grid, Model::SBEH, map);
  EXPECT_EQ(energies.values[0][0], 5);
  EXPECT_TRUE(std::isnan(energies.values[0][1]));
  EXPECT_EQ(energies.values[0][2], 3);  // of the limit, not of the oblate
  EXPECT_NE(energies.regions[0][2], energies.regions[0][0]);
  EXPECT_TRUE(map->is_lowest(0, 0));
  EXPECT_FALSE(map->is_lowest(0, 1) || map->is_lowest(0, 2));
}

// What a row describes that is not at rest, or at the fold of another L, colours nothing and stretches no range.
TEST_F(ScanGridTest, has_no_value_of_rows_that_are_not_of_their_point) {
  for (const double far : {-1e3, -0.1, 3., 1e3}) {
    const ScanGrid grid =
        grid_of({point(0.6, 0.01, Model::SBEH, Branch::oblate, 1),
                 point(0.6, 0.02, Model::SBEH, Branch::oblate, far, PointStatus::unresolved),
                 point(0.7, 0.01, Model::SBEH, Branch::oblate, 2),
                 point(0.7, 0.02, Model::SBEH, Branch::oblate, 0, PointStatus::failed)});
    for (const Quantity& quantity :
         {energy(grid, Model::SBEH), smallest_order(grid), largest_curvature(grid, Model::SBEH)}) {
      EXPECT_EQ(quantity.marks[0][1], Mark::unresolved);
      EXPECT_EQ(quantity.regions[0][1], -1);
      EXPECT_TRUE(std::isnan(quantity.values[0][1]) && std::isnan(quantity.values[1][1]));
    }
    EXPECT_EQ(energy(grid, Model::SBEH).range(), (Range{1, 2}));
  }
}

// Its energy is one of its own point; a quantity that it has not is no failure.
TEST_F(ScanGridTest, has_the_values_of_a_limit) {
  std::vector<PointResult> rows{
      point(0.6, 0.01, Model::SSH, Branch::stomatocyte, 4, PointStatus::limit),
      point(0.7, 0.01, Model::SSH, Branch::stomatocyte, 5),
      point(0.6, 0.01, Model::SSH, Branch::oblate, 6, PointStatus::unresolved)};
  rows[0].diagnostics->H_abs_max = studies::not_known;
  const ScanGrid grid = grid_of(rows);
  EXPECT_EQ(grid.find(Model::SSH, 0, 0)->status, PointStatus::limit);
  const Quantity energies = energy(grid, Model::SSH),
                 curvature = largest_curvature(grid, Model::SSH);
  EXPECT_EQ(energies.values[0][0], 4);
  EXPECT_EQ(energies.marks[0][0], Mark::limit);
  EXPECT_EQ(energies.range(), (Range{4, 5}));
  EXPECT_EQ(curvature.marks[0][0], Mark::singular);
}

TEST(EvenlySpread, has_the_first_and_the_last) {
  EXPECT_EQ(evenly_spread(3, 6), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(evenly_spread(50, 6), (std::vector<std::size_t>{0, 10, 20, 29, 39, 49}));
  EXPECT_EQ(evenly_spread(5, 1), std::vector<std::size_t>{0});
  EXPECT_TRUE(evenly_spread(0, 3).empty());
}

}  // namespace
}  // namespace sbeh::picture
