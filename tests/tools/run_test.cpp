// 3D runs as their user sees them: files, interruption, kill -9, resumption, wrong input.
#include "tests/tools/workplace.h"

#include <cmath>
#include <csignal>
#include <fstream>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string ellipsoid =
    "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\ntriangles = 80\n";
const std::string times =
    "[time]\nend = 0.1\noutput = {from = 0.01, to = 0.1, count = 10}\nframes = [0, 0.02, 0.05, "
    "0.1]\n";

class Run3d : public Workplace {
 protected:
  static std::vector<std::string> resumed(const std::string& results) {
    auto arguments = into(results, "run");
    arguments.emplace_back("--resume");
    return arguments;
  }
  /// Starts, and sends the signal when there are so many complete lines in frames.csv.
  void stop_with_frames(const std::string& results, int lines_of_frames, int signal) const {
    Program program(here(), into(results, "run"));
    ASSERT_TRUE(wait_until([&] {
      return lines(results + "/frames.csv") >= lines_of_frames || !program.is_running();
    }));
    ASSERT_TRUE(program.is_running()) << "ended before it could be stopped";
    program.send(signal);
    const Ended ended = program.wait();
    if (signal == SIGKILL) {
      EXPECT_EQ(ended.signal, SIGKILL);
    } else {
      EXPECT_EQ(ended.exit_code, 128 + signal) << ended.err;
      EXPECT_TRUE(ended.err.ends_with(
          "sbeh: interrupted; the same command with --resume goes on from here\n"));
      EXPECT_TRUE(exists(path(results + "/checkpoint.vtu")));
    }
  }
};

TEST_F(Run3d, leaves_a_history_frames_and_an_input_that_gives_the_same_again) {
  write("in.toml", ellipsoid + times);
  must(into("out", "run"));
  const Table series = table("out/series.csv");
  EXPECT_EQ(series.rows.size(), 10u);
  for (std::size_t row = 1; row < series.rows.size(); ++row)
    EXPECT_LT(series.number(row, "energy"), series.number(row - 1, "energy"));
  const Table frames = table("out/frames.csv");
  EXPECT_EQ(frames.numbers("time"), (std::vector<double>{0, 0.02, 0.05, 0.1}));
  const std::string pvd = read("out/run.pvd");
  for (std::size_t row = 0; row < frames.rows.size(); ++row) {
    EXPECT_TRUE(exists(path("out/" + frames.text(row, "file"))));
    EXPECT_NE(pvd.find(frames.text(row, "file")), std::string::npos);
  }
  fs::copy_file(path("out/run.toml"), path("again.toml"));
  must(into("again", "run", "again.toml"));
  EXPECT_EQ(contents("again"), contents("out"));
}

TEST_F(Run3d, may_leave_a_row_for_every_step) {
  write("in.toml", ellipsoid + "[time]\nend = 0.1\noutput = [0.05]\nevery_step = true\n");
  const Ended ended = sbeh(into("out", "run"));
  const Table series = table("out/series.csv");
  const std::size_t steps = series.rows.size() - 1;
  EXPECT_NE(ended.out.find("after " + std::to_string(steps) + " steps"), std::string::npos)
      << ended.out;
  const auto at = [&](std::size_t row, const char* column) { return series.number(row, column); };
  for (std::size_t row = 1; row <= steps; ++row) {
    EXPECT_NEAR(at(row, "time") - at(row - 1, "time"), at(row, "time_step"), 1e-15);
    const double dissipation = at(row, "dissipation_friction") + at(row, "dissipation_order")
                             + at(row, "dissipation_viscous");
    EXPECT_NEAR(at(row - 1, "energy") - at(row, "energy"),
                at(row, "energy_balance") * at(row, "time_step") * dissipation, 1e-13);
  }
}

TEST_F(Run3d, that_was_interrupted_or_killed_is_resumed_to_the_same_bits) {
  write("in.toml", ellipsoid + times);
  must(into("whole", "run"));
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const std::string out = "out" + std::to_string(signal);
    stop_with_frames(out, 2, signal);
    must(resumed(out));
    EXPECT_EQ(contents(out), contents("whole")) << signal;
  }
}

