// The modes of one state: numbers, signs, fluctuations, and what a 3D run makes of them.
#include "studies/modes/modes.h"

#include "studies/evolution/run_start.h"
#include "studies/scan/scan.h"
#include "studies/stability/mode_amplitude.h"
#include "surface3d/flow.h"
#include "tests/studies/parameters/input_file.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sbeh::studies {
namespace {

using namespace test;
using axisym::Parity;

ModesInput oblate(model::Model model, double reduced_volume, double L) {
  ModesInput input;
  input.state.model = model;
  input.state.reduced_volume = reduced_volume;
  input.state.material = input.state.material.with_L(L);
  return input;
}

const ModeRow& find(const ModesSummary& summary, int m, Parity parity, int number = 1) {
  return *std::ranges::find_if(summary.modes, [&](const ModeRow& row) {
    return row.key.m == m && row.key.parity == parity && row.key.number == number;
  });
}

TEST(Modes, of_the_classical_oblate_of_0_8_are_stable_but_for_one_of_m_2) {
  const ModesSummary summary =
      run_modes(oblate(model::Model::SSH, 0.8, 0.05), path_of("ssh"), "test");
  ASSERT_EQ(summary.modes.size(), 12u);
  for (const ModeRow& row : summary.modes)
    EXPECT_EQ(row.eigenvalue < 0, row.key.m == 2 && row.key.parity == Parity::even);
  EXPECT_NEAR(find(summary, 2, Parity::even).eigenvalue, -0.25141128, 2e-8);  // 48 and 96 elements
  EXPECT_TRUE(summary.is_resolved());
  EXPECT_EQ(read_rows(mode_columns(), path_of("ssh") / "modes.csv").size(), 12u);
}

// Next to a fold, where eigenvalues are known worst.
TEST(Modes, have_errors_that_bound_what_many_more_elements_give) {
  ModesInput input = oblate(model::Model::SBEH, 0.6, 0.07);
  const ModesSummary summary = run_modes(input, path_of("48"), "test");
  input.state.numerics.elements = 192;
  const ModesSummary fine = run_modes(input, path_of("192"), "test");
  for (const ModeRow& row : summary.modes) {
    const ModeRow& exact = find(fine, row.key.m, row.key.parity, row.key.number);
    const double eigenvalue = std::abs(row.eigenvalue - exact.eigenvalue),
                 rate = std::abs(row.rate - exact.rate);
    EXPECT_LT(eigenvalue, row.eigenvalue_error) << stem(row.key);
    EXPECT_LT(rate, row.rate_error) << stem(row.key);
    EXPECT_LT(row.eigenvalue_error, 3e-5 * std::abs(row.eigenvalue)) << stem(row.key);
    EXPECT_LT(row.rate_error, 3e-5 * std::abs(row.rate)) << stem(row.key);
    EXPECT_LT(exact.eigenvalue_error, row.eigenvalue_error / 16) << stem(row.key);
  }
}

// Their files take more triangles where few fold over; where none can, the tables are complete nevertheless.
TEST(Modes, of_narrow_necks_are_told_with_files_where_they_can_be_meshed) {
  ModesInput input;
  input.state = {.model = model::Model::SSH,
                 .branch = axisym::Branch::stomatocyte,
                 .reduced_volume = 0.55,
                 .material = input.state.material.with_L(0.05)};
  input.largest_m = 0;
  const auto file = [&](const char* folder) { return path_of(folder) / "modes/m0_none_1.vtu"; };
  EXPECT_TRUE(run_modes(input, path_of("narrow"), "test").warnings.empty());
  EXPECT_EQ(read_mode(file("narrow")).key.m, 0);
  input.state.reduced_volume = 0.2;
  const ModesSummary narrower = run_modes(input, path_of("narrower"), "test");
  ASSERT_EQ(narrower.warnings.size(), 1u);
  EXPECT_TRUE(narrower.warnings[0].starts_with("modes/m0_none_1.vtu is left out: no 5120 triang"));
  EXPECT_FALSE(exists(file("narrower")));
  EXPECT_EQ(read_rows(mode_columns(), path_of("narrower") / "modes.csv").size(), 1u);
}

TEST(Modes, of_a_row_of_a_scan_are_those_of_the_branch) {
  ScanInput scan;
  scan.reduced_volume = {0.7};
  scan.L = {0.05};
  scan.modes = 0;
  run_scan(scan, path_of("scan_of_one"), "test");
  ModesInput input = oblate(model::Model::SBEH, 0.7, 0.05);
  const ModesSummary branch = run_modes(input, path_of("branch"), "test");
  input.scan = path_of("scan_of_one").string();
  const ModesSummary row = run_modes(input, path_of("row"), "test");
  ASSERT_EQ(row.modes.size(), branch.modes.size());
  for (std::size_t k = 0; k < row.modes.size(); ++k)
    EXPECT_NEAR(row.modes[k].eigenvalue, branch.modes[k].eigenvalue,
                1e-9 * std::abs(branch.modes[k].eigenvalue));
}

// All modes count. They are of a sphere's l = m, m + 2, …, and variances fall like l⁻⁴: what is missing of the
// contour after n of them, like (m + 2n)⁻³.
TEST(Modes, fluctuate_by_kT_over_their_eigenvalue_and_add_up_to_the_contour) {
  constexpr int few = 6;
  ModesInput input = oblate(model::Model::SSH, 0.7, 0.05);
  input.number = 2 * few;
  input.thermal_energy = 1e-5;
  const auto folder = path_of("fluctuations");
  const ModesSummary summary = run_modes(input, folder, "test");
  std::map<int, double> of_few, of_all;
  for (const FluctuationRow& row : summary.fluctuations) {
    EXPECT_EQ(row.mean_square, 1e-5 / row.eigenvalue);
    if (row.key.m < 2 || row.key.parity != Parity::even) continue;
    const CsvTable mode = read_csv(folder / "modes" / (stem(row.key) + ".csv"));
    const double u = mode.number(mode.rows.size() / 2, "energy_displacement");  // at the equator
    const double part = row.mean_square * u * u;
    of_all[row.key.m] += part;
    if (row.key.number <= few) of_few[row.key.m] += part;
  }
  for (const auto& [m, sum] : of_all) {
    const double contour = summary.contour[std::size_t(m)].mean_square;
    EXPECT_LT(sum, contour) << m;
    const double ratio = (contour - of_few[m]) / (contour - sum);
    EXPECT_NEAR(ratio / std::pow((m + 4. * few) / (m + 2. * few), 3), 1, 0.2) << m;
  }
}

TEST(Modes, without_equilibrium_leave_their_fluctuations_empty_and_say_so) {
  ModesInput input = oblate(model::Model::SSH, 0.8, 0.05);
  input.thermal_energy = 1e-5;
  const ModesSummary summary = run_modes(input, path_of("unstable"), "test");
  ASSERT_EQ(summary.warnings.size(), 1u);
  EXPECT_TRUE(
      summary.warnings[0].starts_with("no equilibrium: the state is no minimum for m = 2,"));
  for (const FluctuationRow& row : summary.fluctuations)
    EXPECT_EQ(std::isnan(row.mean_square), row.eigenvalue < 0);
  for (const ContourRow& row : summary.contour)
    EXPECT_EQ(std::isnan(row.mean_square), row.m == 2) << row.m;
}

// A run that starts from it: its amplitude grows at one rate.
TEST(Modes, that_are_unstable_grow_in_3D) {
  const ModesSummary summary =
      run_modes(oblate(model::Model::SSH, 0.8, 0.05), path_of("growing"), "test");
  RunInput input;
  input.start = ModeStart{(path_of("growing") / "modes/m2_even_1.vtu").string(), 0.01};
  static_cast<Physics&>(input) = *origin_of(std::get<ModeStart>(input.start)).physics;
  input.numerics.tolerance = 1e-5;  // steps of 0.5 make the rate half a percent too small
  const FlowMoment start = start_of(input).moment;
  std::vector<AmplitudeAt> history;
  surface3d::run_flow(input.material, input.model, start, input.numerics,
                      {.end_time = 15, .output_times = {}, .stop_at_rest = false},
                      [&](const surface3d::FlowRecord& record, const surface3d::State& state,
                          const surface3d::StepView& view, bool) {
                        history.push_back({record.time, mode_amplitude(*view.mesh, state.X, 2, 2)});
                        return true;
                      });
  const auto growth = fit_growth(history);
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->rate, find(summary, 2, Parity::even).rate, 0.002 * growth->rate);
  EXPECT_LT(growth->error, 0.001 * growth->rate);
}

}  // namespace
}  // namespace sbeh::studies
