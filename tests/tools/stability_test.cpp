// A study of stability as its user sees it: rows, resumption, interruption, refusals, report.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

#include <csignal>
#include <fstream>

namespace sbeh::tools::test {
namespace {

using Stability = Workplace;

// A few steps of each run: too short for a rate.
const std::string brief =
    "[stability]\nreduced_volume = [0.7, 0.8]\nL = 0.05\nmodels = [\"SBEH\"]\n"
    "[surface3d]\ntriangles = 80\nend = 0.001\n[numerics]\nelements = 16\n";

TEST_F(Stability, leaves_a_row_and_a_history_for_every_run_in_the_order_of_the_keys) {
  write("in.toml", brief);
  must(into("out", "stability"));
  const Table rows = table("out/stability.csv");
  ASSERT_EQ(rows.rows.size(), 4u);
  for (std::size_t row = 0; row < 4; ++row) {
    EXPECT_EQ(rows.text(row, "reduced_volume"), row < 2 ? "0.7" : "0.8");
    EXPECT_EQ(rows.text(row, "m"), row % 2 == 0 ? "2" : "3");
    EXPECT_EQ(rows.text(row, "stop_reason"), "end time reached");
    const std::string m = rows.text(row, "m");
    const Table history = table(fmt::format("out/runs/SBEH_oblate_v{}_L0.05_Y{}{}.csv",
                                            rows.text(row, "reduced_volume"), m, m));
    EXPECT_EQ(int(history.rows.size()), int(rows.number(row, "steps")) + 1);
    EXPECT_EQ(history.numbers("amplitude").back(), rows.number(row, "amplitude_end"));
    EXPECT_EQ(history.numbers("energy").back(), rows.number(row, "energy_end"));
    EXPECT_NEAR(history.numbers("time").back(), 0.001 / 0.1, 1e-12);  // in units of 1/κ
  }
}

TEST_F(Stability, that_is_finished_computes_nothing_when_it_is_run_again) {
  write("in.toml", brief);
  must(into("out", "stability"));
  const Contents before = contents("out");
  const Ended again = sbeh(into("out", "stability"));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(again.out.find(" 0 computed"), std::string::npos) << again.out;
  EXPECT_EQ(contents("out"), before);
}

TEST_F(Stability, that_was_cut_short_goes_on_to_the_same_rows) {
  write("in.toml", brief);
  must(into("whole", "stability"));
  must(into("out", "stability"));
  // As if it had been killed while the third row was written, and one history had gone.
  const std::string text = read("out/stability.csv");
  std::size_t end = 0;
  for (int line = 0; line < 3; ++line) end = text.find('\n', end) + 1;
  write("out/stability.csv", text.substr(0, end + 9));
  std::filesystem::remove(path("out/runs/SBEH_oblate_v0.7_L0.05_Y22.csv"));
  const Ended ended = sbeh(into("out", "stability"));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find(" 3 computed"), std::string::npos) << ended.out;
  EXPECT_EQ(table("out/stability.csv").without("wall_seconds"),
            table("whole/stability.csv").without("wall_seconds"));
  Contents out = contents("out"), whole = contents("whole");
  out.erase("stability.csv"), whole.erase("stability.csv");
  EXPECT_TRUE(out == whole);
}

TEST_F(Stability, records_what_cannot_be_run_with_its_reason_and_goes_on) {
  write("in.toml",
        "[stability]\nreduced_volume = [0.6, 0.8]\nL = 0.09\nmodels = [\"SBEH\"]\n"
        "perturbations = [[2, 2, 0.01], [8, 8, 0.3]]\n[surface3d]\ntriangles = 80\nend = 0.001\n");
  must(into("out", "stability"));
  const Table rows = table("out/stability.csv");
  ASSERT_EQ(rows.rows.size(), 4u);
  const auto expect_failed = [&](std::size_t row, const std::string& reason) {
    EXPECT_EQ(rows.text(row, "witness"), "failed");
    EXPECT_NE(rows.text(row, "stop_reason").find(reason), std::string::npos)
        << rows.text(row, "stop_reason");
  };
  expect_failed(0, "ends in a fold");
  expect_failed(1, "ends in a fold");
  EXPECT_EQ(rows.text(0, "verdict"), "failed");
  EXPECT_EQ(rows.text(2, "witness"), "undecided");
  EXPECT_EQ(rows.text(2, "stop_reason"), "end time reached");
  expect_failed(3, "the perturbation is too large: ");
  // The modes need no run.
  EXPECT_EQ(rows.text(2, "verdict"), "leaves");
  EXPECT_EQ(rows.text(3, "verdict"), "stays");
}

TEST_F(Stability, that_is_interrupted_keeps_its_rows_and_says_how_to_go_on) {
  write("in.toml",
        "[stability]\nreduced_volume = [0.7, 0.8]\nL = [0.0001, 0.05]\nmodels = [\"SBEH\"]\n"
        "[surface3d]\ntriangles = 80\nend = 0.001\nlargest_step = 0.0005\n");
  Program program(here(), {"stability", "in.toml", "-o", "out", "--no-pictures", "--threads", "1"});
  ASSERT_TRUE(wait_until([&] { return lines("out/stability.csv") > 1 || !program.is_running(); }));
  ASSERT_TRUE(program.is_running());
  program.send(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_TRUE(ended.err.ends_with("sbeh: interrupted; the same command goes on from here\n"))
      << ended.err;
  EXPECT_GE(lines("out/stability.csv"), 2);
  EXPECT_LT(lines("out/stability.csv"), 9);
}

TEST_F(Stability, refuses_a_folder_that_holds_something_else) {
  write("in.toml", brief);
  must(into("out", "stability"));
  write("in.toml", brief + "grading = 0.2\n");
  must_refuse(into("out", "stability"),
              "out: holds a study of stability with other parameters: numerics.grading: ");
  write("scan.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\nmodels = [\"SSH\"]\n");
  must(into("scan", "scan", "scan.toml"));
  must_refuse(into("scan", "stability"),
              "scan: holds other results than a study of stability (see its run.toml)");
  std::ofstream(path("out/stability.csv"), std::ios::app) << "SBEH,0.9,oops\n";
  write("in.toml", brief);
  must_refuse(into("out", "stability"), "out/stability.csv:6: is damaged; delete that line");
}

TEST_F(Stability, has_a_report_and_a_check) {
  write("in.toml", brief);
  const Ended check = sbeh({"check", "in.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_TRUE(check.out.starts_with("in.toml: 4 runs of perturbed states with about 80 triangles"))
      << check.out;
  must(into("out", "stability"));
  must({"report", "out", "--no-pictures"});
  const std::string page = read("out/report.html");
  for (const char* text : {"<h1>Stability in 3D: SBEH oblate</h1>", "runs: undecided",
                           "sbeh stability out/run.toml -o NEW_FOLDER", "Not drawn: stability."})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace sbeh::tools::test
