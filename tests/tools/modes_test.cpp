// Modes of a state as their user sees them: tables, files, starts of runs, refusals, report.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

#include <csignal>
#include <limits>

namespace sbeh::tools::test {
namespace {

using Modes = Workplace;

const std::vector<std::string> classical{"modes", "--model",      "SSH",  "--reduced-volume",
                                         "0.8",   "--L",          "0.05", "-o",
                                         "out",   "--no-pictures"};
std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(Modes, leave_a_row_and_two_files_for_each_of_them_and_say_what_is_stable) {
  const Ended ended = sbeh(with(classical, {"--largest-m", "3", "--number", "2"}));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  for (const char* text :
       {"SSH oblate, V_r = 0.8, L = 0.05\n",
        "unstable: the energy falls in 2 directions, of m = 2\n",
        "rigid motions, whose eigenvalue is 0, have ", "16 modes in out/modes.csv\n"})
    EXPECT_NE(ended.out.find(text), std::string::npos) << ended.out;
  const Table modes = table("out/modes.csv");
  EXPECT_EQ(modes.columns, (std::vector<std::string>{"m", "parity", "number", "eigenvalue", "rate",
                                                     "eigenvalue_error", "rate_error"}));
  ASSERT_EQ(modes.rows.size(), 16u);
  for (std::size_t row = 0; row < modes.rows.size(); ++row) {
    const std::string stem = "out/modes/m" + modes.text(row, "m") + "_" + modes.text(row, "parity")
                           + "_" + modes.text(row, "number");
    EXPECT_EQ(table(stem + ".csv").rows.size(), 3u * 96 + 1) << stem;  // doubled for the rates
    EXPECT_TRUE(exists(path(stem + ".vtu"))) << stem;
  }
  EXPECT_FALSE(exists(path("out/contour.csv")));
}

TEST_F(Modes, are_the_same_by_an_input_by_its_description_and_again) {
  must(classical);
  const Contents first = contents("out");
  must(classical);
  EXPECT_TRUE(contents("out") == first);
  must(into("described", "modes", "out/run.toml"));
  EXPECT_TRUE(contents("described") == first);
}

TEST_F(Modes, of_a_stable_state_fluctuate) {
  const std::vector<std::string> stable{
      "modes", "--model", "SSH",           "--reduced-volume", "0.7", "--L", "0.05",
      "-o",    "out",     "--no-pictures", "--fluctuations",   "1e-5"};
  const Ended ended = sbeh(stable);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("stable: a minimum, as modes up to m = 5 say\n"), std::string::npos)
      << ended.out;
  const Table modes = table("out/fluctuations.csv"), contour = table("out/contour.csv");
  for (std::size_t row = 0; row < modes.rows.size(); ++row)
    EXPECT_DOUBLE_EQ(modes.number(row, "mean_square") * modes.number(row, "eigenvalue"), 1e-5);
  EXPECT_EQ(contour.rows.size(), 21u);
  EXPECT_DOUBLE_EQ(contour.number(2, "mean_square"), 2 * contour.number(2, "spectrum"));
}

// Where λ of m = 2 is nearer to 0 than the error.
TEST_F(Modes, are_unresolved_where_a_sign_is_not_known) {
  const auto modes_at = [&](double reduced_volume, const std::string& folder) {
    return sbeh({"modes", "--model", "SSH", "--reduced-volume", fmt::format("{}", reduced_volume),
                 "--L", "0.05", "--largest-m", "2", "-o", folder, "--no-pictures"});
  };
  const auto eigenvalue_at = [&](double reduced_volume, const std::string& folder) {
    EXPECT_EQ(modes_at(reduced_volume, folder).exit_code, 0);
    const Table modes = table(folder + "/modes.csv");
    for (std::size_t row = 0; row < modes.rows.size(); ++row)
      if (modes.text(row, "m") == "2") return modes.number(row, "eigenvalue");
    return std::numeric_limits<double>::quiet_NaN();
  };
  const double a = 0.749728, b = 0.749730, at_a = eigenvalue_at(a, "a"),
               at_b = eigenvalue_at(b, "b");
  ASSERT_LT(at_a * at_b, 0);
  const Ended ended = modes_at((at_b * a - at_a * b) / (at_b - at_a), "out");
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("\nunresolved: an eigenvalue is no farther from 0 than its error"),
            std::string::npos)
      << ended.out;
}

TEST_F(Modes, are_starts_of_runs_which_bring_their_model_and_material) {
  must(classical);
  write("in.toml",
        "[surface]\nshape = \"mode\"\nfile = \"out/modes/m2_even_1.vtu\"\namplitude = 0.02\n"
        "triangles = 80\n[time]\nend = 0.01\nframes = [0]\n");
  must(into("run", "run"));
  const std::string description = read("run/run.toml");
  for (const char* line : {"model = \"SSH\"", "L1 = 0.05", "amplitude = 0.02", "triangles = 80"})
    EXPECT_NE(description.find(line), std::string::npos) << description;
  write("in.toml", read("in.toml") + "[material]\nL = 0.08\n");
  const Ended changed = sbeh(into("changed", "run"));
  EXPECT_EQ(changed.exit_code, 0) << changed.err;
  EXPECT_NE(changed.err.find("m2_even_1.vtu: material.L1: 0.05 there, 0.08 here; the energy of "),
            std::string::npos)
      << changed.err;
}

