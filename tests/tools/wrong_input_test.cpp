// Wrong input: one sentence that says where and what is allowed, exit 2, and nothing written.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

using WrongInput = Workplace;

/// Both with ' in place of ".
struct Case {
  std::string text;     ///< of the file in.toml
  std::string message;  ///< how the sentence goes on after "sbeh: in.toml"
};

std::string in_double_quotes(std::string text) {
  std::replace(text.begin(), text.end(), '\'', '"');
  return text;
}

const std::string scan = "[scan]\nreduced_volume = [0.7]\nL = [0.05]\n";
const std::string grid = "must be a number, a list of numbers, or a range { from, to, count }";

const std::vector<Case> wrong_scans{
    {"", ": [scan] reduced_volume: missing; " + grid},
    {"<xml>", ":1: is not TOML: "},
    {"\x7f"
     "ELF\x01\x02",
     ":1: is not TOML: "},
    {scan + "nodes = 3", ":4: [scan] nodes: unknown key"},
    {scan + "method = 'newtn'", ":4: [scan] method = 'newtn': must be one of 'newton', 'flow'"},
    {scan + "[numeric]", ":4: [numeric]: unknown table; did you mean 'numerics'?"},
    {scan + "[numerics]\nelement = 3",
     ":5: [numerics] element: unknown key; did you mean 'elements'?"},
    {scan + "[numerics]\nelements = 48.0", ":5: [numerics] elements = 48.0: must be an integer"},
    {scan + "[numerics]\nelements = 7", ":5: [numerics] elements = 7: must be in 8 ... 4096"},
    {scan + "[numerics]\nfirst_step = -1e-6", ":5: [numerics] first_step = -1e-06: must be in "},
    {scan + "[numerics]\nlargest_step = 0", ":5: [numerics] largest_step = 0: must be in "},
    {scan + "[material]\nL = 0.1", ":5: [material] L = 0.1: must not be given in a scan"},
    {"[scan]\nreduced_volume = 1.01\nL = 0.05",
     ":2: [scan] reduced_volume = 1.01: must be > 0 and <= 1"},
    {"[scan]\nreduced_volume = 0\nL = 0.05", ":2: [scan] reduced_volume = 0: must be > 0 and <= 1"},
    {"[scan]\nreduced_volume = -0.7\nL = 0.05",
     ":2: [scan] reduced_volume = -0.7: must be > 0 and <= 1"},
    {"[scan]\nreduced_volume = 0.7\nL = [0.1,\n0]", ":4: [scan] L = 0: must be > 0"},
    {"[scan]\nreduced_volume = 0.7\nL = -1", ":3: [scan] L = -1: must be > 0"},
    {"[scan]\nreduced_volume = []\nL = 1", ":2: [scan] reduced_volume = []: must not be empty"},
    {"[scan]\nreduced_volume = 0.7\nL = []", ":3: [scan] L = []: must not be empty"},
    {"[scan]\nreduced_volume = '0.7'\nL = 1", ":2: [scan] reduced_volume = '0.7': " + grid},
    {"[scan]\nreduced_volume = 0.7\nL = {from = 1, to = 2, count = 100000}\nmodels = []",
     ":4: [scan] models = []: must not be empty"},
    {"[scan]\nreduced_volume = {from = 0.5, to = 0.9, count = 1001}\n"
     "L = {from = 0.01, to = 0.09, count = 1000}",
     ":3: [scan] L = { count = 1000, from = 0.01, to = 0.09 }: must have fewer values: that makes "
     "2002000 points with the other lists, more than 1000000"},
};

const std::string relax = "model = 'SBEH'\ntime.end = 0.1\n[start]\nshape = ";
const std::string axes_differ = ": must not differ by more than a factor of 1000";

