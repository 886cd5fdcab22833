// `sbeh check FILE`: says what would run, and writes nothing.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

namespace sbeh::tools::test {
namespace {

using Check = Workplace;

// The input that `sbeh check` prints, below its first line.
std::string resolved(const Ended& ended) { return ended.out.substr(ended.out.find("\n\n") + 2); }

TEST_F(Check, of_a_scan_counts_its_points_and_prints_every_parameter) {
  write("in.toml", "[scan]\nreduced_volume = [0.6, 0.7]\nL = [0.01, 0.02, 0.03]\n");
  const Ended ended = sbeh({"check", "in.toml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(ended.out.starts_with("in.toml: a scan of 12 points by newton")) << ended.out;
  for (const char* key : {"\nmethod = ", "\npotential = ", "\nelements = ", "\nbranches = "})
    EXPECT_NE(ended.out.find(key), std::string::npos) << key;
  EXPECT_EQ(contents("").size(), 1u);
}

TEST_F(Check, of_an_evolution_tells_its_start_and_prints_every_parameter) {
  write("in.toml",
        "model = \"SSH\"\ntime.end = 3\ntime.every_step = true\n[start]\nshape = \"ellipsoid\"\n"
        "reduced_volume = 0.7\n");
  const Ended ended = sbeh({"check", "in.toml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(
      ended.out.starts_with("in.toml: an evolution of SSH to t = 3, from reduced volume 0.7, "))
      << ended.out;
  for (const char* key : {" lines of history and one for each step, 8 profiles\n", "\nend = 3",
                          "\nfriction_normal = ", "\nfirst_step = "})
    EXPECT_NE(ended.out.find(key), std::string::npos) << key;
  EXPECT_EQ(contents("").size(), 1u);
}

TEST_F(Check, of_a_3d_run_tells_what_it_costs_and_prints_every_parameter) {
  write("in.toml",
        "model = \"SBEH\"\ntime.end = 3\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n"
        "triangles = 1280\n");
  const Ended ended = sbeh({"check", "in.toml"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(
      ended.out.starts_with("in.toml: a 3D run of SBEH to t = 3, reduced volume 0.8, 1280 "
                            "triangles, 25617 unknowns; about "))
      << ended.out;
  for (const char* words :
       {" s a step and ", " MB of memory; 178 lines of history, 8 frames of 1.79 MB\n",
        "\ntriangles = 1280", "\norder = ", "\nscheme = ", "\ncheckpoint_minutes = 10\n"})
    EXPECT_NE(ended.out.find(words), std::string::npos) << words;
  EXPECT_EQ(contents("").size(), 1u);
}

TEST_F(Check, of_symmetric_triangles_says_which_numbers_of_them_there_are) {
  const auto checked = [&](int triangles) {
    write("in.toml",
          "model = \"SSH\"\ntime.end = 3\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = "
          "0.8\nsymmetry = \"D3h\"\ntriangles = "
              + std::to_string(triangles) + "\n");
    const Ended ended = sbeh({"check", "in.toml"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return ended.out;
  };
  const std::string remark =
      "\n# 576 triangles, not 720: with symmetry = \"D3h\" their number is 36 n², near that 576 or "
      "900\n";
  EXPECT_NE(checked(720).find(remark), std::string::npos) << checked(720);
  EXPECT_EQ(checked(576).find("their number is"), std::string::npos);
}

TEST_F(Check, prints_an_input_that_means_the_same) {
  for (const std::string text :
       {"[scan]\nreduced_volume = {from = 0.6, to = 0.9, count = 40}\nL = 0.1\nmethod = \"flow\"\n",
        "model = \"SBEH\"\ntime.end = 3\n[start]\nshape = \"harmonics\"\nmodes = [[2, 0.1]]\n",
        "model = \"SSH\"\ntime.end = 3\n[surface]\nshape = \"harmonics\"\nmodes = [[5, 3, "
        "0.1]]\n"}) {
    write("in.toml", text);
    const std::string once = resolved(sbeh({"check", "in.toml"}));
    write("again.toml", once);
    EXPECT_EQ(resolved(sbeh({"check", "again.toml"})), once);
  }
}

TEST_F(Check, of_a_start_that_is_not_there_is_refused) {
  write("in.toml",
        "model = \"SBEH\"\ntime.end = 3\n[start]\nshape = \"scan\"\nfolder = \"nowhere\"\n"
        "reduced_volume = 0.7\nL = 0.05\n");
  must_refuse({"check", "in.toml"},
              "nowhere: is not there: neither from the folder of the input nor from ");
}

TEST_F(Check, of_a_misspelt_table_names_the_nearest) {
  for (const auto& [wrong, right] : {std::pair("scna", "scan"),
                                     {"strat", "start"},
                                     {"surfac", "surface"},
                                     {"compaire", "compare"},
                                     {"stabiilty", "stability"},
                                     {"mode", "modes"}}) {
    write("in.toml", fmt::format("[material]\nviscosity = 2\n[{}]\nL = 0.05\n", wrong));
    must_refuse({"check", "in.toml"},
                fmt::format("in.toml:3: [{}]: unknown table; did you mean \"{}\"?", wrong, right));
  }
  write("in.toml", "[material]\nviscosity = 2\n");
  must_refuse({"check", "in.toml"}, "in.toml: must have a table [scan]");
}

TEST_F(Check, of_the_inputs_that_come_with_the_toolkit_finds_them_right) {
  for (const auto& entry : std::filesystem::directory_iterator("studies/inputs"))
    if (entry.path().extension() == ".toml") must({"check", absolute(entry.path()).string()});
}

}  // namespace
}  // namespace sbeh::tools::test
