// Scans that begin with an order of several phases: the study of budding against two domains with a sharp interface, and states whose
// domains are not those that were asked for.
#include "axisym/domains.h"

#include "studies/scan/branch_lines.h"
#include "studies/scan/domain_start.h"
#include "studies/scan/point_outcome.h"
#include "studies/scan/scan.h"
#include "studies/sweep/sweep_input.h"
#include "tests/axisym/shooting/two_domains.h"
#include "tests/order_table.h"
#include "tests/studies/parameters/input_file.h"

#include <algorithm>
#include <array>

namespace sbeh::studies {
namespace {

using namespace test;
using model::Model;
using sbeh::test::OrderTable;

constexpr double open_volume = 0.82;

// The case of the study whose interface has this width; its modes are not asked for.
ScanInput study(std::size_t k) {
  const SweepCases all = cases_of(read_sweep("studies/inputs/budding.toml"), "0");
  ScanInput input = read_scan(written(all.cases.at(k).description));
  input.modes = 0;
  return input;
}

axisym::shooting::TwoDomainVesicle sharp(double reduced_volume) {
  return axisym::shooting::open_vesicle(
      {.fraction = 0.2, .kappa_a = 0.2, .line_tension = 2.6, .reduced_volume = reduced_volume});
}

// To zero width by those with the widths w, w/2, w/4, whose errors go with w and w², within what the narrowest has changed of it.
void expect_linear_in_the_width(const std::array<double, 3>& at, double sharp) {
  OrderTable table("difference from the sharp interface", "width");
  for (std::size_t k = 0; k < 3; ++k) table.add(0.08 / double(1 << k), at[k] - sharp);
  EXPECT_NEAR(table.print(), 1, 0.25);
  const double coarse = 2 * at[1] - at[0], fine = 2 * at[2] - at[1];
  EXPECT_NEAR((4 * fine - coarse) / 3, sharp, std::abs(fine - coarse));
}

TEST(ScanOfDomains, finds_the_fold_of_a_soft_cap_where_a_sharp_interface_has_it) {
  std::array<double, 3> volumes{}, at_fold{}, open{};
  for (std::size_t k = 0; k < 3; ++k) {
    const ScanInput input = study(k);
    const sbeh::test::TemporaryFolder temporary;
    const auto folder = temporary.path() / "scan";
    const ScanSummary summary = run_scan(input, folder, "0");
    EXPECT_EQ(summary.stationary, 2)
        << summary.first_failure;  // V_r = 0.95 and 0.82; 0.79 is beyond the fold
    EXPECT_EQ(summary.unresolved, 1);
    const auto folds = read_rows(fold_columns(), folder / "folds.csv");
    const auto fold = std::ranges::find_if(folds, is_along_volume);
    ASSERT_NE(fold, folds.end());
    volumes[k] = fold->reduced_volume;
    at_fold[k] = fold->energy;
    EXPECT_LT(fold->reduced_volume_error, 1e-6);
    const PointKey key{open_volume, input.L[0], Model::SBEH, axisym::Branch::prolate};
    for (const PointResult& row : read_rows(scan_columns(), folder / "scan.csv")) {
      EXPECT_EQ(row.interfaces, 1);
      if (row.key == key) {
        open[k] = row.diagnostics->energy.total();
        EXPECT_EQ(row.fold_reduced_volume, fold->reduced_volume);
        EXPECT_EQ(row.negative_directions, 0);
      }
    }
  }
  const auto fold = sharp(0.79);
  ASSERT_TRUE(fold.is_fold);
  expect_linear_in_the_width(volumes, fold.reduced_volume);
  expect_linear_in_the_width(at_fold, fold.energy);
  expect_linear_in_the_width(open, sharp(open_volume).energy);
}

TEST(ScanOfDomains, tells_states_with_other_domains_apart) {
  const ScanInput input = study(0);
  axisym::StationaryCase of = case_of(input, {0.95, input.L[0], Model::SBEH, input.branches[0]});
  EXPECT_EQ(of.interfaces, 1);
  const PointOutcome cap = point_with(of, input.start_order);
  ASSERT_EQ(cap.row.status, PointStatus::stationary) << cap.row.stop_reason;
  of.interfaces = 2;
  const PointOutcome other = outcome_of(of, *cap.state, *cap.row.diagnostics);
  EXPECT_EQ(other.row.status, PointStatus::failed);
  EXPECT_EQ(other.row.stop_reason,
            "the state found has 1 interface and not 2: the branch was left");
  axisym::StationaryState uniform = *cap.state;
  uniform.beta.setConstant(*input.material.mean_order);
  const PointOutcome none = outcome_of(of, uniform, axisym::diagnose(of.material, uniform));
  EXPECT_EQ(none.row.status, PointStatus::failed);
  EXPECT_NE(none.row.stop_reason.find("have vanished"), std::string::npos);
}

// Of a cap that is no larger than its interface is wide nothing stays.
TEST(ScanOfDomains, says_where_they_do_not_stay) {
  ScanInput input = study(0);
  input.start_order.caps[0].fraction = 0.002;
  input.material.mean_order = 0.59;
  const PointOutcome point = point_with(
      case_of(input, {0.95, input.L[0], Model::SBEH, input.branches[0]}), input.start_order);
  EXPECT_EQ(point.row.status, PointStatus::failed);
  EXPECT_NE(point.row.stop_reason.find("1 interface at the start, none"), std::string::npos)
      << point.row.stop_reason;
}

TEST(ScanOfDomains, is_read_back_from_its_description_and_refused_where_it_cannot_be) {
  const ScanInput input = study(1);
  EXPECT_EQ(input.interfaces, 1);
  EXPECT_EQ(read_scan(written(describe(input, "0"))), input);
  const std::string scan = "[scan]\nL = 1.664\ndomains = [{ fraction = 0.2, order = 0.1 }]\n",
                    conserved = "[material]\norder = 'conserved'\nmean_order = 0.5\n";
  const auto message = [&](const std::string& text) {
    return message_for(read_scan, written(text));
  };
  const auto expect = [&](const std::string& rest, const std::string& part) {
    EXPECT_NE(message(scan + rest).find(part), std::string::npos) << message(scan + rest);
  };
  const std::string sbeh = "models = ['SBEH']\n", v = "reduced_volume = 0.9\n";
  expect(v + conserved, "needs models = [\"SBEH\"]");
  expect(v + sbeh, "needs order = \"conserved\"");
  expect(v + sbeh + "method = 'flow'\n" + conserved, "needs method = \"newton\"");
  expect(v + sbeh + "branches = ['stomatocyte']\n" + conserved, "begins from spheroids");
  expect("reduced_volume = 1\n" + sbeh + conserved, "must be < 1 with domains");
  expect(v + sbeh + "[material]\norder = 'conserved'\nmean_order = 0.12\n", "differ by 0.1");
}

}  // namespace
}  // namespace sbeh::studies
