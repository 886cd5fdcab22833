// `sbeh mesh` as its user meets it: shapes, reports, files, refusals, repair.
#include "studies/io/csv.h"
#include "tests/tools/workplace.h"

#include <cmath>
#include <map>
#include <sstream>

namespace sbeh::tools::test {
namespace {

class MeshTest : public Workplace {
 protected:
  /// The `name: value` lines.
  std::map<std::string, double> report(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "mesh");
    arguments.emplace_back("--report");
    const Ended ended = sbeh(arguments);
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    std::map<std::string, double> values;
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t colon = line.find(": ");
      double value = std::nan("");
      studies::parse_number(line.substr(colon + 2), value);
      values[line.substr(0, colon)] = value;
    }
    return values;
  }
};

// The shape's own numbers beside the mesh's: an independent spectral calculation has the same bending energy.
TEST_F(MeshTest, reports_what_the_shape_has_without_triangles) {
  const auto y53 = report(
      {"harmonic", "--mode", "5,3,0.5", "--grading", "1", "--symmetry", "D3h", "--area", "4pi"});
  EXPECT_NEAR(y53.at("shape_bending"), 100.2740912, 1e-6);
  EXPECT_NEAR(y53.at("bending") / y53.at("shape_bending"), 1, 1e-4);
  EXPECT_NEAR(y53.at("shape_area"), 4 * M_PI, 1e-12);
  EXPECT_NEAR(y53.at("volume"), y53.at("shape_volume"), 1e-5);
  EXPECT_EQ(int(y53.at("triangles")) % 12, 0);
  const auto oblate = report({"ellipsoid", "--axes", "1,1,0.5", "--triangles", "320"});
  EXPECT_NEAR(oblate.at("shape_volume"), 2 * M_PI / 3, 1e-12);
  EXPECT_NEAR(oblate.at("bending") / oblate.at("shape_bending"), 1, 1e-4);
  const auto given = report({"harmonic", "--mode", "2,0,0.3", "--reduced-volume", "0.9"});
  EXPECT_NEAR(given.at("area"), given.at("shape_area"), 1e-4);
  EXPECT_NEAR(given.at("volume"), given.at("shape_volume"), 1e-4);
  EXPECT_EQ(report({"sphere", "--order", "1"}).count("bending"), 0u);
}

TEST_F(MeshTest, makes_the_start_of_the_papers_dynamics) {
  const auto r = report(
      {"harmonic", "--mode", "5,3,0.5", "--triangles", "1280", "--area", "4pi", "-o", "y.vtu"});
  for (const char* name : {"triangles", "area", "volume", "reduced_volume", "min_angle_deg",
                           "max_angle_deg", "edge_ratio", "self_intersections", "euler"})
    ASSERT_EQ(r.count(name), 1u) << name;
  EXPECT_EQ(r.at("triangles"), 1280);
  EXPECT_NEAR(r.at("area"), 4 * M_PI, 1e-11);
  EXPECT_NEAR(r.at("reduced_volume"), 0.7376, 1e-4);
  EXPECT_GT(r.at("min_angle_deg"), 40);
  EXPECT_EQ(r.at("self_intersections"), 0);
  EXPECT_EQ(r.at("euler"), 2);
  // The curved mesh comes back as it was written.
  const auto back = report({"file", "y.vtu", "-o", "y2.vtu"});
  EXPECT_EQ(back.at("area"), r.at("area"));
  EXPECT_EQ(back.at("volume"), r.at("volume"));
  EXPECT_EQ(read("y2.vtu"), read("y.vtu"));
}

TEST_F(MeshTest, meets_the_reduced_volume_asked_for_with_every_shape) {
  must({"mesh", "sphere", "--triangles", "320", "-o", "s.off"});
  const std::vector<std::vector<std::string>> shapes{
      {"ellipsoid", "--reduced-volume", "0.8"},
      {"ellipsoid", "--reduced-volume", "0.8", "--prolate"},
      {"harmonic", "--mode", "2,0,0.9", "--mode", "3,-2,0.05", "--reduced-volume", "0.8"}};
  for (const auto& shape : shapes) {
    auto arguments = shape;
    arguments.insert(arguments.end(), {"--area", "4pi"});
    const auto r = report(arguments);
    EXPECT_NEAR(r.at("reduced_volume"), 0.8, 1e-12);
    EXPECT_NEAR(r.at("area"), 4 * M_PI, 1e-11);
  }
}

