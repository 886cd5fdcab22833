// `sbeh figures` with small inputs: what it leaves, that nothing is run twice, and what it refuses.
#include "tests/tools/workplace.h"

#include <csignal>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

std::string run_of(const std::string& model, const std::string& start, const std::string& time) {
  return "model = \"" + model + "\"\n[surface]\ntriangles = 20\n" + start
       + "[material]\nL = 0.05\n[numerics]\ntolerance = 0.01\n[time]\n" + time;
}
const std::string sphere = "shape = \"harmonics\"\nmodes = [[5, 3, 0.05]]\n";
const std::string short_time = "end = 0.001\noutput = [0, 0.0005, 0.001]\nframes = [0]\n";

class Figures : public Workplace {
 protected:
  Figures() {
    write("in/paper_flow.toml",
          "[scan]\nreduced_volume = [0.9]\nL = [0.04, 0.05]\nmethod = \"flow\"\n"
          "[numerics]\nelements = 16\n");
    write("in/paper_oblate_3d.toml",
          run_of("SBEH", "shape = \"ellipsoid\"\nreduced_volume = 0.7\n", short_time));
    write("in/y53.toml", run_of("SSH", sphere, short_time));
    write("in/y53_ordered.toml", run_of("SBEH", sphere, short_time));
  }
  static std::vector<std::string> figures(std::vector<std::string> more) {
    std::vector<std::string> arguments{"figures", "-o", "out", "--inputs", "in"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

TEST_F(Figures, of_the_shapes_leaves_runs_and_tables_and_runs_nothing_twice) {
  must(figures({"shapes", "--no-pictures"}));
  const Table shapes = table("out/shapes.csv");
  ASSERT_EQ(shapes.rows.size(), 2u);
  for (std::size_t row : {0u, 1u}) {
    EXPECT_EQ(shapes.number(row, "reduced_volume"), 0.9);
    EXPECT_EQ(shapes.text(row, "ending"), "end time reached at t = 0.001");
    EXPECT_TRUE(fs::exists(path("out/" + shapes.text(row, "frame"))));
  }
  EXPECT_EQ(table("out/run_times.csv").rows.size(), 2u);
  const Table found = table("out/figures.csv");
  EXPECT_EQ(found.columns, (std::vector<std::string>{"figure", "command", "seconds", "result",
                                                     "paper", "agreement"}));
  ASSERT_FALSE(found.rows.empty());
  for (std::size_t row = 0; row < found.rows.size(); ++row)
    EXPECT_EQ(found.text(row, "figure"), "2");

  const Contents before = contents("out");
  const Ended again = sbeh(figures({"2", "--no-pictures"}));
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(contents("out"), before);
}

// Points of the cuts lie on the shapes: as wide and high as these are.
TEST_F(Figures, of_the_shapes_has_cuts_through_the_3d_surfaces) {
  must(figures({"shapes", "--no-pictures"}));
  const Table cuts = table("out/cuts.csv");
  double width = 0;
  int in_3d = 0;
  for (std::size_t row = 0; row < cuts.rows.size(); ++row)
    if (cuts.text(row, "solver") == "3D") {
      ++in_3d;
      width = std::max(width, cuts.number(row, "x"));
    }
  EXPECT_GT(in_3d, 100);
  double axisymmetric = 0;
  for (std::size_t row = 0; row < cuts.rows.size(); ++row)
    if (cuts.text(row, "solver") == "axisymmetric")
      axisymmetric = std::max(axisymmetric, cuts.number(row, "x"));
  EXPECT_NEAR(width, axisymmetric, 0.05);  // one at the start nearly, the other at rest
}

TEST_F(Figures, goes_on_after_an_interruption) {
  write("in/y53.toml", run_of("SSH", sphere,
                              "end = 0.02\nstop_at_rest = false\nframes = [0, 0.02]\n"
                              "output = {from = 0.0001, to = 0.02, count = 200}\n"));
  Program program(here(), figures({"measures", "--no-pictures"}));
  ASSERT_TRUE(wait_until(
      [&] { return lines("out/evolution/SSH/series.csv") > 20 || !program.is_running(); }));
  program.send(SIGINT);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_TRUE(ended.err.ends_with("sbeh: interrupted; the same command goes on from here\n"))
      << ended.err;
  EXPECT_FALSE(fs::exists(path("out/measures.csv")));
  const std::string begun = read("out/evolution/SSH/series.csv");

  const Ended some = sbeh(figures({"measures", "--draw-only", "--no-pictures"}));
  EXPECT_EQ(some.exit_code, 0) << some.err;
  EXPECT_NE(some.err.find("figure 4 (measures) lacks evolution/SSH: not finished"),
            std::string::npos)
      << some.err;
  EXPECT_EQ(read("out/evolution/SSH/series.csv"), begun);
  EXPECT_NE(some.out.find("SSH: its run is not finished"), std::string::npos) << some.out;
  EXPECT_EQ(some.out.find("SBEH: its run is not finished"), std::string::npos) << some.out;

  must(figures({"measures", "--no-pictures"}));
  EXPECT_TRUE(read("out/evolution/SSH/series.csv").starts_with(begun));
  EXPECT_EQ(table("out/evolution/SSH/series.csv").numbers("time").back(), 0.02);
  EXPECT_EQ(table("out/run_times.csv").rows.size(), 3u);  // SBEH, and SSH in two parts
}

TEST_F(Figures, takes_runs_that_were_put_there_and_refuses_other_ones) {
  write("mine.toml", run_of("SSH", sphere, "end = 0.002\noutput = [0, 0.002]\nframes = [0]\n"));
  must(into("out/evolution/SSH", "run", "mine.toml"));
  const Contents mine = contents("out/evolution/SSH");
  must(figures({"evolution", "--no-pictures"}));
  EXPECT_EQ(contents("out/evolution/SSH"), mine);
  EXPECT_EQ(table("out/run_times.csv").rows.size(), 1u);  // of SBEH

  must_refuse(figures({"evolution", "--triangles", "80", "--no-pictures"}),
              "out/evolution/SBEH: holds another run: its number of triangles is 20, that of the "
              "figure is 80");
  write("in/y53_ordered.toml",
        run_of("SBEH", "shape = \"harmonics\"\nmodes = [[5, 3, 0.06]]\n", short_time));
  must_refuse(figures({"evolution", "--no-pictures"}),
              "out/evolution/SBEH: holds another run: its start is a sphere with modes [5, 3, 0.05]"
              ", that of the figure is a sphere with modes [5, 3, 0.06]");
}

TEST_F(Figures, refuses_what_it_does_not_know) {
  must_refuse(figures({"shape"}), "shape: unknown figure. Known: energy (1), shapes (2)");
  must_refuse(figures({"--draw-only"}), "out: no such folder: there is nothing to draw");
  must_refuse({"figures", "-o", "out", "--inputs", "nowhere"}, "nowhere: no such folder");
  write("in/y53.toml", run_of("SBEH", sphere, short_time));
  must_refuse(figures({"measures"}), "in/y53.toml: must have model = \"SSH\"");
  EXPECT_FALSE(fs::exists(path("out")));
  EXPECT_EQ(sbeh(figures({"--triangles", "3"})).exit_code, 2);
}

// One of two runs has broken off; both are missing.
TEST_F(Figures, says_which_shapes_are_missing_and_draws_the_others) {
  must(figures({"shapes", "--no-pictures"}));
  fs::remove_all(path("out/oblates_3d/SBEH_v0.9_L0.05"));
  const Ended one = sbeh(figures({"shapes", "--draw-only"}));
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.err.find("figure 2 (shapes) lacks oblates_3d/SBEH_v0.9_L0.05"), std::string::npos)
      << one.err;
  EXPECT_NE(one.out.find("shapes: 1 of 2 are drawn in 3D"), std::string::npos) << one.out;
  const Table shapes = table("out/shapes.csv");
  EXPECT_EQ(shapes.text(0, "lacks_3d"), "");
  EXPECT_EQ(shapes.text(1, "lacks_3d"), "not begun");
  fs::remove_all(path("out/oblates_3d"));
  const Ended none = sbeh(figures({"shapes", "--draw-only"}));
  EXPECT_NE(none.out.find("shapes: 0 of 2 are drawn in 3D"), std::string::npos) << none.out;
}

// Width and height of a PNG, which follow its signature and the name of the first chunk.
std::pair<int, int> size_of_png(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t k = at; k < at + 4; ++k) value = 256 * value + (unsigned char)png.at(k);
    return value;
  };
  return {number(16), number(20)};
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++found;
  return found;
}

TEST_F(Figures, draws_all_four) {
  must(figures({}));
  EXPECT_EQ(table("out/run_times.csv").rows.size(), 4u);  // two oblates, two evolutions, none twice
  for (const char* name : {"energy", "shapes", "evolution", "measures"}) {
    const std::string stem = std::string("out/") + name;
    const auto [width, height] = size_of_png(read(stem + ".png"));
    EXPECT_GE(width, 800) << name;
    EXPECT_GE(height, 400) << name;
    EXPECT_GT(count(read(stem + ".svg"), "<poly"), 20u) << name;
  }
  // A picture in space per shape: two oblates; the start of either model.
  EXPECT_EQ(count(read("out/shapes.svg"), "<image "), 2u);
  EXPECT_EQ(count(read("out/evolution.svg"), "<image "), 2u);
  EXPECT_EQ(count(read("out/energy.svg"), "<image "), 0u);
}

}  // namespace
}  // namespace sbeh::tools::test
