// What a 3D run starts from: shapes, files, frames, rows of a scan, and wrong input.
#include "tests/tools/run_fixture.h"

#include <array>
#include <cmath>
#include <fstream>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

TEST_F(Run3d, finds_its_files_beside_its_input_from_anywhere) {
  must({"mesh", "ellipsoid", "--axes", "1,1,0.8", "--triangles", "80", "-o", "sub.obj"});
  fs::create_directories(path("in/put"));
  fs::rename(path("sub.obj"), path("in/put/m.obj"));
  const std::string text =
      "model = \"SSH\"\n[surface]\nshape = \"mesh\"\nfile = \"m.obj\"\n[time]\nend = 1e-3\n";
  write("in/put/in.toml", text);
  must({"run", "in/put/in.toml", "-o", "out", "--no-pictures"});
  must({"run", path("in/put/in.toml").string(), "-o", "out2", "--no-pictures"});
  must({"run", "out/run.toml", "-o", "again", "--no-pictures"});
  EXPECT_EQ(read("out/series.csv"), read("out2/series.csv"));
  EXPECT_EQ(read("out/series.csv"), read("again/series.csv"));
  must({"run", "in/put/in.toml", "-o", "out", "--resume", "--no-pictures"});
  // From the folder of work too; the folder of the input comes first.
  write("in.toml",
        "model = \"SSH\"\n[surface]\nshape = \"mesh\"\nfile = \"in/put/m.obj\"\n[time]\nend = "
        "1e-3\n");
  must({"check", "in.toml"});
  fs::create_directories(path("other"));
  fs::copy_file(path("in.toml"), path("other/in.toml"));
  must({"check", "other/in.toml"});
  write("m.obj", "nonsense");
  must({"check", "in/put/in.toml"});
  fs::remove(path("in/put/m.obj"));
  fs::remove(path("m.obj"));
  must_refuse({"check", "in/put/in.toml"},
              "m.obj: is not there: neither from the folder of the input nor from /");
}

