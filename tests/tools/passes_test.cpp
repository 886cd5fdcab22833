// Passes between rest states in 3D: to which states they lead, and what is left of that in the folder.
#include "tests/tools/workplace.h"

#include <cmath>

namespace sbeh::tools::test {
namespace {

const std::string near_oblate =
    "reduced_volume = 0.74\nL = 0.05\nperturbation = [[2, 2, 0.15]]\ntriangles = 180\n";

class Passes : public Workplace {
 protected:
  // From the state without an axis that is near the perturbed oblate of V_r = 0.74, or from another one.
  void find_passes(const std::string& model, const std::string& start = near_oblate) const {
    write("in.toml",
          "[states]\nmodel = \"" + model + "\"\n" + start + "eigenpairs = 0\npasses = true\n");
    must(into("out", "states"));
  }

  // A start: the last state of their branch, on 320 triangles; 180 tell an oblate near its branching point from D2h no more.
  std::string far_from_the_oblate(const std::string& model, const std::string& volume) const {
    write("branch.toml",
          "[states]\nmodel = \"" + model
              + "\"\nreduced_volume = 0.74\nL = 0.05\nperturbation = [[2, 2, 0.15]]\neigenpairs = 0\n"
                "[follow]\nto = "
              + volume + "\nswitch = false\nlongest_step = 0.4\n");
    must(into("branch", "states", "branch.toml"));
    const std::size_t last = table("branch/states.csv").rows.size();
    EXPECT_LT(last, 10u);
    return "frame = \"branch/frames/state_000" + std::to_string(last) + ".vtu\"\n";
  }

  // Rows of the axisymmetric solver, in the order of the branches.
  Table axisymmetric(const std::string& model, const std::string& volume,
                     const std::string& branches, const std::string& material = "") const {
    write("scan.toml", "[scan]\nreduced_volume = " + volume + "\nL = 0.05\nmodels = [\"" + model
                           + "\"]\nbranches = " + branches + "\nmethod = \"newton\"\n" + material);
    must(into("scan", "scan", "scan.toml"));
    return table("scan/scan.csv");
  }

