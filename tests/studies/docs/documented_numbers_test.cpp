// The numbers that the documents print, computed anew. Where a number comes from one method, another one has to
// find it too.
#include "axisym/rim/beyond_fold.h"
#include "axisym/rim/nested_spheres.h"
#include "axisym/shooting/seifert_shooting.h"
#include "axisym/spectral/minimiser.h"
#include "axisym/stationary/classical_branches.h"
#include "studies/io/csv.h"
#include "studies/modes/modes.h"
#include "studies/scan/branch_lines.h"
#include "studies/scan/scan.h"
#include "studies/scan/stability_lines.h"
#include "tests/studies/docs/document.h"
#include "tests/studies/parameters/input_file.h"

#include <fmt/format.h>

namespace sbeh::studies {
namespace {

using namespace test;
using axisym::RimKind;
using axisym::RimRecord;
using model::Model;

std::filesystem::path scanned(const std::string& name, const ScanInput& input) {
  EXPECT_EQ(run_scan(input, path_of(name), "test").failed, 0);
  return path_of(name);
}

// ---- README.md: the classical diagram ---------------------------------------------------------------

// Shooting and minimisation share nothing; both are good to ten digits (tests/axisym).
TEST(ReadmeTable, of_special_points_is_that_of_shooting_and_of_minimisation) {
  const auto rows = table_below("README.md", "| special point |");
  ASSERT_EQ(rows.size(), 5u);
  for (const axisym::SpecialPoints& p :
       {axisym::shoot_special_points(), axisym::minimise_special_points()}) {
    const axisym::SpecialPoint points[] = {p.prolate_oblate, p.oblate_stomatocyte,
                                           p.stomatocyte_fold, p.oblate_symmetry_loss,
                                           p.oblate_self_contact};
    for (std::size_t k = 0; k < 5; ++k) {
      SCOPED_TRACE(rows[k][0]);
      expect_printed(rows[k][1], points[k].reduced_volume, 1e-10);
      expect_printed(rows[k][2], points[k].energy, 1e-9);
    }
  }
}

// ---- studies/docs/units.md ---------------------------------------------------------------------------

TEST(UnitsTable, follows_from_the_rigidity_and_the_surface_viscosity) {
  constexpr double thermal = 1.380649e-23 * 300, rigidity = 20 * thermal, surface_viscosity = 5e-10;
  const model::Material material = model::Material{}.with_L(0.05);
  const double unit = rigidity / material.kappa(model::full_order);
  const double decay = std::sqrt(material.l1() / material.potential.curvature(model::full_order));
  const auto rows = table_below("studies/docs/units.md", "| R (µm) | E₀ (k_BT) |");
  ASSERT_EQ(rows.size(), 3u);
  for (const auto& row : rows) {
    const double R = 1e-6 * std::stod(row[0]);
    const double expected[] = {unit / thermal, surface_viscosity * R * R / unit, unit / (R * R),
                               unit / (R * R * R), 1e9 * decay * R};
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NEAR(std::stod(row[k + 1]) / expected[k], 1, 1.2e-3)
          << row[0] << " " << k;  // three digits
  }
}

// ---- studies/docs/stability.md -----------------------------------------------------------------------

// In other steps of L than those of the scan that was printed, with finer elements.
TEST(StabilityTable, of_the_ordered_oblates_is_that_of_their_lines) {
  const auto rows =
      table_below("studies/docs/stability.md", "| V_r | minimum from L | m = 1 from L |");
  ScanInput input;
  for (const auto& row : rows) input.reduced_volume.push_back(std::stod(row[0]));
  input.L = {0.02, 0.055, 0.09, 0.122, 0.152, 0.173, 0.185};
  input.models = {Model::SBEH};
  input.modes = 2;
  input.numerics.elements = 64;
  const auto folder = scanned("stability_lines", input);
  const auto lines = read_rows(stability_line_columns(), folder / "stability_lines.csv");
  const auto of = [&](double volume, int m) {  // ascending
    std::vector<double> L;
    for (const StabilityLineRow& line : lines)
      if (line.along == Along::L && line.reduced_volume == volume && line.m == m)
        L.push_back(line.L);
    std::ranges::sort(L);
    return L;
  };
  const auto folds = read_rows(fold_columns(), folder / "folds.csv");
  ASSERT_EQ(folds.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    SCOPED_TRACE(rows[k][0]);
    const auto first = of(input.reduced_volume[k], 1);
    auto second = of(input.reduced_volume[k], 2);
    if (rows[k][1] == "0") second.insert(second.begin(), 0);
    ASSERT_EQ(first.size(), 1u);
    ASSERT_EQ(second.size(), 2u);
    expect_printed(rows[k][1], second[0], 1e-7);
    expect_printed(rows[k][2], first[0], 1e-7);
    expect_printed(rows[k][3], second[1], 1e-7);
    expect_printed(rows[k][4], folds[k].L, 1e-7);
  }
}

TEST(StabilityTable, of_the_limit_of_m_2_is_that_of_the_lines) {
  const auto rows = table_below("studies/docs/stability.md", "| L | V_r of m = 2 |");
  ScanInput input;
  input.reduced_volume = {0.735, 0.78, 0.81};
  for (const auto& row : rows) input.L.push_back(std::stod(row[0]));
  input.modes = 2;
  input.numerics.elements = 64;
  const auto lines =
      read_rows(stability_line_columns(), scanned("limit_of_m_2", input) / "stability_lines.csv");
  for (const auto& row : rows) {
    double largest = 0;
    for (const StabilityLineRow& line : lines)
      if (line.along == Along::reduced_volume && line.L == std::stod(row[0]) && line.m == 2) {
        if (line.model == Model::SBEH) {
          largest = std::max(largest, line.reduced_volume);
        } else {
          EXPECT_NEAR(line.reduced_volume, 0.749729050, 1e-9);
        }
      }
    expect_printed(row[1], largest, 1e-8);
  }
}

// ---- studies/docs/beyond_fold.md -------------------------------------------------------------------------

const RimRecord* find(const std::vector<RimRecord>& rows, RimKind kind) {
  for (const RimRecord& row : rows)
    if (row.kind == kind) return &row;
  return nullptr;
}

const std::string& fold_table() {
  static const std::string header = "| V_r | fold of the smooth oblate |";
  return header;
}

// Seven printed digits; both discretisations agree on folds to 1e-7.
TEST(BeyondFoldTable, is_that_of_the_graded_elements) {
  for (const auto& row : table_below("studies/docs/beyond_fold.md", fold_table())) {
    SCOPED_TRACE("V_r = " + row[0]);
    const auto states = axisym::beyond_fold({}, printed(row[0]).value, std::vector<double>{});
    const RimRecord *fold = find(states, RimKind::fold),
                    *second = find(states, RimKind::second_fold),
                    *equal = find(states, RimKind::equal_energy);
    ASSERT_TRUE(fold && equal);
    expect_printed(row[1], fold->L, 1e-7);
    ASSERT_EQ(row[2] == "none", second == nullptr);
    if (second) expect_printed(row[2], second->L, 1e-7);
    expect_printed(row[3], equal->L, 1e-7);
    EXPECT_EQ(row[4] == "kink", equal->order_rim == 0) << row[4];
    if (row[4] == "kink") continue;
    const std::string beta = "β = ", H = ", H = ";
    const std::size_t comma = row[4].find(H);
    ASSERT_TRUE(row[4].starts_with(beta) && comma != std::string::npos) << row[4];
    expect_printed(row[4].substr(beta.size(), comma - beta.size()), equal->order_rim, 1e-5);
    // At the L of equal energy, known to 1e-7, H grows as 1/β² does.
    expect_printed(row[4].substr(comma + H.size()), equal->H_rim, 1e-3 * std::abs(equal->H_rim));
  }
}

// The finite elements' fold is good to 1e-6 of L with 48 elements.
TEST(BeyondFoldTable, has_the_folds_of_the_finite_elements) {
  const auto rows = table_below("studies/docs/beyond_fold.md", fold_table());
  ScanInput input;
  for (const auto& row : rows) input.reduced_volume.push_back(printed(row[0]).value);
  input.L = {0.05};
  input.models = {Model::SBEH};
  const CsvTable folds = read_csv(scanned("folds", input) / "folds.csv");
  ASSERT_EQ(folds.rows.size(), rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    expect_printed(rows[k][1], folds.number(k, "L"), 1e-6 * folds.number(k, "L"));
}

// Energies of the graded elements are good to 1e-8, those of a scan's 48 elements to 1e-9 of themselves.
TEST(RivalsTable, has_smooth_and_sharp_energies_at_the_papers_points) {
  for (const auto& row :
       table_below("studies/docs/beyond_fold.md", "| V_r | L | smooth | sharp |")) {
    SCOPED_TRACE("V_r = " + row[0] + ", L = " + row[1]);
    const double v = printed(row[0]).value, L = printed(row[1]).value;
    ScanInput input;
    input.reduced_volume = {v};
    input.L = {L};
    input.models = {Model::SBEH};
    const CsvTable scan =
        read_csv(scanned(std::string("smooth").append(row[0]).append(row[1]), input) / "scan.csv");
    expect_printed(row[2], scan.number(0, "energy"), 1e-8);
    const auto states = axisym::beyond_fold({}, v, std::vector{L});
    const RimRecord* sharp = find(states, RimKind::sharp);
    ASSERT_TRUE(sharp);
    expect_printed(row[3], sharp->energy, 1e-8);
    EXPECT_LT(sharp->energy, scan.number(0, "energy"));
  }
}

TEST(NestedSpheresTable, has_the_limit_and_the_stomatocytes_of_a_scan) {
  const auto rows = table_below("studies/docs/beyond_fold.md", "| V_r | SSH's stomatocyte |");
  ASSERT_EQ(rows.size(), 3u);
  ScanInput input;
  for (const auto& row : rows) input.reduced_volume.push_back(printed(row[0]).value);
  input.L = {0.0155};
  input.models = {Model::SSH};
  input.branches = {axisym::Branch::stomatocyte};
  input.numerics.elements = 120;
  const CsvTable scan = read_csv(scanned("nested", input) / "scan.csv");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double v = input.reduced_volume[k];
    expect_printed(rows[k][1], scan.number(k, "energy"), 1e-6);
    expect_printed(rows[k][2], axisym::nested_spheres({}, v, 0.0155).energy, 1e-12);
  }
}

// ---- studies/docs/order.md -------------------------------------------------------------------------------

struct Pair {
  std::size_t ssh, sbeh;
};
Pair find(const CsvTable& scan, double reduced_volume, double L) {
  Pair pair{scan.rows.size(), scan.rows.size()};
  for (std::size_t k = 0; k < scan.rows.size(); ++k) {
    if (scan.number(k, "reduced_volume") != reduced_volume || scan.number(k, "L") != L) continue;
    (scan.text(k, "model") == "SSH" ? pair.ssh : pair.sbeh) = k;
  }
  EXPECT_LT(std::max(pair.ssh, pair.sbeh), scan.rows.size()) << reduced_volume << " " << L;
  return pair;
}

// Energies are good to 1e-8; order and curvature at the rim to fourth order, 1e-5 (tests/axisym).
TEST(OrderTable, of_oblates_is_that_of_a_scan) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.7, 0.8, 0.9};
  input.L = {0.01, 0.03, 0.05, 0.07};
  const CsvTable scan = read_csv(scanned("order", input) / "scan.csv");
  const auto expect_energies = [&](const Pair& at, const std::vector<std::string>& row) {
    const double ssh = scan.number(at.ssh, "energy"), sbeh = scan.number(at.sbeh, "energy");
    expect_printed(row[1], ssh, 1e-7);
    expect_printed(row[2], sbeh, 1e-7);
    expect_printed(row[3], ssh - sbeh, 2e-7);
    return ssh - sbeh;
  };
  const auto softening = [&](std::size_t k) {
    return std::pow(1.5 * scan.number(k, "order_min"), 2);
  };
  for (const auto& row : table_below("studies/docs/order.md", "| V_r | U, SSH |")) {
    SCOPED_TRACE("V_r = " + row[0]);
    const Pair at = find(scan, printed(row[0]).value, 0.05);
    expect_energies(at, row);
    expect_printed(row[4], scan.number(at.sbeh, "order_min"), 1e-5);
    expect_printed(row[5], softening(at.sbeh), 5e-5);
    const auto expect_pair = [&](const std::string& text, const char* quantity) {
      const std::string arrow = " → ";
      const std::size_t split = text.find(arrow);
      ASSERT_NE(split, std::string::npos) << text;
      expect_printed(text.substr(0, split), scan.number(at.ssh, quantity), 1e-4);
      expect_printed(text.substr(split + arrow.size()), scan.number(at.sbeh, quantity), 1e-4);
    };
    expect_pair(row[6], "H_abs_max");
    expect_pair(row[7], "thickness_pole");
  }
  for (const auto& row : table_below("studies/docs/order.md", "| L | U, SSH |")) {
    SCOPED_TRACE("L = " + row[0]);
    const double L = printed(row[0]).value;
    const Pair at = find(scan, 0.6, L);
    const double gap = expect_energies(at, row);
    expect_printed(row[4], gap / (L * L), 2e-7 / (L * L));
    expect_printed(row[5], scan.number(at.sbeh, "order_min"), 1e-5);
    expect_printed(row[6], softening(at.sbeh), 5e-5);
  }
}