const std::vector<Case> wrong_evolutions{
    {scan, ": is an input: for sbeh scan in.toml or sbeh check in.toml"},
    {relax + "'sphere'",
     ":4: [start] shape = 'sphere': must be one of 'ellipsoid', 'harmonics', 'scan'"},
    {relax + "'ellipsoid'\nreduced_volume = 2",
     ":5: [start] reduced_volume = 2: must be > 0 and <= 1"},
    {relax + "'ellipsoid'\naxes = [1, 0.0001]", ":5: [start] axes = [1, 0.0001]" + axes_differ},
    {relax + "'ellipsoid'\naxes = [1e-200, 1e200]",
     ":5: [start] axes = [1e-200, 1e+200]" + axes_differ},
    {relax + "'ellipsoid'\nreduced_volume = 0.7\n[material]\nL = 0",
     ":7: [material] L = 0: must be > 0"},
    {relax + "'ellipsoid'\nreduced_volume = 0.7\n[time]\nend = -1", ":6: is not TOML: "},
    {relax + "'harmonics'\nmodes = [[2, -2.0]]",
     ": [start] modes: harmonic sphere: r = -0.262 at theta = 0: must be > 0"},
    {relax + "'harmonics'\nmodes = [[2, 0.1]]\norder_modes = [[2, 1e300]]",
     ": [start] order_modes: the order is 6.31e+299 at theta = 0: must be in -1 ... 1"},
    {relax + "'harmonics'\nmodes = [[2, 0.1]]\n[material]\npotential = [0, 0, 1]",
     ": [start] order: no ordered state rests on the sphere with this material; give the order"},
};

TEST_F(WrongInput, of_a_scan_is_refused_with_file_line_and_what_is_allowed) {
  for (const Case& wrong : wrong_scans) {
    write("in.toml", in_double_quotes(wrong.text));
    must_refuse(into("out", "scan"), "in.toml" + in_double_quotes(wrong.message));
  }
  EXPECT_EQ(contents("").size(), 1u);
}

TEST_F(WrongInput, of_an_evolution_is_refused_with_file_line_and_what_is_allowed) {
  for (const Case& wrong : wrong_evolutions) {
    write("in.toml", in_double_quotes(wrong.text));
    must_refuse(into("out", "relax"), "in.toml" + in_double_quotes(wrong.message));
  }
  EXPECT_EQ(contents("").size(), 1u);
}

TEST_F(WrongInput, of_another_command_is_refused_with_its_name) {
  const std::vector<std::pair<std::string, std::string>> inputs{
      {"scan", scan},
      {"relax", in_double_quotes(relax) + "\"ellipsoid\"\nreduced_volume = 0.7\n"},
      {"run",
       "model = \"SSH\"\ntime.end = 1\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n"},
      {"compare", "[compare]\nbranch = \"oblate\"\n"},
      {"stability", "[stability]\nscan = \"out\"\n"},
      {"modes", "[modes]\nreduced_volume = 0.8\nL = 0.05\n"}};
  for (const auto& [own, text] : inputs)
    for (const auto& [command, ignored] : inputs) {
      if (command == own) continue;
      write("in.toml", text);
      must_refuse({command, "in.toml"},
                  "in.toml: is an input: for sbeh " + own + " in.toml or sbeh check in.toml");
    }
}