  // The one pass leads to the oblate and to the prolate of the axisymmetric solver, each as exact as its row says.
  void expect_oblate_and_prolate(const std::string& model, const std::string& volume) const {
    const Table passes = table("out/passes.csv"), states = table("out/states.csv"),
                known = axisymmetric(model, volume, "[\"oblate\", \"prolate\"]");
    ASSERT_EQ(passes.rows.size(), 1u);
    ASSERT_EQ(states.rows.size(), 3u);
    EXPECT_EQ(states.text(0, "negative_directions"), "1");
    EXPECT_EQ(states.text(0, "point"), "first");
    EXPECT_EQ(passes.text(0, "pass"), "1");
    EXPECT_EQ(passes.text(0, "kind"), "two states");
    bool oblate = false, prolate = false;
    for (const std::string side : {"1", "2"}) {
      EXPECT_EQ(passes.text(0, "stop_reason_" + side), "at rest");
      const auto end = std::size_t(passes.number(0, "end_" + side)) - 1;
      EXPECT_EQ(states.text(end, "point"), "end");
      EXPECT_EQ(states.text(end, "from"), "1");
      EXPECT_EQ(states.text(end, "status"), "stationary") << states.text(end, "stop_reason");
      EXPECT_EQ(states.text(end, "negative_directions"), "0");
      EXPECT_EQ(states.text(end, "class"), "Dooh");
      EXPECT_EQ(passes.text(0, "class_" + side), "Dooh");
      const double energy = states.number(end, "energy");
      EXPECT_EQ(passes.number(0, "energy_end_" + side), energy);
      EXPECT_NEAR(passes.number(0, "barrier_" + side), states.number(0, "energy") - energy, 1e-12);
      EXPECT_GT(passes.number(0, "barrier_" + side), 0);
      const bool is_flat = states.number(end, "length_3") < 1.01 * states.number(end, "length_2");
      (is_flat ? oblate : prolate) = true;
      const std::size_t row = known.text(0, "branch") == (is_flat ? "oblate" : "prolate") ? 0 : 1;
      // An estimate on triangles that a flow has moved: seen to be half of the error.
      EXPECT_NEAR(energy, known.number(row, "energy"), 4 * states.number(end, "energy_error"));
      EXPECT_LT(states.number(end, "energy_error"), 2e-3);
    }
    EXPECT_TRUE(oblate && prolate);
  }
};

TEST_F(Passes, of_a_classical_membrane_lead_to_the_oblate_and_to_the_prolate) {
  find_passes("SSH", far_from_the_oblate("SSH", "0.7"));
  expect_oblate_and_prolate("SSH", "0.7");
}

// A quarter of the triangles of this saddle have none; half of them have one next to it.
TEST_F(Passes, of_an_ordered_membrane_lead_to_the_oblate_and_to_the_prolate) {
  find_passes("SBEH", far_from_the_oblate("SBEH", "0.69"));
  expect_oblate_and_prolate("SBEH", "0.69");
}

// Between two pears, one of which is the other upside down: with so stiff an area difference they leave the prolate gently. Their
// energy is that of the axisymmetric solver.
TEST_F(Passes, of_a_prolate_lead_to_one_pear_both_ways) {
  const std::string material = "[material]\narea_difference = { stiffness = 10, W2 = -28.6 }\n";
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nbranch = \"prolate\"\nreduced_volume = 0.8\nL = 0.05\n"
        "eigenpairs = 0\npasses = true\n"
            + material);
  must(into("out", "states"));
  const Table passes = table("out/passes.csv"), states = table("out/states.csv"),
              known = axisymmetric("SSH", "0.8", "[\"prolate\", \"pear\"]", material);
  ASSERT_EQ(passes.rows.size(), 1u);
  ASSERT_EQ(states.rows.size(), 2u);
  EXPECT_EQ(passes.text(0, "kind"), "one state");
  EXPECT_EQ(passes.text(0, "remark"), "a symmetry of the pass turns the one way into the other");
  for (const std::string side : {"1", "2"}) {
    EXPECT_EQ(passes.text(0, "end_" + side), "2");
    EXPECT_EQ(passes.text(0, "class_" + side), "Coov");
  }
  EXPECT_EQ(states.text(1, "negative_directions"), "0");
  ASSERT_EQ(known.rows.size(), 2u);
  for (const std::size_t row : {0u, 1u}) {
    EXPECT_EQ(known.text(row, "branch"), row == 0 ? "prolate" : "pear");
    EXPECT_EQ(known.text(row, "status"), "stationary");
    EXPECT_NEAR(states.number(row, "energy"), known.number(row, "energy"),
                states.number(row, "energy_error"));
    EXPECT_LT(states.number(row, "energy_error"), 1e-4);
  }
}

// As after kill -9 once the second end had its row, and the pass only its first end.
TEST_F(Passes, that_were_cut_short_are_completed_as_if_they_had_not_been) {
  find_passes("SSH");
  const Contents whole = contents("out");
  const std::string passes = read("out/passes.csv"), states = read("out/states.csv");
  const std::string header = passes.substr(0, passes.find('\n') + 1);
  write("out/passes.csv", header);  // the ends are there
  must(into("out", "states"));
  EXPECT_TRUE(contents("out") == whole);
  // Neither the ends nor the pass; its own row alone was there.
  write("out/passes.csv", header);
  write("out/states.csv", states.substr(0, states.find("\n2,") + 1));
  must(into("out", "states"));
  EXPECT_TRUE(contents("out") == whole);
}

TEST_F(Passes, are_not_gone_down_again) {
  find_passes("SSH");
  const Contents whole = contents("out");
  const Ended again = sbeh(into("out", "states"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find("3 states in out/states.csv; 0 computed in "), std::string::npos)
      << again.out;
  EXPECT_NE(again.out.find("two states"), std::string::npos) << again.out;
  EXPECT_TRUE(contents("out") == whole);
}

}  // namespace
}  // namespace sbeh::tools::test