// The classical point is that of shooting; the others lie on the line of a scan.
TEST(OrderTable, of_equal_energies_of_oblate_and_prolate_is_that_of_a_scan) {
  const auto lines = lines_of("studies/docs/order.md");
  const auto L_row = std::ranges::find_if(
      lines, [](const std::string& line) { return line.starts_with("| L | 0 |"); });
  ASSERT_NE(L_row, lines.end());
  const auto L = fields_of(*L_row), V = fields_of(*(L_row + 2));
  ASSERT_EQ(L.size(), V.size());
  ScanInput input;
  input.reduced_volume = {0.64, 0.66, 0.68, 0.7, 0.72};
  for (std::size_t k = 2; k < L.size(); ++k) input.L.push_back(printed(L[k]).value);
  input.models = {Model::SBEH};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate};
  const CsvTable line = read_csv(scanned("equal", input) / "equal_energy.csv");
  expect_printed(V[1], axisym::shoot_special_points().prolate_oblate.reduced_volume, 1e-10);
  ASSERT_EQ(line.rows.size(), input.L.size());
  for (std::size_t k = 0; k < input.L.size(); ++k)
    expect_printed(V[k + 2], line.number(k, "reduced_volume"), 1e-6);
}

TEST(OrderTable, of_the_ends_of_both_branches_is_that_of_a_scan) {
  const auto rows = table_below("studies/docs/order.md", "| V_r | oblate | prolate |");
  ScanInput input;
  for (const auto& row : rows) input.reduced_volume.push_back(printed(row[0]).value);
  input.L = {0.05};
  input.models = {Model::SBEH};
  input.branches = {axisym::Branch::oblate, axisym::Branch::prolate};
  const CsvTable folds = read_csv(scanned("ends", input) / "folds.csv");
  ASSERT_EQ(folds.rows.size(), 2 * rows.size());
  for (std::size_t k = 0; k < folds.rows.size(); ++k) {
    const auto& row = rows[k % rows.size()];
    SCOPED_TRACE(folds.text(k, "branch") + " " + row[0]);
    EXPECT_EQ(folds.number(k, "reduced_volume"), printed(row[0]).value);
    expect_printed(row[folds.text(k, "branch") == "oblate" ? 1 : 2], folds.number(k, "L"), 1e-6);
  }
}

