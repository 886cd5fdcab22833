// Where states of a scan begin or cease to be minima among shapes without an axis, as it leaves them.
#include "studies/scan/stability_lines.h"

#include "studies/scan/scan.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using axisym::Parity;
using model::Model;

struct Tables {
  std::vector<PointResult> points;
  std::vector<StabilityLineRow> lines;
};
Tables tables_of(const ScanInput& input) {
  const sbeh::test::TemporaryFolder folder;
  const auto scan = folder.path() / "scan";
  run_scan(input, scan, "test");
  return {read_rows(scan_columns(), scan / "scan.csv"),
          read_rows(stability_line_columns(), scan / "stability_lines.csv")};
}

ScanInput oblates() {
  ScanInput input;
  input.reduced_volume = {0.6, 0.7, 0.8};
  input.L = {0.05, 0.07, 0.1, 0.13};
  return input;
}

// The number of lines with this m, model and direction, which are solved for at one of the scan's values.
std::vector<double> crossings(const Tables& tables, Model model, Along along, double at, int m) {
  std::vector<double> found;
  for (const StabilityLineRow& row : tables.lines) {
    const bool in_volume = row.along == Along::reduced_volume;
    if (row.model == model && row.along == along && row.m == m
        && (in_volume ? row.L : row.reduced_volume) == at)
      found.push_back(in_volume ? row.reduced_volume : row.L);
  }
  std::ranges::sort(found);
  return found;
}

// Before its fold at 0.0706 the oblate of 0.6 gives way to m = 1, then to m = 2; that of 0.8, which has given way to
// m = 2, becomes a minimum at 0.119.
TEST(StabilityLines, lie_before_folds_and_between_neighbours_that_differ) {
  const Tables tables = tables_of(oblates());
  const auto expect = [&](Model model, Along along, double at, int m,
                          const std::vector<double>& values) {
    const auto found = crossings(tables, model, along, at, m);
    ASSERT_EQ(found.size(), values.size()) << name(model) << ' ' << at << ' ' << m;
    for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(found[k], values[k], 2e-8);
  };
  expect(Model::SBEH, Along::L, 0.6, 1, {0.0677633402});
  expect(Model::SBEH, Along::L, 0.6, 2, {0.0679494732});
  for (const double L : oblates().L)
    expect(Model::SSH, Along::reduced_volume, L, 2, {0.7497290498});
  expect(Model::SSH, Along::reduced_volume, 0.05, 1, {});
  const auto window = crossings(tables, Model::SBEH, Along::L, 0.8, 2);
  ASSERT_EQ(window.size(), 1u);
  EXPECT_NEAR(window[0], 0.1187, 1e-3);
  for (const StabilityLineRow& row : tables.lines) {
    EXPECT_EQ(row.reason, "");
    EXPECT_EQ(row.parity, Parity::even);
    EXPECT_LE(row.error, 1e-7);
  }
}

// From 0.735 on, close to its own zero below, the eigenvalue of m = 2 rises before it falls.
TEST(StabilityLines, are_found_where_eigenvalues_rise_and_fall) {
  ScanInput input;
  input.reduced_volume = {0.735, 0.78};
  input.L = {0.1};
  input.models = {Model::SBEH};
  const auto found = crossings(tables_of(input), Model::SBEH, Along::reduced_volume, 0.1, 2);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0], 0.7705654351, 2e-8);
}

// At V_r = 0.74967 m = 2 is unstable between the L of its two zeros alone: the limit falls from 0.749729 at L = 0 to
// 0.74966 and rises again.
TEST(StabilityLines, are_found_where_an_eigenvalue_changes_its_sign_twice_between_neighbours) {
  ScanInput input;
  input.reduced_volume = {0.74967};
  input.L = {0.001, 0.003, 0.025, 0.03};
  input.models = {Model::SBEH};
  const Tables tables = tables_of(input);
  for (const PointResult& row : tables.points) EXPECT_GT(row.modes.eigenvalue[2], 0);
  const auto found = crossings(tables, Model::SBEH, Along::L, 0.74967, 2);
  ASSERT_EQ(found.size(), 2u);
  input.L = {(0.003 + found[0]) / 2, (found[0] + found[1]) / 2, (found[1] + 0.025) / 2};
  const Tables between = tables_of(input);
  const auto again = crossings(between, Model::SBEH, Along::L, 0.74967, 2);
  ASSERT_EQ(again.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(again[k], found[k], 2e-7);
  // Without rows beyond, nothing says so.
  input.L = {0.003, 0.025};
  EXPECT_TRUE(crossings(tables_of(input), Model::SBEH, Along::L, 0.74967, 2).empty());
}

// Between neighbours an odd number of lines of an m is crossed where one of them alone is unstable.
TEST(StabilityLines, separate_stable_from_unstable_states) {
  const Tables tables = tables_of(oblates());
  const auto is_unstable = [](const PointResult& row, int m) {
    return std::ranges::find(row.modes.unstable, m) != row.modes.unstable.end();
  };
  int pairs = 0;
  for (const PointResult& a : tables.points)
    for (const PointResult& b : tables.points) {
      const PointKey &p = a.key, &q = b.key;
      const bool in_volume = p.L == q.L && p.reduced_volume < q.reduced_volume;
      const bool in_L = p.reduced_volume == q.reduced_volume && p.L < q.L && p.model == Model::SBEH;
      if (p.model != q.model || !(in_volume || in_L) || a.status != PointStatus::stationary
          || b.status != PointStatus::stationary)
        continue;
      ++pairs;
      for (const int m : {1, 2, 3, 4}) {
        const auto lines = in_volume ? crossings(tables, p.model, Along::reduced_volume, p.L, m)
                                     : crossings(tables, p.model, Along::L, p.reduced_volume, m);
        const auto between = std::ranges::count_if(lines, [&](double x) {
          return in_volume ? p.reduced_volume < x && x < q.reduced_volume : p.L < x && x < q.L;
        });
        EXPECT_EQ(between % 2 == 1, is_unstable(a, m) != is_unstable(b, m))
            << stem(p) << ' ' << stem(q) << ' ' << m;
      }
    }
  EXPECT_GT(pairs, 15);
}

TEST(StabilityLines, are_not_looked_for_without_modes) {
  ScanInput input = oblates();
  input.modes = 0;
  const sbeh::test::TemporaryFolder folder;
  run_scan(input, folder.path() / "scan", "test");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "scan/stability_lines.csv"));
}

}  // namespace
}  // namespace sbeh::studies
