// Independent methods find the same state: energies, multipliers, order, curvature and profile.
#include "studies/compare/compare.h"

#include "tests/studies/parameters/input_file.h"

#include <fmt/format.h>

#include <cstdio>
#include <tuple>

namespace sbeh::studies {
namespace {

using namespace test;

// What the finite elements leave with 96 elements; the two others agree to ten digits.
const std::string tolerances =
    "[numerics]\nelements = 96\n[tolerance]\nenergy = 1e-8\nenergy_distortion = 1e-8\n"
    "energy_bending = 1e-8\nenergy_thermotropic = 1e-8\npressure = 1e-5\ntension = 1e-5\n"
    "order_mean = 1e-7\norder_min = 1e-5\norder_max = 1e-5\nH_pole = 1e-4\ndistance = 1e-5\n";

CompareSummary compared(const std::string& name, const std::string& text) {
  return run_compare(read_compare(written(text)), path_of(name), "test");
}

void expect_agreement(const CompareSummary& summary) {
  std::printf("%s", table_of(summary).c_str());
  EXPECT_TRUE(summary.agrees());
  for (const std::string& sentence : complaints(summary)) ADD_FAILURE() << sentence;
}

TEST(ThreeMethods, agree_on_a_classical_shape_of_every_branch) {
  for (const auto& [branch, volume] :
       {std::pair{"oblate", "0.8"}, {"prolate", "0.7"}, {"stomatocyte", "0.6"}}) {
    SCOPED_TRACE(branch);
    expect_agreement(compared(branch, std::string("[compare]\nmodel = 'SSH'\nL = 0.05\n")
                                          + "methods = ['newton', 'shooting', 'minimiser']\n"
                                          + "branch = '" + branch + "'\nreduced_volume = " + volume
                                          + "\n" + tolerances));
  }
}

TEST(ThreeMethods, agree_with_a_residual_stiffness) {
  const CompareSummary summary =
      compared("stiff",
               "[compare]\nmodel = 'SSH'\nL = 0.05\nmethods = ['shooting', 'newton', 'minimiser']\n"
               "reduced_volume = 0.75\n[material]\nresidual_stiffness = 0.02\n"
                   + tolerances);
  expect_agreement(summary);
}

TEST(TwoMethods, agree_on_ordered_shapes) {
  for (const auto& [branch, volume] : {std::pair{"oblate", "0.7"}, {"prolate", "0.8"}}) {
    SCOPED_TRACE(branch);
    expect_agreement(compared(std::string("ordered_") + branch,
                              std::string("[compare]\nmodel = 'SBEH'\nL = 0.05\n")
                                  + "methods = ['newton', 'minimiser']\nbranch = '" + branch
                                  + "'\nreduced_volume = " + volume + "\n" + tolerances));
  }
}

// What both know of a material, beyond that of the classical shapes.
TEST(TwoMethods, agree_with_all_that_a_material_may_have) {
  int k = 0;
  for (const auto& [model, volume, material] :
       {std::tuple{"SSH", "0.8", "spontaneous_curvature = -1"},
        {"SSH", "0.7", "flexoelectric = [0, 0.05]"},
        {"SSH", "0.8", "area_difference = { stiffness = 0.14, delta_a0 = 1.05 }"},
        {"SSH", "0.8", "area_difference = { stiffness = inf, delta_a0 = 1.036 }"},
        {"SBEH", "0.8", "area_difference = { stiffness = 0.14, delta_a0 = 1.05 }"},
        {"SBEH", "0.8", "spontaneous_curvature = -1\nflexoelectric = [0, -0.1]"},
        {"SBEH", "0.8", "lipid_density = [0.77, 0.27, 0.2]"}}) {
    SCOPED_TRACE(material);
    expect_agreement(compared(fmt::format("material_{}", ++k),
                              fmt::format("[compare]\nmodel = '{}'\nL = 0.05\nreduced_volume = {}\n"
                                          "methods = ['newton', 'minimiser']\n[material]\n{}\n{}",
                                          model, volume, material, tolerances)));
  }
}

// 80 triangles leave 4e-5 of the energy, four times as many less than a tenth of it.
TEST(Surface, relaxed_from_an_ellipsoid_agrees_with_the_three_other_methods) {
  expect_agreement(compared(
      "surface",
      "[compare]\nmodel = 'SSH'\nreduced_volume = 0.8\nL = 0.05\n"
      "methods = ['newton', 'shooting', 'minimiser', 'surface3d']\n"
      "[surface3d]\ntriangles = 80\nend = 3\n[tolerance_3d]\nenergy = 1e-4\nenergy_bending = 1e-4\n"
      "pressure = 1e-3\ntension = 1e-3\nH_pole = 1e-2\ndistance = 1e-3\n"));
}

// Without an axis; from the 3D solver's surface or an ellipsoid.
TEST(Harmonics, agree_with_the_axisymmetric_methods_and_the_3D_solver) {
  const std::string head = "[compare]\nmodel = 'SSH'\nL = 0.05\nreduced_volume = ";
  expect_agreement(compared(
      "harmonics", head
                       + "0.8\nmethods = ['minimiser', 'surface3d', 'harmonics']\n"
                         "[surface3d]\ntriangles = 80\nend = 3\n[tolerance_3d]\nenergy = 1e-4\n"
                         "pressure = 1e-3\ntension = 1e-3\nH_pole = 1e-2\ndistance = 1e-3\n"));
  for (const auto& [branch, volume] :
       {std::pair{"oblate", "0.8"}, {"oblate", "0.65"}, {"prolate", "0.8"}, {"prolate", "0.65"}}) {
    SCOPED_TRACE(std::string(branch) + " " + volume);
    expect_agreement(compared(std::string("harmonics_") + branch + volume,
                              head + volume + "\nbranch = '" + branch
                                  + "'\nmethods = ['minimiser', 'harmonics']\n"
                                    "[tolerance_3d]\nenergy = 1e-6\npressure = 1e-4\n"
                                    "tension = 1e-4\nH_pole = 2e-2\ndistance = 1e-4\n"));
  }
}

TEST(Flow, to_rest_agrees_with_newton_and_has_the_history_of_the_3D_solver) {
  const CompareSummary summary =
      compared("flow",
               "[compare]\nmodel = 'SBEH'\nreduced_volume = 0.8\nL = 0.05\n"
               "methods = ['newton', 'flow', 'surface3d']\n[surface3d]\ntriangles = 80\nend = 1\n"
               "[tolerance]\nenergy = 1e-8\npressure = 1e-5\norder_min = 1e-5\ndistance = 1e-5\n"
               "[tolerance_3d]\nenergy = 1e-4\nhistory = 1e-2\n");
  expect_agreement(summary);
  ASSERT_EQ(summary.states[1].history.size(), summary.states[2].history.size());
  EXPECT_EQ(summary.states[1].history.front().time, 1e-3);
  EXPECT_EQ(summary.comparisons.back().quantity, "history");
  EXPECT_GT(summary.comparisons.back().judged(), 0);
}

// About twice the errors of 320 triangles.
TEST(States, agree_with_the_axisymmetric_ones_and_say_what_they_are) {
  const std::string with =
      "methods = ['newton', 'states']\n[surface3d]\ntriangles = 320\n"
      "[tolerance_3d]\nenergy = 5e-6\npressure = 1e-4\ntension = 1e-4\n"
      "order_min = 5e-4\nH_pole = 2e-3\ndistance = 1e-4\n";
  for (const auto& [model, branch, volume, falls] :
       {std::tuple{"SBEH", "oblate", "0.8", "a saddle, whose energy falls in 2 directions"},
        {"SSH", "prolate", "0.8", "a minimum"}}) {
    const CompareSummary summary = compared(
        std::string("states_") + branch,
        fmt::format("[compare]\nmodel = '{}'\nbranch = '{}'\nreduced_volume = {}\nL = 0.05\n{}",
                    model, branch, volume, with));
    expect_agreement(summary);
    EXPECT_TRUE(summary.states[1].remark.ends_with(falls)) << summary.states[1].remark;
  }
}

TEST(Surface, revolved_from_the_ordered_profile_stays_there) {
  expect_agreement(
      compared("revolved",
               "[compare]\nmodel = 'SBEH'\nreduced_volume = 0.8\nL = 0.05\n"
               "methods = ['surface3d', 'minimiser']\n[surface3d]\ntriangles = 80\n"
               "start = 'revolved'\nend = 2\n[tolerance_3d]\nenergy = 1e-4\norder_mean = 1e-4\n"
               "order_min = 1e-2\npressure = 1e-2\ndistance = 1e-3\n"));
}

// Every method that there is for a shape. 320 triangles leave 3e-6 of the energy (studies/docs/comparisons.md), 48
// elements 2e-6 of the order at a pole. From Newton's state, since the way from an ellipsoid takes minutes.
TEST(AllMethods, agree_with_320_triangles) {
  struct Shape {
    const char *model, *branch, *methods;
  };
  const char *classical = "'newton', 'shooting', 'minimiser', 'flow', 'surface3d', 'harmonics'",
             *ordered = "'newton', 'minimiser', 'flow', 'surface3d'";
  for (const Shape& shape : {Shape{"SSH", "oblate", classical},
                             {"SSH", "prolate", classical},
                             {"SBEH", "oblate", ordered},
                             {"SBEH", "prolate", ordered}}) {
    SCOPED_TRACE(std::string(shape.model) + " " + shape.branch);
    expect_agreement(compared(
        std::string("all_") + shape.model + shape.branch,
        std::string("[compare]\nreduced_volume = 0.8\nL = 0.05\nmodel = '") + shape.model
            + "'\nbranch = '" + shape.branch + "'\nmethods = [" + shape.methods
            + "]\n[surface3d]\ntriangles = 320\nstart = 'revolved'\nend = 1\n"
              "[tolerance]\nenergy = 2e-9\npressure = 1e-5\ntension = 1e-5\norder_min = 1e-5\n"
              "H_pole = 1e-4\ndistance = 1e-5\n[tolerance_3d]\nenergy = 1e-5\npressure = 1e-4\n"
              "tension = 1e-4\norder_min = 1e-4\nH_pole = 5e-3\ndistance = 1e-4\n"));
  }
}

TEST(Comparison, beyond_the_fold_says_which_method_has_no_state) {
  const CompareSummary summary =
      compared("fold",
               "[compare]\nmodel = 'SBEH'\nreduced_volume = 0.6\nL = 0.08\n"
               "methods = ['newton', 'minimiser']\n[tolerance]\nenergy = 1\n");
  EXPECT_FALSE(summary.agrees());
  EXPECT_TRUE(summary.comparisons.empty());
  const std::vector<std::string> sentences = complaints(summary);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_TRUE(
      sentences[0].starts_with("newton has no state: the smooth oblate branch ends in a fold"))
      << sentences[0];
  EXPECT_TRUE(sentences[1].starts_with("minimiser has no state: ")) << sentences[1];
}

}  // namespace
}  // namespace sbeh::studies