// ---- README.md and the paper: rest energies ---------------------------------------------------------

// At the paper's points the energies of tests/tools/paper_scan_test.cpp are this program's with finer elements.
// Here SSH by shooting: U = 2L (F − 4π) − 4π with κ = −κ_G = 2L; what the elements leave is 1e-9 of U.
TEST(PaperScan, of_SSH_has_the_energies_of_shooting) {
  using std::numbers::pi;
  ScanInput input;
  input.reduced_volume = {0.6, 0.7, 0.8};
  input.L = {0.01, 0.03, 0.05, 0.07};
  input.models = {Model::SSH};
  const CsvTable scan = read_csv(scanned("paper", input) / "scan.csv");
  ASSERT_EQ(scan.rows.size(), 12u);
  const auto shapes = axisym::shoot_branch(axisym::Branch::oblate, input.reduced_volume);
  for (std::size_t k = 0; k < scan.rows.size(); ++k) {
    const auto at = std::ranges::find(input.reduced_volume, scan.number(k, "reduced_volume"));
    const double F = 8 * pi * shapes[std::size_t(at - input.reduced_volume.begin())].energy;
    const double expected = 2 * scan.number(k, "L") * (F - 4 * pi) - 4 * pi;
    EXPECT_NEAR(scan.number(k, "energy") / expected, 1, 2e-9)
        << scan.text(k, "reduced_volume") << " " << scan.text(k, "L");
  }
}

