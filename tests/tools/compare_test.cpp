// Comparisons as their user sees them: tables, exit codes, and what is refused.
#include "tests/tools/workplace.h"

#include <cmath>
#include <csignal>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string head = "[compare]\nmodel = \"SSH\"\nreduced_volume = 0.8\nL = 0.05\n";
const std::string small =
    head + "methods = [\"newton\", \"shooting\"]\n[tolerance]\nenergy = 1e-8\n";

class Compare : public Workplace {
 protected:
  std::string column(const Table& t, const std::string& quantity, const std::string& name) const {
    for (std::size_t row = 0; row < t.rows.size(); ++row)
      if (t.text(row, "quantity") == quantity) return t.text(row, name);
    ADD_FAILURE() << "no row " << quantity;
    return "";
  }
};

TEST_F(Compare, leaves_tables_profiles_and_an_input_that_gives_the_same_again) {
  write("in.toml", small);
  const Ended ended = sbeh(into("out", "compare"));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  for (const char* word : {"newton", "shooting", "energy_bending", "H_pole", "distance"})
    EXPECT_NE(ended.out.find(word), std::string::npos) << word;

  const Table compare = table("out/compare.csv");
  EXPECT_EQ(compare.rows.size(), 11u);
  EXPECT_EQ(column(compare, "energy", "agrees"), "yes");
  EXPECT_EQ(column(compare, "energy", "tolerance"), "1e-08");
  EXPECT_EQ(column(compare, "pressure", "agrees"), "");
  EXPECT_EQ(column(compare, "distance", "first_value"), "");
  for (std::size_t row = 0; row + 1 < compare.rows.size(); ++row)
    EXPECT_EQ(compare.number(row, "difference"),
              std::abs(compare.number(row, "first_value") - compare.number(row, "second_value")));
  const Table methods = table("out/methods.csv");
  ASSERT_EQ(methods.rows.size(), 2u);
  EXPECT_EQ(methods.text(0, "energy"), column(compare, "energy", "first_value"));
  EXPECT_EQ(methods.text(1, "status"), "found");
  const Table profiles = table("out/profiles.csv");
  EXPECT_EQ(profiles.rows.size(), 3 * 48 + 1 + 257u);
  for (std::size_t row = 0; row < profiles.rows.size(); ++row)
    EXPECT_LT(std::abs(profiles.number(row, "distance")), 1e-5);

  fs::copy_file(path("out/run.toml"), path("again.toml"));
  must(into("again", "compare", "again.toml"));
  EXPECT_EQ(read("again/compare.csv"), read("out/compare.csv"));
  EXPECT_EQ(read("again/profiles.csv"), read("out/profiles.csv"));
}

TEST_F(Compare, that_misses_a_tolerance_ends_with_1_and_says_which_and_by_how_much) {
  write("in.toml", head + "methods = [\"newton\", \"shooting\"]\n[tolerance]\nenergy = 1e-14\n");
  const Ended ended = sbeh(into("out", "compare"));
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(ended.err.starts_with("sbeh: energy: -10.17")) << ended.err;
  EXPECT_NE(ended.err.find(" by newton, -10.17"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("relative difference "), std::string::npos) << ended.err;
  EXPECT_TRUE(ended.err.ends_with(" is more than the tolerance 1e-14\n")) << ended.err;
  EXPECT_EQ(column(table("out/compare.csv"), "energy", "agrees"), "no");
}

TEST_F(Compare, is_not_written_over_other_results) {
  write("in.toml", small);
  must(into("out", "compare"));
  const Contents before = contents("out");
  must_refuse(into("out", "compare"), "out: already holds results (see its run.toml)");
  EXPECT_EQ(contents("out"), before);
}

TEST_F(Compare, that_is_interrupted_says_so_and_can_begin_again) {
  write("in.toml", head + "methods = [\"surface3d\", \"newton\"]\n");
  Program program(here(), into("out", "compare"));
  ASSERT_TRUE(wait_until([&] { return exists(path("out/.lock")); }));
  program.send(SIGTERM);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 128 + SIGTERM);
  EXPECT_EQ(ended.err, "sbeh: interrupted; nothing is kept, the same command begins again\n");
  EXPECT_EQ(contents("out").size(), 1u);
  write("in.toml", small);
  must(into("out", "compare"));
}