TEST_F(Run3d, with_new_triangles_logs_them_and_is_resumed_to_the_same_bits) {
  const std::string flat =
      "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.7\n"
      "triangles = 180\n[numerics]\nremesh = true\nmost_triangles = 270\n[time]\nend = 0.001\n"
      "output = {from = 0.0001, to = 0.001, count = 10}\nframes = {from = 0, to = 0.001, count = "
      "11}\n";
  write("in.toml", flat);
  const Ended ended = sbeh(into("whole", "run"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_NE(ended.err.find(" new triangles for 180, smallest angle "), std::string::npos)
      << ended.err;
  const Table events = table("whole/events.csv");
  ASSERT_FALSE(events.rows.empty());
  EXPECT_EQ(events.text(0, "event"), "remeshed");
  EXPECT_EQ(events.number(0, "triangles"), 180);
  EXPECT_GT(events.number(0, "curvature_gap"), 0.1);
  EXPECT_LT(std::abs(events.number(0, "energy_change")), 5e-3);
  stop_with_frames("out", 6, SIGKILL);
  must(resumed("out"));
  EXPECT_EQ(contents("out"), contents("whole"));
}

TEST_F(Run3d, whose_steps_are_too_large_ends_with_the_reason_and_its_last_state) {
  write("in.toml", ellipsoid
                       + "[numerics]\ntolerance = 1e-9\nfirst_step = 0.01\nsmallest_step = 0.005\n"
                         "[time]\nend = 0.1\nframes = [0]\noutput = [0]\n");
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(ended.out.starts_with("time step too small at t = 0 after 0 steps")) << ended.out;
  EXPECT_NE(ended.err.find("sbeh: the error of a step stays above the tolerance, however small: "),
            std::string::npos)
      << ended.err;
  EXPECT_EQ(table("out/series.csv").rows.size(), 1u);
  EXPECT_TRUE(exists(path("out/frames/0000.vtu")));
}

TEST_F(Run3d, whose_mesh_is_too_coarse_says_from_when) {
  write("in.toml",
        "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.65\n"
        "triangles = 180\n[time]\nend = 0.0002\nframes = [0]\noutput = [0.0002]\n");
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_NE(ended.err.find("sbeh: unresolved from t = 0: |B| times the node spacing "),
            std::string::npos)
      << ended.err;
  EXPECT_TRUE(ended.err.ends_with("what comes later is not to be trusted, see out/events.csv\n"))
      << ended.err;
  const Table events = table("out/events.csv");
  ASSERT_EQ(events.rows.size(), 1u);
  EXPECT_EQ(events.text(0, "event"), "unresolved");
  EXPECT_EQ(events.number(0, "time"), 0);
}

TEST_F(Run3d, goes_back_to_the_frame_before_a_damaged_one) {
  write("in.toml", ellipsoid + times);
  must(into("whole", "run"));
  stop_with_frames("out", 4, SIGKILL);
  fs::resize_file(path("out/frames/0002.vtu"), 1000);
  const Ended ended = sbeh(resumed("out"));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.err.find("0002.vtu"), std::string::npos);
  EXPECT_NE(ended.err.find("going back to the state before it"), std::string::npos);
  EXPECT_EQ(contents("out"), contents("whole"));
}

TEST_F(Run3d, is_not_overwritten_and_not_resumed_with_other_parameters) {
  write("in.toml", ellipsoid + "[time]\nend = 0.001\nframes = [0]\noutput = [0.001]\n");
  must(into("out", "run"));
  const Contents before = contents("out");
  must_refuse(into("out", "run"), "out: already holds a run (see its run.toml)");
  write("in.toml", ellipsoid + "[time]\nend = 0.002\nframes = [0]\noutput = [0.001]\n");
  must_refuse(resumed("out"), "out: holds a run with other parameters");
  std::string text = read("out/run.toml");
  write("out/run.toml", "# sbeh 9.9: " + text);
  write("in.toml", ellipsoid + "[time]\nend = 0.001\nframes = [0]\noutput = [0.001]\n");
  must_refuse(resumed("out"), "out: holds a run of another version of sbeh");
  write("out/run.toml", text);
  EXPECT_EQ(contents("out"), before);
  fs::remove(path("out/run.toml"));
  for (const auto& arguments : {into("out", "run"), resumed("out")})
    must_refuse(arguments, "out: already holds a run, but without its run.toml");
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

  must({"mesh", "ellipsoid", "--reduced-volume", "0.8", "--triangles", "80", "-o", "mesh.vtu"});
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
      {head + "shape = \"ellipsoid\"\naxes = [1, 1, 0.05]\ntriangles = 80\n" + time,
       "in.toml: [surface] the shape bends too sharply for "},
      {head + "shape = \"ellipsoid\"\nreduced_volume = 0.8\nperturbation = [[2, 0, -3]]\n" + time,
       "in.toml: [surface] perturbation: is too large: the curved triangles "},
      {head + "shape = \"scan\"\nfolder = \"none\"\nreduced_volume = 0.8\nL = 0.05\n" + time,
       "none/points/SSH_oblate_v0.8_L0.05.csv: is not there"},
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
