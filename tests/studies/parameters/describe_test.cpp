// Which kind an input is, and that its description reads back as the same input.
#include "studies/compare/compare_input.h"
#include "studies/evolution/relax_input.h"
#include "studies/parameters/input_kind.h"
#include "studies/scan/scan_input.h"
#include "tests/studies/parameters/input_file.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace sbeh::studies {
namespace {

using namespace test;

ScanInput scan_of(const std::string& text) { return read_scan(written(text)); }
RelaxInput relax_of(const std::string& text) { return read_relax(written(text)); }

TEST(InputKind, is_told_by_the_tables) {
  EXPECT_EQ(kind_of(written(small_scan)), InputKind::scan);
  EXPECT_EQ(kind_of(written(small_relax)), InputKind::relax);
  const std::vector<Case> neither_or_both{
      {"",
       ": must have a table [scan] (a scan), [start] (one axisymmetric evolution), [surface] "
       "(one 3D run), [compare] (one case by several methods), [stability] (axisymmetric "
       "states, perturbed in 3D), [modes] (the modes of one state), [states] (rest states in "
       "3D), [diagram] (a classical phase diagram) or [sweep] (many runs of one of these); it has "
       "none of them"},
      {"[scna]", ":1: [scna]: unknown table; did you mean \"scan\"?"},
      {"[scan]\n[start]",
       ": must have only one of [scan] (a scan), [start] (one axisymmetric evolution), [surface] "
       "(one 3D run), [compare] (one case by several methods), [stability] (axisymmetric "
       "states, perturbed in 3D), [modes] (the modes of one state), [states] (rest states in "
       "3D), [diagram] (a classical phase diagram) or [sweep] (many runs of one of these)"},
  };
  expect_messages(kind_of, "", neither_or_both);
}

TEST(Description, of_a_scan_reads_back_as_the_same_scan) {
  const std::vector<std::string> texts{
      small_scan, small_scan + "beyond_fold = true\n",
      "[scan]\nreduced_volume = { from = 0.61, to = 0.93, count = 77 }\n"
      "L = { from = 0.00123456789012345678, to = 0.3, count = 9, spacing = \"log\" }\n"
      "models = [\"SSH\", \"SBEH\"]\nmethod = \"flow\"\nend_time = 1e17\n"
      "[material]\npotential = [1e-300, 0.1, 0.30000000000000004, 0, 1e22, 0]\nfriction = 1e-5\n"
      "order_viscosity = -0.3333333333333333\n[numerics]\nelements = 9\nextrapolate = false\n"
      "smallest_step = 1e-15\n"};
  for (const std::string& text : texts) {
    const ScanInput input = scan_of(text);
    const std::string description = describe(input, "1.2.3");
    EXPECT_EQ(description.substr(0, description.find('\n')),
              "# sbeh 1.2.3: every parameter of this run; can be run again");
    EXPECT_EQ(input, scan_of(description));
    EXPECT_EQ(describe(scan_of(description), "1.2.3"), description);
  }
}

TEST(Description, of_an_evolution_reads_back_as_the_same_evolution) {
  const std::string end = "[time]\nend = 0.3\n[material]\nL1 = 0.1\nL2 = -0.05\nL3 = 0.07\n";
  const std::string ellipsoid = "[start]\nshape = 'ellipsoid'\n";
  const std::string harmonics = "[start]\nshape = 'harmonics'\n";
  const std::string row = "[start]\nshape = 'scan'\nreduced_volume = 0.7\nL = 0.03\n";
  const std::string sbeh = "model = 'SBEH'\n", ssh = "model = 'SSH'\n";
  const std::string scan = scan_folder("[material]\nresidual_stiffness = 0.25\n");
  // All of the material: the scan is not asked.
  const std::string all_else =
      "potential = [0, 1, 2]\nfriction = 3\nviscosity = 4\nimmobility = 5\norder_viscosity = 6\n"
      "residual_stiffness = 7\nspontaneous_curvature = 8\n"
      "flexoelectric = [0, 9]\n";
  const std::vector<std::string> texts{
      small_relax,
      ssh + ellipsoid + "reduced_volume = 0.7\nkind = 'prolate'\n" + end,
      "model = 'Helfrich-global'\n" + ellipsoid + "reduced_volume = 0.8\n" + end,
      "model = 'Helfrich-local'\n" + row + "folder = '" + scan + "'\n[time]\nend = 2\n",
      sbeh + ellipsoid + "axes = [1, 0.1]\norder = 0.1\n" + end,
      sbeh + harmonics + "modes = [[32, 0.1], [1, -1e-9]]\norder = 0.65\n" + end,
      ssh + harmonics + "modes = [[2, 1], [3, 0.1]]\nreduced_volume = 0.95\n" + end,
      ssh + ellipsoid + "reduced_volume = 0.8\nperturbation = [[3, 0.1], [2, -1e-9]]\n" + end,
      sbeh + harmonics + "order_modes = [[4, 1e-3]]\n" + end,
      sbeh + row + "folder = '" + scan + "'\nmodel = 'SSH'\n[time]\nend = 2\n",
      row + "folder = '" + scan + "'\nmodel = 'SSH'\n[time]\nend = 2\n",
      sbeh + row + "folder = '\"a\\b\" \xc3\xa4'\n" + end + all_else,
  };
  for (const std::string& text : texts) {
    const RelaxInput input = relax_of(text);
    const std::string description = describe(input, "1.2.3");
    EXPECT_EQ(input, relax_of(description));
    EXPECT_EQ(describe(relax_of(description), "1.2.3"), description);
  }
}

TEST(Description, of_a_comparison_reads_back_as_the_same_comparison) {
  const std::string head = "[compare]\nmodel = 'SSH'\nreduced_volume = 0.71\nL = 0.03\n";
  const std::vector<std::string> texts{
      head + "methods = ['newton', 'shooting']\n",
      head
          + "branch = 'prolate'\nmethods = ['minimiser', 'newton']\n[material]\n"
            "residual_stiffness = 0.1\n[numerics]\nelements = 64\n[tolerance]\nenergy = 1e-9\n"
            "distance = 0.1\n",
      head
          + "methods = ['surface3d', 'newton']\n[surface3d]\ntriangles = 80\nstart = 'revolved'\n"
            "end = 3\ntolerance = 1e-4\nrest_speed = 1e-3\n[tolerance_3d]\nenergy_bending = 1\n",
      head + "methods = ['newton', 'surface3d']\n[surface3d]\nrun = 'a \"folder\"'\n",
  };
  for (const std::string& text : texts) {
    const CompareInput input = read_compare(written(text));
    const std::string description = describe(input, "1.2.3");
    const CompareInput again = read_compare(written(description));
    EXPECT_EQ(input, again);
    EXPECT_EQ(describe(again, "1.2.3"), description);
  }
}

TEST(Description, keeps_every_bit_of_a_number) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300, 300), mantissa(1, 10);
  ScanInput input = scan_of(small_scan);
  input.L.clear();
  for (int i = 0; i < 1000; ++i)
    input.L.push_back(mantissa(random) * std::pow(10, exponent(random)));
  std::sort(input.L.begin(), input.L.end());
  EXPECT_EQ(input, scan_of(describe(input, "0")));
}

TEST(Description, has_lines_of_at_most_a_hundred_letters) {
  std::istringstream lines(describe(relax_of(small_relax), "0"));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

}  // namespace
}  // namespace sbeh::studies