// ---- studies/docs/stability.md ---------------------------------------------------------------------

// Rates are good to 1e-6 of themselves with the default elements, next to the fold to 1e-5.
TEST(StabilityTable, of_the_papers_oblates_is_that_of_the_modes) {
  struct State {
    Model model;
    double L;
  };
  constexpr std::array states{State{Model::SSH, 0.05}, State{Model::SBEH, 0.01},
                              State{Model::SBEH, 0.03}, State{Model::SBEH, 0.05},
                              State{Model::SBEH, 0.07}};
  const auto rows = table_below("studies/docs/stability.md", "| m | V_r |");
  ASSERT_EQ(rows.size(), 9u);
  for (const double v : {0.6, 0.7, 0.8})
    for (std::size_t k = 0; k < states.size(); ++k) {
      ModesInput input;
      input.state.model = states[k].model;
      input.state.reduced_volume = v;
      input.state.material = input.state.material.with_L(states[k].L);
      input.largest_m = 3;
      const ModesSummary summary =
          run_modes(input, path_of(fmt::format("modes_{}_{}", v, k)), "test");
      const double kappa = input.state.material.kappa(model::full_order);
      for (const auto& row : rows) {
        if (printed(row[1]).value != v) continue;
        const int m = int(printed(row[0]).value);
        const auto mode = std::ranges::find_if(summary.modes, [&](const ModeRow& one) {
          return one.key.m == m && one.key.parity == axisym::Parity::even;
        });
        SCOPED_TRACE(fmt::format("m = {}, V_r = {}, column {}", m, v, k));
        expect_printed(row[k + 2], mode->rate / kappa, 1e-5 * std::abs(mode->rate / kappa));
      }
    }
}

}  // namespace
}  // namespace sbeh::studies
