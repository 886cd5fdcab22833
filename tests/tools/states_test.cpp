// Rest states in 3D as their user sees them: table, files, what goes on, refusals.
#include "model/material.h"
#include "tests/tools/workplace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace sbeh::tools::test {
namespace {

class States : public Workplace {
 protected:
  // What in.toml asks for, its table cut off after the first state, is completed to the same files.
  void expect_completed_from_the_first() {
    must({"states", "in.toml", "-o", "out", "--no-pictures"});
    const Contents whole = contents("out");
    const std::string text = read("out/states.csv");
    write("out/states.csv", text.substr(0, text.find("\n2,") + 1));
    must({"states", "in.toml", "-o", "out", "--no-pictures"});
    EXPECT_TRUE(contents("out") == whole);
  }
};

const std::string two_states =
    "[states]\nmodel = \"SSH\"\nreduced_volume = [0.8, 0.85]\nL = 0.05\neigenpairs = 3\n";

TEST_F(States,
       leave_a_row_a_frame_and_their_modes_and_say_in_how_many_directions_the_energy_falls) {
  write("in.toml", two_states);
  const Ended ended = sbeh({"states", "in.toml", "-o", "out", "--no-pictures"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("2 states in out/states.csv; 2 computed in "), std::string::npos)
      << ended.out;
  const Table states = table("out/states.csv");
  ASSERT_EQ(states.rows.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    const std::string number = std::to_string(row + 1);
    EXPECT_EQ(states.text(row, "number"), number);
    EXPECT_EQ(states.text(row, "model"), "SSH");
    EXPECT_EQ(states.text(row, "branch"), "oblate");
    EXPECT_EQ(states.text(row, "status"), "stationary") << states.text(row, "stop_reason");
    EXPECT_EQ(states.text(row, "class"), "Dooh");
    EXPECT_EQ(states.text(row, "negative_directions"), "2");  // towards the prolate
    EXPECT_LT(states.number(row, "eigenvalue_2"), 0);
    EXPECT_GT(states.number(row, "eigenvalue_3"), 0);
    EXPECT_TRUE(exists(path("out/frames/state_000" + number + ".vtu")));
    EXPECT_TRUE(exists(path("out/modes/state_000" + number + "_mode_3.vtu")));
  }
  // As the axisymmetric solver has it, to what 320 triangles give.
  EXPECT_NEAR(states.number(0, "energy"), -10.17238, 1e-5);
  EXPECT_LT(states.number(0, "energy_error"), 5e-4);
}

// cos 2φ and sin 2φ grow, by which it goes to the prolate.
TEST_F(States, have_the_rates_of_the_axisymmetric_solver_where_they_are_asked_for) {
  write("in.toml",
        "[states]\nreduced_volume = 0.8\nL = 0.05\neigenpairs = 0\nrates = 4\n"
        "[material]\nviscosity = 0.5\n");
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  write("modes.toml",
        "[modes]\nbranch = \"oblate\"\nreduced_volume = 0.8\nL = 0.05\nlargest_m = 4\nnumber = 1\n"
        "[material]\nviscosity = 0.5\n");
  must({"modes", "modes.toml", "-o", "modes", "--no-pictures"});
  const Table states = table("out/states.csv"), modes = table("modes/modes.csv");
  std::vector<double> rates;
  for (std::size_t row = 0; row < modes.rows.size(); ++row)
    for (int copy = 0; copy < (modes.text(row, "m") == "0" ? 1 : 2); ++copy)
      rates.push_back(modes.number(row, "rate"));
  std::ranges::sort(rates, std::greater{});
  ASSERT_GT(rates.front(), 0);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string n = std::to_string(k + 1);
    EXPECT_NEAR(states.number(0, "rate_" + n) / rates[k], 1, 1e-3) << n;
    EXPECT_TRUE(exists(path("out/modes/state_0001_rate_" + n + ".vtu")));
  }
}

TEST_F(States, that_are_there_are_not_computed_again) {
  write("in.toml", two_states);
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  const Contents first = contents("out");
  std::string text = read("out/states.csv");
  write("out/states.csv", text.substr(0, text.rfind("\n2,") + 1));
  const Ended ended = sbeh({"states", "in.toml", "-o", "out", "--no-pictures"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("2 states in out/states.csv; 1 computed in "), std::string::npos)
      << ended.out;
  EXPECT_TRUE(contents("out") == first);
}

TEST_F(States, start_from_a_frame_too) {
  write("in.toml", two_states);
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  write("frame.toml",
        "[states]\nmodel = \"SSH\"\nframe = \"out/frames/state_0001.vtu\"\nreduced_volume = 0.81\n"
        "L = 0.05\neigenpairs = 2\n");
  must({"states", "frame.toml", "-o", "more", "--no-pictures"});
  const Table states = table("more/states.csv");
  ASSERT_EQ(states.rows.size(), 1u);
  // Without numbers of its own it is the state of the frame, once more, as far as Newton's method has gone: 1e-8.
  write("same.toml", "[states]\nframe = \"out/frames/state_0001.vtu\"\neigenpairs = 0\n");
  must({"states", "same.toml", "-o", "same", "--no-pictures"});
  const Table first = table("out/states.csv"), same = table("same/states.csv");
  EXPECT_EQ(same.text(0, "model"), "SSH");
  EXPECT_EQ(same.text(0, "L"), "0.05");
  for (const char* column : {"energy", "volume", "pressure", "tension"})
    EXPECT_NEAR(same.number(0, column), first.number(0, column), 1e-8) << column;
  EXPECT_EQ(states.text(0, "branch"), "frame");
  EXPECT_EQ(states.text(0, "status"), "stationary") << states.text(0, "stop_reason");
  EXPECT_NEAR(states.number(0, "volume"), 0.81 * 4 * M_PI / 3, 1e-8);
}

TEST_F(States, that_triangles_do_not_resolve_or_that_are_not_there_say_so) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nbranch = \"prolate\"\nreduced_volume = 0.5\nL = 0.05\n"
        "triangles = 80\neigenpairs = 1\n");
  EXPECT_EQ(sbeh({"states", "in.toml", "-o", "coarse", "--no-pictures"}).exit_code, 0);
  // These have two negative directions where there are none.
  EXPECT_EQ(table("coarse/states.csv").text(0, "status"), "unresolved");
  write("in.toml", "[states]\nreduced_volume = 0.6\nL = 0.2\ntriangles = 80\n");
  EXPECT_EQ(sbeh({"states", "in.toml", "-o", "none", "--no-pictures"}).exit_code, 0);
  const Table none = table("none/states.csv");
  EXPECT_EQ(none.text(0, "status"), "failed");
  EXPECT_TRUE(none.text(0, "stop_reason").starts_with("there is no axisymmetric state"))
      << none.text(0, "stop_reason");
}