TEST_F(Compare, is_checked_without_being_run) {
  write("in.toml", small);
  const Ended ended = sbeh({"check", "in.toml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(ended.out.starts_with("in.toml: SSH oblate, reduced volume 0.8, L = 0.05 by 2 "))
      << ended.out;
}

// ---- evolutions ---------------------------------------------------------------------------------

const std::string evolution =
    "[compare]\nevolution = \"run.toml\"\nmethods = [\"surface3d\", \"harmonic_flow\"]\n";

class CompareEvolution : public Compare {
 protected:
  void SetUp() override {
    Compare::SetUp();
    write_run("SSH", "");
  }
  void write_run(const std::string& model, const std::string& more) {
    write("run.toml", "model = \"" + model
                          + "\"\n[surface]\nshape = \"harmonics\"\nmodes = [[2, 2, 0.2], [3, 2, "
                            "0.1]]\ntriangles = 180\n"
                          + more + "[time]\nend = 0.01\noutput = [0, 0.005, 0.01]\n");
  }
};

TEST_F(CompareEvolution, leaves_energies_over_time_of_two_methods_that_agree) {
  write("in.toml",
        evolution + "[harmonic_flow]\ndegree = 8\n[tolerance_3d]\nhistory = 1e-4\nenergy = 1e-4\n");
  const Ended ended = sbeh(into("out", "compare"));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  for (const char* word : {"the evolution of run.toml (SSH) to t = 0.01", "those of l <= 6"})
    EXPECT_NE(ended.out.find(word), std::string::npos) << ended.out;
  const Table histories = table("out/histories.csv");
  ASSERT_EQ(histories.rows.size(), 6u);
  EXPECT_EQ(histories.text(5, "method"), "harmonic_flow");
  EXPECT_EQ(histories.number(5, "time"), 0.01);
  const Table compare = table("out/compare.csv");
  EXPECT_EQ(column(compare, "history", "agrees"), "yes");
  EXPECT_EQ(column(compare, "energy", "second_value"), histories.text(5, "energy"));
  EXPECT_FALSE(exists(path("out/profiles.csv")));
  must({"picture", "compare", "out"});
  EXPECT_TRUE(exists(path("out/histories.png")));
  EXPECT_FALSE(exists(path("out/profiles.png")));
  must({"report", "out"});

  // The record is whole without the run's file.
  fs::remove(path("run.toml"));
  must({"check", "out/run.toml"});
  fs::copy_file(path("out/run.toml"), path("again.toml"));
  must(into("again", "compare", "again.toml"));
  EXPECT_EQ(read("again/histories.csv"), read("out/histories.csv"));
  EXPECT_EQ(read("again/run.toml"), read("out/run.toml"));
}

TEST_F(CompareEvolution, takes_the_rows_of_a_run_that_has_ended) {
  must({"run", "run.toml", "-o", "done", "--no-pictures"});
  write("in.toml",
        "[compare]\nevolution = \"done\"\nmethods = [\"surface3d\", "
        "\"harmonic_flow\"]\n[harmonic_flow]\ndegree = 6\n");
  must(into("out", "compare"));
  const Table histories = table("out/histories.csv"), series = table("done/series.csv");
  ASSERT_EQ(histories.rows.size(), 6u);
  EXPECT_EQ(histories.text(2, "energy"), series.text(2, "energy"));

  // What was compared can be told from what the folder holds now.
  fs::copy_file(path("out/run.toml"), path("again.toml"));
  must(into("again", "compare", "again.toml"));
  const std::string ran = read("done/run.toml");
  std::string other = ran;
  other.replace(other.find("[2, 2, 0.2]"), 11, "[2, 2, 0.3]");
  write("done/run.toml", other);
  must_refuse(into("third", "compare", "again.toml"),
              "again.toml:9: [compare] evolution = \"done\": is not what [evolution] says");
  write("done/run.toml", ran);

  // Energies of other times are not compared.
  const std::string rows = read("done/series.csv");
  write("done/series.csv", rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1));
  const Ended cut = sbeh(into("cut", "compare"));
  EXPECT_EQ(cut.exit_code, 1);
  EXPECT_NE(cut.err.find("ends at t = 0.005, not at 0.01"), std::string::npos) << cut.err;
}

TEST_F(CompareEvolution, refuses_what_has_no_place_beside_a_run) {
  write("scan.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\n");
  const std::vector<std::pair<std::string, std::string>> cases{
      {evolution + "L = 1\n",
       "in.toml:4: [compare] L = 1: has no place where evolution names a run"},
      {evolution + "[material]\nL = 1\n", "in.toml:4: [material]: has no place where evolution"},
      {evolution + "[harmonic_flow]\ndegree = 5\n",
       "in.toml:5: [harmonic_flow] degree = 5: must be"},
      {"[compare]\nevolution = \"run.toml\"\nmethods = [\"surface3d\", \"newton\"]\n",
       "in.toml:3: [compare] methods = \"newton\": belongs to stationary states"},
      {"[compare]\nevolution = \"run.toml\"\nmethods = [\"surface3d\"]\n",
       "in.toml:3: [compare] methods = [\"surface3d\"]: must be two"},
      {"[compare]\nevolution = \"scan.toml\"\nmethods = [\"surface3d\"]\n",
       "in.toml:2: [compare] evolution = \"scan.toml\": must be an input of sbeh run"},
      {"[compare]\nevolution = \"none.toml\"\n", "none.toml"},
      {head + "methods = [\"newton\", \"harmonic_flow\"]\n",
       "in.toml:5: [compare] methods = \"harmonic_flow\": belongs to the evolution of a run"},
  };
  for (const auto& [text, message] : cases) {
    write("in.toml", text);
    const Ended ended = sbeh(into("out", "compare"));
    EXPECT_EQ(ended.exit_code, 2) << text;
    EXPECT_NE(ended.err.find(message), std::string::npos) << ended.err;
  }
  write_run("Helfrich-global", "");
  write("in.toml", evolution);
  EXPECT_NE(sbeh(into("out", "compare")).err.find("keeps the area of every piece"),
            std::string::npos);
  write_run("SSH", "perturbation = [[4, 0, 0.01]]\n");
  EXPECT_NE(sbeh(into("out", "compare")).err.find("its start has a perturbation"),
            std::string::npos);
}

TEST_F(Compare, refuses_what_is_wrong_with_file_line_and_reason) {
  struct Case {
    std::string text, message;
  };
  const std::string two = "methods = [\"newton\", \"minimiser\"]\n";
  const std::vector<Case> cases{
      {"", "in.toml: [compare] model: missing; must be one of"},
      {head, "in.toml:1: [compare] methods: missing; must be a list of words"},
      {head + "methods = [\"newton\"]\n",
       "in.toml:5: [compare] methods = [\"newton\"]: must be two at least"},
      {head + "methods = [\"newton\", \"ceres\"]\n", "in.toml:5: [compare] methods = \"ceres\""},
      {"[compare]\nmodel = \"SBEH\"\nreduced_volume = 0.8\nL = 0.05\nmethods = [\"newton\", "
       "\"shooting\"]\n",
       "in.toml:5: [compare] methods = "},
      {"[compare]\nmodel = \"SSH\"\nreduced_volume = 1\nL = 1\n" + two,
       "in.toml:3: [compare] reduced_volume = 1: must be < 1"},
      {"[compare]\nmodel = \"Helfrich-local\"\n",
       "in.toml:2: [compare] model = \"Helfrich-local\": must be one of"},
      {head + two + "[tolerance]\nenergie = 1\n",
       "in.toml:7: [tolerance] energie: unknown key; did you mean \"energy\"?"},
      {head + two + "[tolerance]\nenergy = 0\n", "in.toml:7: [tolerance] energy = 0: must be > 0"},
      {head + two + "[surface3d]\ntriangles = 80\n",
       "in.toml:6: [surface3d]: has no place without \"surface3d\""},
      {head + two + "[tolerance_3d]\nenergy = 1\n",
       "in.toml:6: [tolerance_3d]: has no place without \"surface3d\""},
      {head + two + "[harmonics]\ndegree = 16\n",
       "in.toml:6: [harmonics]: has no place without \"harmonics\""},
      {head + "methods = [\"newton\", \"harmonics\"]\n[harmonics]\ndegree = 40\n",
       "in.toml:7: [harmonics] degree = 40: must be"},
      {head + "methods = [\"newton\", \"harmonics\"]\nbranch = \"stomatocyte\"\n",
       "in.toml:5: [compare] methods = "},
      {"[compare]\nmodel = \"SBEH\"\nreduced_volume = 0.8\nL = 0.05\nmethods = [\"newton\", "
       "\"harmonics\"]\n",
       "in.toml:5: [compare] methods = "},
      {"[compare]\nmodel = \"SSH\"\nreduced_volume = 0.6\nL = 0.05\nmethods = [\"newton\", "
       "\"harmonics\"]\n",
       "in.toml:5: [compare] methods = "},
      {head + two + "[tolerance]\nhistory = 1\n",
       "in.toml:7: [tolerance] history = 1: has its place in [tolerance_3d]"},
      {head + "methods = [\"newton\", \"surface3d\"]\n[tolerance_3d]\nhistory = 1\n",
       "in.toml:7: [tolerance_3d] history = 1: needs the methods \"flow\" and \"surface3d\""},
      {head + "methods = [\"flow\", \"newton\"]\nbranch = \"stomatocyte\"\n",
       "in.toml:5: [compare] methods = "},
      {head + "methods = [\"surface3d\", \"newton\"]\nbranch = \"stomatocyte\"\n",
       "in.toml: [surface3d] start: must be \"revolved\" for branch = \"stomatocyte\""},
      {head + two + "[material]\nL = 1\n",
       "in.toml:7: [material] L = 1: must not be given in a comparison"},
      {head + "methods = [\"newton\", \"shooting\"]\n[material]\nspontaneous_curvature = 1\n",
       "in.toml:7: [material] spontaneous_curvature = 1: must be 0 for the method \"shooting\""},
      {head
           + "methods = [\"minimiser\", \"flow\"]\n[material]\n"
             "area_difference = { stiffness = 0.1, W2 = -26 }\n",
       "in.toml:7: [material] area_difference = { W2 = -26, stiffness = 0.1 }: must not be given "
       "for the method \"flow\": newton and minimiser alone know it"},
      {head + "methods = [\"newton\", \"shooting\"]\n[material]\nlipid_density = [1, 0.5]\n",
       "in.toml:7: [material] lipid_density = "},
      {head + "methods = [\"newton\", \"surface3d\"]\n[surface3d]\ntriangles = 80\nrun = \"a\"\n",
       "in.toml:7: [surface3d] triangles = 80: must not be given together with run"},
      {head + "methods = [\"newton\", \"surface3d\"]\n[surface3d]\nrest_speed = -1\n",
       "in.toml:7: [surface3d] rest_speed = -1: must be in"},
  };
  for (const Case& wrong : cases) {
    write("in.toml", wrong.text);
    must_refuse(into("out", "compare"), wrong.message);
    EXPECT_FALSE(exists(path("out"))) << wrong.message;
  }
}

TEST_F(Compare, takes_the_last_frame_of_a_3D_run_of_the_same_case_only) {
  write("run.toml",
        "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\ntriangles = 80\n"
        "[material]\nL = 0.05\n[time]\nend = 0.1\nframes = [0, 0.1]\noutput = [0.1]\n");
  must(into("run", "run", "run.toml"));
  const std::string rest = "methods = [\"newton\", \"surface3d\"]\n[surface3d]\nrun = \"run\"\n";
  write("in.toml", head + rest + "[tolerance_3d]\nenergy = 0.1\ndistance = 0.1\npressure = 1\n");
  must(into("out", "compare"));
  const Table methods = table("out/methods.csv");
  EXPECT_EQ(methods.number(1, "energy"), table("run/series.csv").number(0, "energy"));
  EXPECT_EQ(methods.number(1, "pressure"), -table("run/series.csv").number(0, "lambda"));
  EXPECT_NE(methods.text(1, "remark").find("last frame of run, t = 0.1"), std::string::npos);
  write("flow.toml", head
                         + "methods = [\"flow\", \"surface3d\"]\n[surface3d]\nrun = \"run\"\n"
                           "[tolerance_3d]\nhistory = 1e-2\n");
  must(into("histories", "compare", "flow.toml"));
  EXPECT_EQ(table("histories/histories.csv").numbers("time"), (std::vector<double>{0.1, 0.1}));

  const auto refused = [&](const std::string& model, const std::string& volume,
                           const std::string& L, const std::string& reason) {
    write("in.toml", "[compare]\nmodel = \"" + model + "\"\nreduced_volume = " + volume
                         + "\nL = " + L + "\n" + rest);
    must_refuse(into("other", "compare"), reason);
  };
  const std::string other = "run: is a run of another case: ";
  refused("SBEH", "0.8", "0.05", other + "its model is SSH");
  refused("SSH", "0.7", "0.05", other + "its reduced volume is 0.8");
  refused("SSH", "0.8", "0.06", other + "its L1 is 0.05, that of the comparison 0.06");
  fs::rename(path("run"), path("moved"));
  refused("SSH", "0.8", "0.05", "run: is no folder of a 3D run");
}

}  // namespace
}  // namespace sbeh::tools::test
