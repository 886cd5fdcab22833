// The command line itself: help, version, what is refused; and the run without a display.
#include "tests/tools/workplace.h"

#include <algorithm>

namespace sbeh::tools::test {
namespace {

using CommandLine = Workplace;

const std::string small = "[scan]\nreduced_volume = 0.8\nL = 0.05\n[numerics]\nelements = 16\n";

TEST_F(CommandLine, explains_itself) {
  const Ended help = sbeh({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command : {"scan", "relax", "check", "picture"})
    EXPECT_NE(help.out.find(command), std::string::npos) << command;
  EXPECT_NE(help.out.find("Usage: sbeh "), std::string::npos) << help.out;
  for (const char* command : {"scan", "relax", "check"}) {
    const Ended ended = sbeh({command, "--help"});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_NE(ended.out.find("FILE"), std::string::npos);
    EXPECT_EQ(ended.err, "");
  }
  EXPECT_EQ(sbeh({"--version"}).exit_code, 0);
}

TEST_F(CommandLine, that_is_wrong_is_refused_with_exit_2_and_without_a_trace) {
  write("in.toml", small);
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"scna"},
                                                    {"--foo"},
                                                    {"scan"},
                                                    {"scan", "in.toml", "--foo"},
                                                    {"scan", "in.toml", "in.toml"},
                                                    {"scan", "in.toml", "-o"},
                                                    {"scan", "in.toml", "--threads", "0"},
                                                    {"scan", "in.toml", "--threads", "two"},
                                                    {"check", "in.toml", "-o", "out"},
                                                    {"scan", ""},
                                                    {"scan", "in.toml", "-o", ""},
                                                    {"picture"},
                                                    {"picture", "scan"},
                                                    {"picture", "scan", "out", "--only", "x"},
                                                    {"picture", "scan", "out", "--size", "7"},
                                                    {"picture", "mesh", "in.toml"}};
  for (const auto& arguments : wrong) {
    const Ended ended = sbeh(arguments);
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_TRUE(ended.err.starts_with("sbeh: ")) << ended.err;
    EXPECT_LT(ended.err.size(), 200u) << ended.err;
  }
  EXPECT_EQ(contents("").size(), 1u);
  must_refuse({"scna", "in.toml"}, "scna: unknown command; did you mean scan?");
  must_refuse({"--foo"}, "--foo: unknown option");
  must_refuse({"--verison"}, "--verison: unknown option; did you mean --version?");
  must_refuse({"scan", "in.toml", "--no-picture"},
              "--no-picture: unknown option; did you mean --no-pictures?");
  must_refuse({"run", "in.toml", "--resum"}, "--resum: unknown option; did you mean --resume?");
  must_refuse({"run", "--thread", "2", "in.toml"},
              "--thread: unknown option; did you mean --threads?");
  must_refuse({"mesh", "file", "a.obj", "--repiar", "--report"},
              "--repiar: unknown option; did you mean --repair?");
  must_refuse({"mesh", "sphere", "--triangle", "320"},
              "--triangle: unknown option; did you mean --triangles?");
  for (const char* kind : {"scan", "run", "figures", "mesh"}) {
    EXPECT_EQ(sbeh({"picture", kind, "out", "--fromat", "pdf"}).err,
              "sbeh: --fromat: unknown option; did you mean --format?\n");
    EXPECT_EQ(sbeh({"picture", kind, "out", "--witdh", "86mm"}).exit_code, 2);
  }
  must_refuse({"picture", "scna", "out"},
              "scna: unknown kind of results; did you mean scan? Known: scan, ");
}

TEST_F(CommandLine, without_a_folder_writes_into_results_under_the_name_of_the_input) {
  write("a b/my scan.v2.toml", small);
  must({"scan", "./a b/my scan.v2.toml", "--no-pictures"});
  EXPECT_EQ(table("results/my scan.v2/scan.csv").rows.size(), 2u);
}

TEST_F(CommandLine, without_a_display_completes_the_tables_and_says_how_to_draw_later) {
  write("in.toml", small);
  Surroundings bare = here();
  bare.environment = {"DISPLAY=", "PATH=/nonexistent"};
  const Ended ended = run(bare, {"scan", "in.toml", "-o", "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.err.find("sbeh: no pictures; the tables in out are complete. "
                           "Try again with: sbeh picture scan out\n"),
            std::string::npos)
      << ended.err;
  EXPECT_EQ(table("out/scan.csv").rows.size(), 2u);
}

TEST_F(CommandLine, whose_log_cannot_be_written_runs_to_its_end) {
  write("in.toml", small);
  Surroundings full = here();
  full.err = "/dev/full";
  EXPECT_EQ(run(full, into("out", "scan")).exit_code, 0);
  EXPECT_EQ(table("out/scan.csv").rows.size(), 2u);
  EXPECT_EQ(run(full, {"scan", "missing.toml"}).exit_code, 2);
}

TEST_F(CommandLine, whose_answer_cannot_be_written_says_so) {
  write("in.toml", small);
  Surroundings full = here();
  full.out = "/dev/full";
  const Ended ended = run(full, {"check", "in.toml"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_EQ(ended.err, "sbeh: standard output cannot be written\n");
}

}  // namespace
}  // namespace sbeh::tools::test