TEST_F(WrongInput, that_is_a_file_or_a_folder_of_another_kind_is_refused_with_the_commands_for_it) {
  write("in.toml", scan);
  must(into("out", "scan"));
  must({"mesh", "sphere", "--triangles", "80", "-o", "a.stl"});
  write("relaxed/series.csv", "time,energy\n");
  write("relaxed/profiles.csv", "index,time,file\n");  // of which `picture compare` has one too
  const std::string profile =
      "out/points/" + fs::directory_iterator(path("out/points"))->path().filename().string();
  const std::vector<std::pair<std::string, std::string>> kinds{
      {"in.toml", "is an input: for sbeh scan in.toml or sbeh check in.toml"},
      {"a.stl", "is a mesh: for sbeh mesh file a.stl or sbeh picture mesh a.stl"},
      {profile, "is a profile: for sbeh mesh revolve " + profile},
      {"out/scan.csv",
       "is a table of the results of sbeh scan: for sbeh report out or sbeh picture scan out"},
      {"out", "holds the results of sbeh scan: for sbeh report out or sbeh picture scan out"},
      {"relaxed",
       "holds the results of sbeh relax: for sbeh report relaxed or sbeh picture relax relaxed"}};
  for (const std::string command : {"run", "check", "report", "mesh file", "mesh revolve",
                                    "picture scan", "picture compare", "picture mesh"})
    for (const auto& [file, what] : kinds) {
      if ((what + ' ').find(fmt::format("sbeh {} {} ", command, file)) != std::string::npos)
        continue;
      std::vector<std::string> arguments{file};
      arguments.insert(arguments.begin(), command.substr(command.find(' ') + 1));
      if (command.find(' ') != std::string::npos)
        arguments.insert(arguments.begin(), command.substr(0, command.find(' ')));
      if (command.starts_with("mesh")) arguments.emplace_back("--report");
      const Ended ended = sbeh(arguments);
      EXPECT_EQ(ended.exit_code, 2);
      EXPECT_NE(ended.err.find(fmt::format("{}: {}\n", file, what)), std::string::npos)
          << command << ended.err;
    }
  must_refuse({"picture", "scan", "a.png"}, "a.png: is not there");
  must_refuse({"modes", "--scan", "none", "--reduced-volume", "0.7", "--L", "0.05"},
              "none: is not there");
  write("t.csv", "a\n");
  must_refuse({"picture", "run", "t.csv"}, "t.csv: is no folder");
  must_refuse({"mesh", "file", "t.csv", "--report"}, "t.csv: unknown suffix \".csv\"");
  const std::string of_mesh = "model = \"SSH\"\ntime.end = 1\n[surface]\nshape = \"mesh\"\nfile = ";
  write("in.toml", of_mesh + "\"t.csv\"\n");
  must_refuse({"check", "in.toml"}, "t.csv: unknown suffix \".csv\"; meshes can be read from .obj");
  write("in.toml", of_mesh + "\"out\"\n");
  must_refuse({"check", "in.toml"}, "out: is a directory, not a file");
  must_refuse({"mesh", "revolve", "t.csv", "--report"}, "t.csv: is no profile of this program");
}

TEST_F(WrongInput, is_refused_by_the_check_with_the_same_words) {
  for (const Case& wrong : wrong_evolutions) {
    if (wrong.text == scan) continue;
    write("in.toml", in_double_quotes(wrong.text));
    must_refuse({"check", "in.toml"}, "in.toml" + in_double_quotes(wrong.message));
  }
  write("in.toml", "x = 1\n");
  must_refuse({"check", "in.toml"},
              "in.toml: must have a table [scan] (a scan), [start] (one axisymmetric evolution), "
              "[surface] (one 3D run), [compare] (one case by several methods), [stability] "
              "(axisymmetric states, perturbed in 3D), [modes] (the modes of one state), [states] "
              "(rest states in 3D), [diagram] (a classical phase diagram) or [sweep] (many runs of "
              "one of these); it has none of them");
}

TEST_F(WrongInput, that_is_no_readable_file_is_refused_with_the_reason) {
  write("in.toml", scan);
  std::filesystem::create_directory(path("folder"));
  const Contents before = contents("");
  for (const std::string command : {"scan", "relax", "run", "check"}) {
    must_refuse({command, "missing.toml"},
                "missing.toml: cannot be read: No such file or directory");
    must_refuse({command, "in.toml/x"}, "in.toml/x: cannot be read: Not a directory");
    must_refuse({command, "folder"}, "folder: is a directory, not a file");
    must_refuse({command, "/dev/zero"}, "/dev/zero: is too long for an input");
  }
  EXPECT_EQ(contents(""), before);
}

TEST_F(WrongInput, leaves_results_that_are_there_as_they_are) {
  write("in.toml", scan);
  must(into("out", "scan"));
  const Contents before = contents("out");
  write("in.toml", scan + "nodes = 3");
  must_refuse(into("out", "scan"), "in.toml:4: [scan] nodes: unknown key");
  EXPECT_EQ(contents("out"), before);
}

}  // namespace
}  // namespace sbeh::tools::test
