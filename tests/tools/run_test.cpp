// 3D runs as their user sees them: histories, files, interruption, kill -9, resumption.
#include "tests/tools/run_fixture.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string times =
    "[time]\nend = 0.1\noutput = {from = 0.01, to = 0.1, count = 10}\nframes = [0, 0.02, 0.05, "
    "0.1]\n";

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

// New triangles have no more of the first ones' symmetry than is kept.
TEST_F(Run3d, measures_on_new_triangles_the_symmetry_that_these_have) {
  write("in.toml",
        "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.7\ntriangles = "
        "180\nsymmetry = \"D2h\"\nkeep_symmetry = \"C2v\"\n[numerics]\nremesh = true\n"
        "most_triangles = 270\n[time]\nend = 2e-6\noutput = [0, 2e-6]\nframes = [0]\n");
  must(into("out", "run"));
  ASSERT_EQ(table("out/events.csv").text(0, "event"), "remeshed");
  const Table series = table("out/series.csv");
  const std::size_t last = series.rows.size() - 1;
  EXPECT_NE(series.text(last, "asymmetry"), "");
  EXPECT_LT(series.number(last, "asymmetry"), 1e-13);
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

TEST_F(Run3d, whose_energy_rises_says_by_how_much_and_when) {
  // So few triangles do not hold the rim of this oblate, next to its fold.
  write("in.toml",
        "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.6\n"
        "triangles = 80\n[material]\nL = 0.07\n[time]\nend = 1.5\nevery_step = true\n");
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_EQ(ended.exit_code, 1);
  const std::size_t from =
      ended.err.find("the energy by which steps are judged, which can only fall, rises by ");
  ASSERT_NE(from, std::string::npos) << ended.err;
  const std::string expected = ended.err.substr(from, ended.err.find('\n', from) - from);
  EXPECT_NE(expected.find(" in sum between t = "), std::string::npos) << expected;
  const Ended again = sbeh(resumed("out"));  // it is over, and says the same
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_NE(again.err.find(expected), std::string::npos) << again.err;
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

TEST_F(Run3d, whose_tables_are_lost_is_not_begun_anew_over_its_frames) {
  write("in.toml", ellipsoid + "[time]\nend = 0.002\nframes = [0, 0.001, 0.002]\n");
  must(into("out", "run"));
  for (const char* lost : {"series.csv", "frames.csv"}) {
    fs::copy(path("out"), path("part"), fs::copy_options::recursive);
    fs::remove(path("part") / lost);
    const Contents before = contents("part");
    must_refuse(
        resumed("part"),
        "part: no frame is there with its rows in series.csv and frames.csv; choose another");
    EXPECT_EQ(contents("part"), before) << lost;
    fs::remove_all(path("part"));
  }
  fs::remove_all(path("out/frames"));
  const Ended ended = sbeh(resumed("out"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_NE(ended.err.find("sbeh: out: no state is there yet: the run begins\n"),
            std::string::npos);
}

TEST_F(Run3d, is_not_overwritten_and_not_resumed_with_other_parameters) {
  const std::string short_times = "[time]\nend = 0.001\nframes = [0]\noutput = [0.001]\n";
  write("in.toml", ellipsoid + short_times);
  must(into("out", "run"));
  const Contents before = contents("out");
  must_refuse(into("out", "run"), "out: already holds a run (see its run.toml)");
  const std::string other = "out: holds a run with other parameters: ";
  std::string prolate = ellipsoid;
  prolate.replace(prolate.find("0.8"), 3, "0.9");
  const std::string ssh = "model = \"SSH\"" + ellipsoid.substr(ellipsoid.find('\n'));
  const std::vector<std::pair<std::string, std::string>> changes{
      {ellipsoid + short_times + "[material]\nL = 0.08\n",
       "material.L1: 0.05 there, 0.08 here; choose"},
      {ellipsoid + short_times + "[material]\nL = 0.08\nfriction_normal = 1\n",
       "material.L1: 0.05 there, 0.08 here; material.friction_normal: 0.1 there, 1 here; choose"},
      {ellipsoid + short_times + "[numerics]\ntolerance = 3e-5\n", "numerics.tolerance: "},
      {ellipsoid + short_times + "every_step = true\n", "time.every_step: false there, true here"},
      {ellipsoid + short_times + "stop_at_rest = false\n",
       "time.stop_at_rest: true there, false here"},
      {prolate + short_times, "surface.reduced_volume: 0.8 there, 0.9 here; choose"},
      {ellipsoid + "order = 0.5\n" + short_times,
       "surface.order: 0.6666666666666666 there, 0.5 here"},
      {ssh + short_times, "model: \"SBEH\" there, \"SSH\" here; surface.order: "},
      {ellipsoid + "perturbation = [[2, 2, 0.01]]\n" + short_times,
       "surface.perturbation: nothing there, [[2, 2, 0.01]] here"},
      {ellipsoid + "[time]\nend = 0.0005\nframes = [0]\noutput = [0]\n",
       "time.end: 0.001 there, 0.0005 here; a run may be lengthened, but not be shortened\n"},
  };
  for (const auto& [text, named] : changes) {
    write("in.toml", text);
    must_refuse(resumed("out"), other + named);
  }
  const std::string text = read("out/run.toml");
  write("out/run.toml", "# sbeh 9.9: " + text);
  write("in.toml", ellipsoid + short_times);
  must_refuse(resumed("out"), "out: holds a run of another version of sbeh");
  write("out/run.toml", text);
  EXPECT_EQ(contents("out"), before);
  fs::remove(path("out/run.toml"));
  for (const auto& arguments : {into("out", "run"), resumed("out")})
    must_refuse(arguments, "out: already holds a run, but without its run.toml");
  write("relax.toml",
        "model = \"SSH\"\ntime.end = 0.001\n[start]\nshape = \"ellipsoid\"\n"
        "reduced_volume = 0.8\n");
  must(into("relax", "relax", "relax.toml"));
  for (const auto& arguments : {into("relax", "run"), resumed("relax")})
    must_refuse(arguments, "relax: already holds other results than a run (see its run.toml)");
  write("in.toml", "[surface]\nshape = \"frame\"\nfile = \"out/frames/0000.vtu\"\n" + short_times);
  must_refuse(into("new", "relax"), "in.toml: is an input: for sbeh run in.toml");
}

TEST_F(Run3d, that_is_not_there_is_not_resumed) {
  write("in.toml", ellipsoid + times);
  const std::string nothing = ": there is nothing to resume; without --resume a run begins there\n";
  must_refuse(resumed("new"), "new" + nothing);
  EXPECT_FALSE(exists(path("new")));
  fs::create_directory(path("empty"));
  must_refuse(resumed("empty"), "empty" + nothing);
  EXPECT_EQ(contents("empty"), Contents{});
}

}  // namespace
}  // namespace sbeh::tools::test