TEST_F(Run3d, from_a_frame_goes_on_with_its_model_and_material_wherever_it_lies) {
  const std::string soon = "[time]\nend = 0.0001\nframes = [0, 0.0001]\noutput = [0, 0.0001]\n";
  const std::string material =
      "[material]\nL = 0.08\npotential = [0, 0, -9, 0, 10]\nviscosity = 0.25\nimmobility = 3\n"
      "friction = 0.5\norder_viscosity = -3\nresidual_stiffness = 0.01\nspontaneous_curvature = "
      "-2.7\n";
  write("in.toml", ellipsoid + soon + material);
  must(into("first", "run"));
  fs::copy_file(path("first/frames/0001.vtu"), path("copy.vtu"));
  fs::remove_all(path("first/run.toml"));
  write("frame.toml", "[surface]\nshape = \"frame\"\nfile = \"copy.vtu\"\n" + soon);
  const Ended ended = sbeh(into("second", "run", "frame.toml"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.err.find("copy.vtu"), std::string::npos) << ended.err;
  EXPECT_NEAR(table("second/series.csv").number(0, "energy"),
              table("first/series.csv").number(1, "energy"), 1e-11);
  write("again.toml", ellipsoid + soon + material);
  must(into("third", "run", "again.toml"));
  const auto material_of = [&](const std::string& description) {
    const std::string text = read(description);
    const std::size_t at = text.find("\n[material]");
    return text.substr(at, text.find("\n[numerics]") - at);
  };
  EXPECT_EQ(material_of("second/run.toml"), material_of("third/run.toml"));
}

TEST_F(Run3d, from_a_frame_says_what_is_changed_and_what_that_does_to_the_energy) {
  const std::string soon = "[time]\nend = 0.0001\nframes = [0, 0.0001]\noutput = [0, 0.0001]\n";
  write("in.toml", ellipsoid + soon + "[material]\nL = 0.08\nspontaneous_curvature = -2.7\n");
  must(into("first", "run"));
  const double before = table("first/series.csv").number(1, "energy");
  const std::string start =
      "[surface]\nshape = \"frame\"\nfile = \"first/frames/0001.vtu\"\n" + soon;
  const std::vector<std::array<std::string, 3>> cases{
      {"", "[material]\nL = 0.05\n", "material.L1: 0.08 there, 0.05 here"},
      {"", "[material]\nspontaneous_curvature = 0\n",
       "material.spontaneous_curvature: -2.7 there, 0 here"},
      {"", "[material]\nresidual_stiffness = 0.1\n",
       "material.residual_stiffness: 0 there, 0.1 here"},
      {"", "[material]\nviscosity = 2\n", "material.viscosity: 1 there, 2 here"},
      {"", "[material]\nfriction = 1\n",
       "material.friction_tangential: 0.1 there, 1 here; material.friction_normal: 0.1 there, 1 "
       "here"},
      {"model = \"SSH\"\n", "", "model: \"SBEH\" there, \"SSH\" here"},
      {"model = \"Helfrich-local\"\n", "", "model: \"SBEH\" there, \"Helfrich-local\" here"},
      {"model = \"SSH\"\n", "[material]\nL = 0.05\n",
       "model: \"SBEH\" there, \"SSH\" here; material.L1: 0.08 there, 0.05 here"},
  };
  for (const auto& [model, material, change] : cases) {
    write("in.toml", std::string(model).append(start).append(material));
    fs::remove_all(path("out"));
    const Ended ended = sbeh(into("out", "run"));
    EXPECT_EQ(ended.exit_code, 0);
    const std::string remark =
        "first/frames/0001.vtu: " + change + "; the energy of this start is ";
    ASSERT_TRUE(ended.err.starts_with("sbeh: " + remark)) << ended.err;
    const std::string told = ended.err.substr(6 + remark.size());
    EXPECT_NEAR(std::stod(told), before, 1e-8) << change;
    EXPECT_NEAR(std::stod(told.substr(told.find("computed with, ") + 15)),
                table("out/series.csv").number(0, "energy"), 1e-8)
        << change;
    EXPECT_NE(read("out/run.toml").find("\n# " + remark), std::string::npos);
    EXPECT_NE(sbeh({"check", "in.toml"}).out.find("\n# " + remark), std::string::npos);
    must(into("again", "run", "out/run.toml"));  // says it again
    EXPECT_EQ(contents("again"), contents("out"));
    must({"run", "out/run.toml", "-o", "out", "--no-pictures", "--resume"});
    EXPECT_EQ(contents("again"), contents("out"));
    fs::remove_all(path("again"));
  }
}

TEST_F(Run3d, that_takes_the_surface_of_a_frame_alone_says_what_it_leaves_behind) {
  const std::string soon = "[time]\nend = 0.0001\nframes = [0]\noutput = [0]\n";
  write("in.toml", ellipsoid + soon);
  must(into("first", "run"));
  write("in.toml",
        "model = \"SBEH\"\n[surface]\nshape = \"mesh\"\nfile = \"first/frames/0000.vtu\"\n" + soon);
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_TRUE(
      ended.err.starts_with("sbeh: first/frames/0000.vtu: has an order, which shape = \"mesh\" "
                            "does not take"))
      << ended.err;
}

TEST_F(Run3d, starts_from_a_frame_a_mesh_and_a_row_of_a_scan) {
  const std::string soon = "[time]\nend = 0.0001\nframes = [0, 0.0001]\noutput = [0, 0.0001]\n";
  write("in.toml", ellipsoid + soon);
  must(into("first", "run"));
  write(
      "frame.toml",
      "model = \"SBEH\"\n[surface]\nshape = \"frame\"\nfile = \"first/frames/0001.vtu\"\n" + soon);
  must(into("second", "run", "frame.toml"));
  EXPECT_NEAR(table("second/series.csv").number(0, "energy"),
              table("first/series.csv").number(1, "energy"),
              1e-11);  // area and volume are restored

  must({"mesh", "ellipsoid", "--reduced-volume", "0.8", "--triangles", "80", "--grading", "1", "-o",
        "mesh.vtu"});
  write("mesh.toml", "model = \"SBEH\"\n[surface]\nshape = \"mesh\"\nfile = \"mesh.vtu\"\n" + soon);
  must(into("third", "run", "mesh.toml"));
  EXPECT_NEAR(table("third/series.csv").number(0, "energy"),
              table("first/series.csv").number(0, "energy"), 1e-10);

  write("scan.toml", "[scan]\nreduced_volume = [0.8]\nL = [0.05]\nmodels = [\"SBEH\"]\n");
  must(into("scan", "scan", "scan.toml"));
  write("row.toml",
        "model = \"SBEH\"\n[surface]\nshape = \"scan\"\nfolder = \"scan\"\nreduced_volume = 0.8\n"
        "L = 0.05\ntriangles = 320\nperturbation = [[2, 2, 0.001]]\n"
            + soon);
  must(into("fourth", "run", "row.toml"));
  const double axisymmetric = table("scan/scan.csv").number(0, "energy");
  EXPECT_NEAR(table("fourth/series.csv").number(0, "energy"), axisymmetric,
              2e-4 * std::abs(axisymmetric));
}

TEST_F(Run3d, refuses_what_is_wrong_with_file_line_and_reason) {
  struct Case {
    std::string text, message;
  };
  const std::string time = "[time]\nend = 1\n";
  const std::string head = "model = \"SSH\"\n[surface]\n";
  const std::vector<Case> cases{
      {head + time, "in.toml:2: [surface] shape: missing; must be one of"},
      {head + "shape = \"elipsoid\"\n" + time, "in.toml:3: [surface] shape = \"elipsoid\""},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 1.2\n" + time,
       "in.toml:4: [surface] reduced_volume = 1.2"},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 0.8\ntriangles = 10\n" + time,
       "in.toml:5: [surface] triangles = 10"},
      {head + "shape = \"harmonics\"\nmodes = [[2, 3, 0.1]]\n" + time,
       "in.toml:4: [surface] modes"},
      {head + "shape = \"harmonics\"\nmodes = [[2, 0, 9.0]]\n" + time, "in.toml: [surface] r = "},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 0.01\n" + time,
       "in.toml: [surface] ellipsoid: reduced volume 0.01: must be >= "},
      {head + "shape = \"ellipsoid\"\naxes = [1, 1, 0.05]\ntriangles = 20\n" + time,
       "in.toml: [surface] the shape bends too sharply for "},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 0.8\nperturbation = [[2, 0, -3]]\n" + time,
       "in.toml: [surface] perturbation: is too large: the triangle at ("},
      {head + "shape = \"scan\"\nfolder = \"none\"\nreduced_volume = 0.8\nL = 0.05\n" + time,
       "none: is not there: neither from the folder of the input nor from "},
      {head + "shape = \"frame\"\nfile = \"plain.vtu\"\n" + time,
       "plain.vtu: is no frame of a run: it lacks the field order"},
      {head + "shape = \"mesh\"\nfile = \"none.obj\"\n" + time, "none.obj"},
      {head + "shape = \"frame\"\nfile = \"in.toml\"\n" + time, "in.toml: "},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 0.8\norder = 0.5\n" + time,
       "in.toml:5: [surface] order = 0.5"},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 0.8\n[numerics]\nelements = 3\n" + time,
       "in.toml:6: [numerics] elements"},
  };
  must({"mesh", "sphere", "--triangles", "80", "-o", "plain.vtu"});
  for (const Case& wrong : cases) {
    write("in.toml", wrong.text);
    must_refuse(into("out", "run"), wrong.message);
    must_refuse({"check", "in.toml"}, wrong.message);
    EXPECT_FALSE(exists(path("out"))) << wrong.message;
  }
  std::ofstream(path("open.obj"))
      << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  write("in.toml", head + "shape = \"mesh\"\nfile = \"open.obj\"\n" + time);
  must_refuse(into("out", "run"), "open.obj: ");
  std::string frame = read("plain.vtu");
  write("cut.vtu", frame.substr(0, frame.size() / 2));
  write("in.toml", head + "shape = \"frame\"\nfile = \"cut.vtu\"\n" + time);
  must_refuse(into("out", "run"), "cut.vtu: is cut off");
}

}  // namespace
}  // namespace sbeh::tools::test