// An independent spectral calculation has F/8πκ = 1.5996134933 for the triaxial saddle; F as in a classical diagram,
// without Gauss's energy, κ = 4 L at full order.
TEST_F(States, without_an_axis_are_found_from_a_perturbed_one) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.74\nL = 0.05\n"
        "perturbation = [[2, 2, 0.15]]\neigenpairs = 2\n");
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  const Table states = table("out/states.csv");
  EXPECT_EQ(states.text(0, "status"), "stationary");
  EXPECT_EQ(states.text(0, "class"), "D2h");
  EXPECT_EQ(states.text(0, "negative_directions"), "1");
  EXPECT_EQ(states.text(0, "rigid_motions"), "6");
  const model::Material material = model::Material{}.with_L(0.05);
  const double kappa = material.kappa(model::full_order),
               gauss = 4 * M_PI * material.kappa_gauss(model::full_order);
  const double reduced = (states.number(0, "energy_bending") - gauss) / (8 * M_PI * kappa);
  EXPECT_NEAR(reduced, 1.5996134933, 1e-5);
  const double error = std::abs(reduced - 1.5996134933) * 8 * M_PI * kappa;
  EXPECT_LT(error, states.number(0, "energy_error"));
  EXPECT_LT(states.number(0, "energy_error"), 1e-3);
}

// The oblate of SSH loses its stability to m = 2 at V_r = 0.74973; what leaves it there are saddles towards smaller V_r.
// Around the oblate of SSH at V_r = 0.74 lie the triaxial saddle, which keeps it from the prolate, and that.
TEST_F(States, that_no_branch_leads_to_are_looked_for) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.74\nL = 0.05\ntriangles = 80\n"
        "eigenpairs = 0\n[search]\nmost_states = 3\n");
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  const Table states = table("out/states.csv");
  ASSERT_EQ(states.rows.size(), 3u);
  for (std::size_t row = 0; row < 3; ++row) {
    EXPECT_EQ(states.text(row, "class"), row == 1 ? "D2h" : "Dooh");
    EXPECT_EQ(states.text(row, "negative_directions"), row == 1 ? "1" : "0");
    EXPECT_EQ(states.text(row, "from"), row == 0 ? "" : std::to_string(row));
  }
  // As the axisymmetric solver has the prolate, to what 80 triangles give.
  EXPECT_NEAR(states.number(2, "energy"), -9.98444, 1e-3);
  EXPECT_LT(states.number(0, "energy"), states.number(1, "energy"));
}