TEST_F(MeshTest, of_a_vesicle_at_rest_has_the_area_and_volume_asked_for) {
  const Ended made =
      sbeh({"shape", "--reduced-volume", "0.64", "--radius", "3.9", "-o", "rbc.msh"});
  EXPECT_EQ(made.out,
            "rbc.msh: 1280 triangles of order 3, area 191.1345, volume 159.0239, reduced volume "
            "0.64\n");
  must({"mesh", "file", "rbc.msh", "--report"});
  must_refuse({"shape", "--reduced-volume", "0.64", "-o", "rbc.msh"}, "rbc.msh: is there already");
  must_refuse({"shape", "--reduced-volume", "0.3", "-o", "a.stl"},
              "shape: SSH oblate with a reduced volume of 0.3: there is none: the surface passes");
  must_refuse({"shape", "--reduced-volume", "0.64"}, "shape: nothing to do: give a file with -o");
}

TEST_F(MeshTest, revolves_the_profile_of_a_scan_with_its_order) {
  write("in.toml", "[scan]\nreduced_volume = 0.7\nL = 0.05\n[numerics]\nelements = 24\n");
  must(into("out", "scan"));
  const auto r = report({"revolve", "out/points/SBEH_oblate_v0.7_L0.05.csv", "--area", "4pi",
                         "--reduced-volume", "0.7", "-o", "oblate.vtu"});
  EXPECT_NEAR(r.at("reduced_volume"), 0.7, 1e-12);
  EXPECT_NE(read("oblate.vtu").find("Name=\"order\""), std::string::npos);
}

TEST_F(MeshTest, gives_a_file_other_triangles_when_asked) {
  must({"mesh", "ellipsoid", "--axes", "1,1.2,0.8", "--triangles", "5120", "-o", "fine.ply"});
  const auto fine = report({"file", "fine.ply"});
  const auto coarse = report({"file", "fine.ply", "--triangles", "1280", "--order", "2"});
  EXPECT_EQ(fine.at("triangles"), 5120);
  EXPECT_NEAR(coarse.at("triangles"), 1280, 0.15 * 1280);
  EXPECT_NEAR(coarse.at("volume"), 4 * M_PI / 3 * 0.96, 1e-4);
}

TEST_F(MeshTest, makes_slender_ellipsoids_and_says_how_many_triangles_are_too_few) {
  const auto r = report({"ellipsoid", "--axes", "1,1,50", "--triangles", "1280"});
  EXPECT_NEAR(r.at("volume"), 4 * M_PI / 3 * 50, 0.01 * 4 * M_PI / 3 * 50);
  EXPECT_NEAR(report({"ellipsoid", "--axes", "1,1,0.03", "--triangles", "1280"}).at("volume"),
              4 * M_PI / 3 * 0.03, 1e-5);
  // What it says to do helps.
  must_refuse({"mesh", "ellipsoid", "--axes", "1,1,100", "--triangles", "80", "--report"},
              "the shape bends too sharply for 80 triangles, some fold over when they are curved: "
              "take more");
  must({"mesh", "ellipsoid", "--axes", "1,1,100", "--triangles", "320", "--report"});
  must_refuse({"mesh", "ellipsoid", "--axes", "1,1,0.05", "--triangles", "20", "--report"},
              "the shape bends too sharply for 20 triangles, ");
  must({"mesh", "ellipsoid", "--axes", "1,1,0.05", "--triangles", "80", "--report"});
}

TEST_F(MeshTest, overwrites_nothing_unless_told_to) {
  must({"mesh", "sphere", "--triangles", "80", "-o", "s.vtu"});
  const std::string before = read("s.vtu");
  must_refuse({"mesh", "sphere", "--triangles", "320", "-o", "s.vtu"},
              "s.vtu: is there already; --overwrite replaces it");
  EXPECT_EQ(read("s.vtu"), before);
  must({"mesh", "sphere", "--triangles", "320", "-o", "s.vtu", "--overwrite"});
  EXPECT_NE(read("s.vtu"), before);
}

