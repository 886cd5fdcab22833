// The classical phase diagrams as `sbeh diagram` leaves them.
#include "studies/diagram/diagram.h"

#include "studies/io/output.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace sbeh::studies {
namespace {

using std::numbers::pi;

std::vector<Bifurcation> rows_of_diagram(const DiagramInput& input) {
  const sbeh::test::TemporaryFolder folder;
  const auto results = folder.path() / "diagram";
  const DiagramSummary s = run_diagram(input, results, "test");
  EXPECT_FALSE(s.interrupted);
  EXPECT_TRUE(s.missing.empty());
  EXPECT_EQ(read_diagram(results / "run.toml"), input);
  return read_rows(bifurcation_columns(), results / "bifurcations.csv");
}

// The one of this kind, branch and origin with this H₀ and the largest V_r.
std::optional<Bifurcation> find(const std::vector<Bifurcation>& rows, const std::string& kind,
                                const std::string& branch, const std::string& from, double H0) {
  std::optional<Bifurcation> found;
  for (const Bifurcation& row : rows)
    if (row.kind == kind && row.branch == branch && row.from == from
        && std::abs(row.at.H0 - H0) < 1e-9
        && (!found || row.at.reduced_volume > found->at.reduced_volume))
      found = row;
  return found;
}

struct Known {
  const char *kind, *branch, *from;
  double H0, reduced_volume;
};
// Without spontaneous curvature by shooting at a tolerance of 1e-16; else by an independent spectral calculation.
constexpr Known known[]{
    {"symmetry_loss", "stomatocyte", "oblate", 0, 0.510438922363},
    {"fold", "stomatocyte", "oblate", 0, 0.660850326522894},
    {"equal_energy", "oblate", "prolate", 0, 0.651076483847198},
    {"equal_energy", "oblate", "stomatocyte", 0, 0.591189070899419},
    {"mode_2", "oblate", "", 0, 0.749729050},
    {"symmetry_loss", "pear", "prolate", -3, 0.752601896165},
    {"symmetry_loss", "stomatocyte", "oblate", 2.4, 0.731398942384},
};

TEST(Diagram, of_spontaneous_curvature_has_the_known_points) {
  DiagramInput input;
  input.values = {-2.4, 0, 3};
  input.least_volume = 0.45;
  input.modes = 2;
  const auto rows = rows_of_diagram(input);
  for (const Known& point : known) {
    SCOPED_TRACE(std::string(point.kind) + " of " + point.branch);
    const auto row = find(rows, point.kind, point.branch, point.from, point.H0);
    ASSERT_TRUE(row);
    const bool by_energy = row->kind == "equal_energy";  // U is promised to 1e-8 of itself
    EXPECT_NEAR(row->at.reduced_volume, point.reduced_volume, by_energy ? 5e-9 : 1e-9);
    EXPECT_LE(row->error, by_energy ? 5e-8 : 1e-9);
  }
  // Two spheres with 1/R + 1/r = 3, or 1/r − 1/R = 2.4.
  for (const auto& [branch, from, H0] :
       {std::tuple{"pear", "prolate", -3.}, {"stomatocyte", "oblate", 2.4}}) {
    const auto limit = find(rows, "limit", branch, from, H0);
    ASSERT_TRUE(limit) << branch;
    EXPECT_EQ(limit->error, 0);
    const double side = H0 < 0 ? 1 : -1, sum = -limit->at.W2 / (8 * pi);  // R ± r
    const double R = (sum + std::sqrt(2 - sum * sum)) / 2, r = std::sqrt(1 - R * R);
    EXPECT_NEAR(-(1 / R + side / r), H0, 1e-9);
    EXPECT_NEAR(limit->at.reduced_volume, R * R * R + side * r * r * r, 1e-9);
  }
}

// The same shape in the three ensembles: where a pear leaves does not depend on it.
TEST(Diagram, of_an_area_difference_has_the_shapes_of_spontaneous_curvature) {
  for (const auto& [kind, value, least_volume] :
       {std::tuple{DiagramKind::bilayer_coupling, 1.2, 0.7},
        {DiagramKind::area_difference, 1.7, 0.83}}) {
    DiagramInput input;
    input.kind = kind;
    input.values = {value};
    input.modes = 0;
    input.least_volume = least_volume;
    const auto rows = rows_of_diagram(input);
    const auto loss = std::ranges::find_if(rows, [](const Bifurcation& row) {
      return row.kind == "symmetry_loss" && row.branch == "pear";
    });
    ASSERT_NE(loss, rows.end()) << name(kind);
    if (kind == DiagramKind::bilayer_coupling) {
      EXPECT_NEAR(loss->at.W2, -8 * pi * value, 1e-8);
    } else {  // Δa₀ = Δa + c/(2πακ), c = −κH₀
      EXPECT_NEAR(-loss->at.W2 / (8 * pi) - loss->at.H0 / (2 * pi * 1.4), value, 1e-8);
    }
    DiagramInput same;
    same.values = {-loss->at.H0};
    same.modes = 0;
    same.least_volume = least_volume;
    const auto there = find(rows_of_diagram(same), "symmetry_loss", "pear", "prolate", loss->at.H0);
    ASSERT_TRUE(there) << name(kind);
    EXPECT_NEAR(there->at.reduced_volume, loss->at.reduced_volume, 5e-9) << name(kind);
    EXPECT_NEAR(there->at.W2, loss->at.W2, 1e-7) << name(kind);
  }
}

TEST(Diagram, goes_on_where_values_are_there_and_takes_no_folder_of_another) {
  const sbeh::test::TemporaryFolder folder;
  DiagramInput input;
  input.values = {-1, 0, 1};
  input.least_volume = 0.85;
  input.modes = 0;
  const auto whole = folder.path() / "whole", cut = folder.path() / "cut";
  EXPECT_EQ(run_diagram(input, whole, "test").computed, 3);
  EXPECT_EQ(run_diagram(input, whole, "test").computed, 0);

  // As if the middle value had not been reached.
  std::filesystem::copy(whole, cut, std::filesystem::copy_options::recursive);
  for (const char* name : {"branches.csv", "bifurcations.csv", "shapes.csv"}) {
    std::istringstream lines(read_file(cut / name));
    std::string kept, line;
    while (std::getline(lines, line)) {
      const bool is_middle = std::string(name) == "shapes.csv"
                               ? line.find(",0,") != std::string::npos
                               : line.ends_with(",0");
      if (!is_middle) kept += line + "\n";
    }
    write_file(cut / name, kept);
  }
  EXPECT_EQ(run_diagram(input, cut, "test").computed, 1);
  for (const char* name : {"branches.csv", "bifurcations.csv"})
    EXPECT_EQ(read_file(cut / name), read_file(whole / name)) << name;

  input.modes = 1;
  EXPECT_THROW(run_diagram(input, whole, "test"), OutputError);
}

}  // namespace
}  // namespace sbeh::studies