TEST_F(States, that_are_looked_for_are_completed_after_an_interrupt_as_if_there_had_been_none) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.74\nL = 0.05\ntriangles = 80\n"
        "eigenpairs = 0\n[search]\nmost_states = 2\n");
  expect_completed_from_the_first();
}

TEST_F(States, on_a_branch_are_followed_with_what_leaves_it) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.755\nL = 0.05\neigenpairs = 2\n"
        "[follow]\nto = 0.742\nlongest_step = 0.5\n");
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  const Table states = table("out/states.csv");
  std::string branching;
  bool left = false;
  for (std::size_t row = 0; row < states.rows.size(); ++row) {
    const bool first_path = states.text(row, "path") == "1";
    const double V = states.number(row, "reduced_volume");
    if (states.text(row, "point") == "branching") {
      branching = states.text(row, "number");
      EXPECT_NEAR(V, 0.74973, 1e-4);
      EXPECT_NEAR(states.number(row, "eigenvalue_1"), 0, 1e-4);
      continue;
    }
    EXPECT_EQ(states.text(row, "class"), first_path ? "Dooh" : "D2h");
    EXPECT_EQ(states.text(row, "negative_directions"), !first_path ? "1" : V > 0.7497 ? "2" : "0");
    if (first_path) continue;
    left = true;
    EXPECT_EQ(states.text(row, "from"), branching);
    EXPECT_LT(V, 0.7497);
  }
  EXPECT_TRUE(left);
  EXPECT_EQ(states.number(states.rows.size() - 1, "reduced_volume"), 0.742);
  EXPECT_EQ(states.text(states.rows.size() - 1, "point"), "last");
}

// The triangles of the triaxial saddles move with the surface: at V_r = 0.653 their angles are too small.
TEST_F(States, on_a_branch_get_new_triangles_where_theirs_do_not_resolve_it) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.74\nL = 0.05\neigenpairs = 0\n"
        "perturbation = [[2, 2, 0.15]]\n[follow]\nto = 0.66\nswitch = false\nlongest_step = 0.3\n");
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  const Table states = table("out/states.csv");
  int renewed = 0;
  for (std::size_t row = 0; row < states.rows.size(); ++row) {
    EXPECT_EQ(states.text(row, "status"), "stationary") << states.text(row, "stop_reason");
    EXPECT_EQ(states.text(row, "class"), "D2h");
    EXPECT_EQ(states.text(row, "negative_directions"), "1");
    if (states.text(row, "point") != "renewed") continue;
    ++renewed;
    EXPECT_EQ(states.text(row, "reduced_volume"), states.text(row - 1, "reduced_volume"));
    EXPECT_NEAR(states.number(row, "energy"), states.number(row - 1, "energy"), 1e-3);
  }
  EXPECT_GT(renewed, 0);
  EXPECT_EQ(states.number(states.rows.size() - 1, "reduced_volume"), 0.66);
}

TEST_F(States, on_a_branch_in_a_number_of_the_material_have_its_value) {
  write("in.toml",
        "[states]\nreduced_volume = 0.8\nL = 0.05\ntriangles = 80\neigenpairs = 0\n"
        "[follow]\nparameter = \"H0\"\nto = -0.2\nlongest_step = 0.6\n[numerics]\nelements = 24\n"
        "[material]\nspontaneous_curvature = -0.1\n");
  must({"states", "in.toml", "-o", "out", "--no-pictures"});
  const Table states = table("out/states.csv");
  ASSERT_GT(states.rows.size(), 2u);
  const std::size_t last = states.rows.size() - 1;
  EXPECT_EQ(states.text(0, "H0"), "-0.1");
  EXPECT_EQ(states.number(last, "H0"), -0.2);
  EXPECT_EQ(states.text(last, "point"), "last");
  // With the material of its row, which the frame holds, it is the same state once more, as far as 80 triangles tell (3e-5): H0 of
  // the start would make a tenth.
  write("same.toml", "[states]\nframe = \"out/frames/state_000" + std::to_string(last + 1)
                         + ".vtu\"\neigenpairs = 0\n");
  must({"states", "same.toml", "-o", "same", "--no-pictures"});
  EXPECT_NEAR(table("same/states.csv").number(0, "energy"), states.number(last, "energy"), 1e-5);
}

TEST_F(States, on_a_branch_that_was_cut_short_are_completed_as_if_it_had_not_been) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.85\nL = 0.05\ntriangles = 80\n"
        "eigenpairs = 1\n[follow]\nto = 0.8\nlongest_step = 0.5\n[numerics]\nelements = 24\n");
  expect_completed_from_the_first();
}

}  // namespace
}  // namespace sbeh::tools::test