TEST_F(MeshTest, refuses_wrong_shapes_with_a_sentence_and_writes_nothing) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"sphere"}, "mesh: nothing to do: give a file with -o, or --report, or both"},
      {{"sphere", "-o", "s.txt"}, "s.txt: unknown suffix \".txt\""},
      {{"sphere", "-o", "missing/s.vtu"}, "missing/s.vtu: cannot be written: No such file"},
      {{"sphere", "--report", "--triangles", "3"}, "triangles = 3: must be in 20 ... 200000"},
      {{"sphere", "--report", "--triangles", "1000000"}, "triangles = 1000000: must be in"},
      {{"sphere", "--report", "--order", "4"}, "order = 4: must be 1, 2 or 3"},
      {{"sphere", "--report", "--symmetry", "D3x"}, "--symmetry D3x: must be C1, Cs"},
      {{"harmonic", "--mode", "3,1,0.2", "--report", "--symmetry", "D3h"},
       "symmetry = \"D3h\": the shape has not this symmetry"},
      {{"sphere", "--report", "--area", "-1"}, "area -1: must be > 0"},
      {{"sphere", "--report", "--area", "nan"}, "area nan: must be > 0"},
      {{"sphere", "--report", "--area", "big"}, "--area big: must be a number > 0, or 4pi"},
      {{"sphere", "--report", "--reduced-volume", "0.5"},
       "reduced volume 0.5: the shape has 1, too far away"},
      {{"ellipsoid", "--report"}, "ellipsoid: give either its semi-axes or its reduced volume"},
      {{"ellipsoid", "--report", "--axes", "1,2"}, "--axes 1,2: must be three lengths > 0"},
      {{"ellipsoid", "--report", "--axes", "1,2,0"}, "ellipsoid: semi-axes 1, 2, 0: must be > 0"},
      {{"ellipsoid", "--report", "--reduced-volume", "1.1"},
       "ellipsoid: reduced volume 1.1: must be > 0 and <= 1"},
      {{"ellipsoid", "--report", "--axes", "1,1,2", "--prolate"},
       "ellipsoid: prolate or oblate is a choice for a given reduced volume only"},
      {{"harmonic", "--report", "--mode", "2,0,1", "--reduced-volume", "0.1"},
       "harmonics: reduced volume 0.1: r reaches 0 before"},
      {{"harmonic", "--report", "--mode", "5,3"}, "--mode 5,3: must be degree, order, amplitude"},
      {{"harmonic", "--report", "--mode", "2,3,0.1"}, "--mode 2,3,0.1: degree and order must be"},
      {{"harmonic", "--report", "--mode", "2,0,-3"}, "r = -0.892 at theta = 0"},
      {{"revolve", "none.csv", "--report"}, "none.csv: cannot be read"},
      {{"file", "none.obj", "--report"}, "none.obj: cannot be read: No such file"},
      {{"spher"}, "spher: unknown shape; did you mean sphere?"}};
  for (auto [arguments, message] : wrong) {
    arguments.insert(arguments.begin(), "mesh");
    must_refuse(arguments, message);
  }
  EXPECT_TRUE(contents("").empty());
}

/// The first triangle of an OBJ file turned round, or taken away.
std::string changed(const std::string& obj, bool turned) {
  const std::size_t at = obj.find("\nf ") + 1, end = obj.find('\n', at);
  std::istringstream corners(obj.substr(at + 2, end - at - 2));
  std::string a, b, c;
  corners >> a >> b >> c;
  return obj.substr(0, at) + (turned ? "f " + b + ' ' + a + ' ' + c : "") + obj.substr(end);
}

TEST_F(MeshTest, names_the_defect_of_a_file_and_repairs_it_when_told_to) {
  must({"mesh", "sphere", "--triangles", "320", "--order", "1", "-o", "s.obj"});
  const double volume = report({"file", "s.obj"}).at("volume");
  write("turned.obj", changed(read("s.obj"), true));
  must_refuse({"mesh", "file", "turned.obj", "--report"}, "turned.obj: edge ");
  write("open.obj", changed(read("s.obj"), false));
  must_refuse({"mesh", "file", "open.obj", "--report"}, "open.obj: edge ");
  for (const char* file : {"turned.obj", "open.obj"}) {
    const Ended ended = sbeh({"mesh", "file", file, "--repair", "--report"});
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_TRUE(ended.err.starts_with("sbeh: repaired: ")) << ended.err;
    EXPECT_NEAR(report({"file", file, "--repair"}).at("volume"), volume, 1e-12);
  }
  must_refuse({"mesh", "file", "s.obj", "--report", "--grading", "1"}, "grading: the triangles of");
  write("nan.obj", "v nan 0 0\n" + read("s.obj"));
  must_refuse({"mesh", "file", "nan.obj", "--repair", "--report"}, "nan.obj: point 0 (nan, 0, 0)");
}

TEST_F(MeshTest, is_fast_enough_for_a_million_wrong_triangles) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int t = 0; t < 1'000'000; ++t) text += "f 1 2 3\n";
  write("huge.obj", text);
  must_refuse({"mesh", "file", "huge.obj", "--report"}, "huge.obj: has 1000000 triangles");
}

TEST_F(MeshTest, leaves_nothing_half_written_on_a_full_disk) {
  Surroundings full = here();
  full.largest_file = 10'000;
  const Ended ended = run(full, {"mesh", "sphere", "-o", "s.vtu"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_TRUE(ended.err.starts_with("sbeh: s.vtu: cannot be written")) << ended.err;
  EXPECT_TRUE(contents("").empty());
}

}  // namespace
}  // namespace sbeh::tools::test