TEST_F(Modes, are_no_starts_where_the_amplitude_is_too_large_or_the_file_is_none) {
  must({"modes", "--reduced-volume", "0.7", "--L", "0.05", "--largest-m", "2", "-o", "out",
        "--no-pictures"});
  const auto start = [](const std::string& file, const std::string& amplitude) {
    return "[surface]\nshape = \"mode\"\nfile = \"" + file + "\"\namplitude = " + amplitude
         + "\ntriangles = 80\n[time]\nend = 0.01\n";
  };
  write("in.toml", start("out/modes/m2_even_1.vtu", "2"));
  must_refuse(into("run", "run"), "in.toml: [surface] amplitude = 2: is too large: ");
  write("in.toml", start("out/modes/m9_even_1.vtu", "0.1"));
  must_refuse(into("run", "run"), "out/modes/m9_even_1.vtu: is not there: ");
  must({"mesh", "sphere", "--triangles", "80", "-o", "sphere.vtu"});
  write("in.toml", start("sphere.vtu", "0.1"));
  must_refuse(into("run", "run"), "sphere.vtu: is no mode of sbeh modes: it lacks the field mode");
}

TEST_F(Modes, are_refused_for_states_that_are_not_there) {
  must_refuse({"modes", "-o", "out"},
              "modes: of which state? Give FILE, or --reduced-volume and --L");
  must_refuse({"modes", "--scan", "none", "--reduced-volume", "0.8", "--L", "0.05"}, "none: ");
  must_refuse({"modes", "--reduced-volume", "1", "--L", "0.05"},
              "--reduced-volume 1: must be < 1: a sphere may have any tension");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"--branch", "bud"},
                                             {"--model", "Helfrich-local"},
                                             {"--largest-m", "51"},
                                             {"--largest-m", "-1"},
                                             {"--number", "0"},
                                             {"--fluctuations", "-1"},
                                             {"--reduced-volume", "1.1"},
                                             {"--L", "0"}})
    EXPECT_EQ(sbeh(with({"modes"}, words)).exit_code, 2) << words.front();
  const Ended fold = sbeh({"modes", "--reduced-volume", "0.6", "--L", "0.09", "-o", "out"});
  EXPECT_EQ(fold.exit_code, 1);
  EXPECT_NE(
      fold.err.find("SBEH oblate, V_r = 0.6, L = 0.09: there is no state whose modes could be "
                    "told: the smooth oblate branch ends in a fold"),
      std::string::npos)
      << fold.err;
}

TEST_F(Modes, of_a_scan_are_those_of_a_row_at_rest_alone) {
  write("in.toml",
        "[scan]\nreduced_volume = 0.6\nL = [0.06, 0.09]\nmodels = [\"SBEH\"]\nmodes = 0\n");
  must(into("scan", "scan"));
  const std::vector<std::string> row{
      "modes", "--scan", "scan", "--reduced-volume", "0.6", "-o", "out", "--no-pictures", "--L"};
  must(with(row, {"0.06"}));
  must_refuse(with(row, {"0.07"}), "scan/scan.csv: has no row SBEH oblate, V_r = 0.6, L = 0.07");
  must_refuse(
      with(row, {"0.09"}),
      "scan/scan.csv: its row SBEH oblate, V_r = 0.6, L = 0.09 is unresolved, not stationary");
  must_refuse(with(row, {"0.06", "--number", "2"}),
              "out: holds modes with other parameters: modes.number: 1 there, 2 here");
  must_refuse({"modes", "in.toml"}, "in.toml: is an input: for sbeh scan in.toml");
}

TEST_F(Modes, that_are_interrupted_begin_again) {
  Program program(here(), {"modes", "--reduced-volume", "0.7", "--L", "0.05", "--largest-m", "50",
                           "--number", "20", "-o", "out"});
  ASSERT_TRUE(wait_until([&] { return exists(path("out/run.toml")) || !program.is_running(); }));
  ASSERT_TRUE(program.is_running());
  program.send(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_TRUE(ended.err.ends_with("the same command begins again\n")) << ended.err;
  EXPECT_FALSE(exists(path("out/modes.csv")));
}

TEST_F(Modes, have_pictures_a_report_and_a_check) {
  std::vector<std::string> words = with(classical, {"--largest-m", "2", "--fluctuations", "1e-5"});
  std::erase(words, "--no-pictures");
  must(words);
  for (const char* picture : {"profiles.png", "profiles.svg", "surfaces.png", "contour.png"})
    EXPECT_TRUE(exists(path(std::string("out/") + picture))) << picture;
  must({"report", "out"});
  const std::string page = read("out/report.html");
  for (const char* text : {"<h1>Modes of the SSH oblate</h1>", "negative eigenvalues",
                           "sbeh modes out/run.toml -o NEW_FOLDER"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  EXPECT_EQ(page.find("Not drawn"), std::string::npos);
  const Ended check = sbeh({"check", "out/run.toml"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_TRUE(check.out.starts_with("out/run.toml: about 6 modes of one state")) << check.out;
}

}  // namespace
}  // namespace sbeh::tools::test
