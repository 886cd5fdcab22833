// Pictures as files: in the size and format that were asked for, or refused.
#include "studies/scan/scan_table.h"
#include "tests/tools/workplace.h"

#include <fstream>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

class Picture : public Workplace {
 protected:
  void make_scan() const {
    write("in.toml",
          "[scan]\nreduced_volume = [0.6, 0.65, 0.7, 0.75, 0.8, 0.85]\n"
          "L = [0.01, 0.03, 0.05, 0.06, 0.07, 0.08]\n[numerics]\nelements = 16\n");
    must(into("out", "scan"));
  }
  // Width and height, which follow the signature and the name of the first chunk.
  std::pair<int, int> size_of(const std::string& png) const {
    const std::string bytes = read(png);
    const auto number = [&](std::size_t at) {
      int value = 0;
      for (std::size_t k = at; k < at + 4; ++k) value = 256 * value + (unsigned char)bytes.at(k);
      return value;
    };
    return {number(16), number(20)};
  }
  void refuse(const std::vector<std::string>& arguments, const std::string& reason) const {
    const Ended ended = sbeh(arguments);
    EXPECT_EQ(ended.exit_code, 2) << ended.err;
    EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
    EXPECT_EQ(ended.out, "");
  }
  std::vector<std::string> diagram(std::vector<std::string> more) const {
    std::vector<std::string> all{"picture", "scan", "out", "--only", "diagram"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(Picture, has_the_size_that_was_asked_for_or_is_refused) {
  make_scan();
  must(diagram({"--size", "1500x700"}));
  EXPECT_EQ(size_of("out/diagram.png"), std::pair(1500, 700));
  const Contents before = contents("out");
  for (const char* size : {"300x300", "320x300"})
    refuse(diagram({"--size", size}), "choose a larger size, or less to show");
  refuse(diagram({"--size", "30x30"}), "--size 30x30: give width and height in pixels");
  EXPECT_TRUE(contents("out") == before);
  must(diagram({"--size", "400x400", "--panels", "order"}));  // less to show
}

TEST_F(Picture, for_paper_has_its_width_and_format) {
  make_scan();
  must(diagram({"--width", "86mm", "--panels", "order", "--format", "pdf,svg,png"}));
  EXPECT_NE(read("out/diagram.pdf").find("/MediaBox [0 0 243.78 "), std::string::npos);
  EXPECT_NE(read("out/diagram.svg").find("width=\"86mm\""), std::string::npos);
  EXPECT_EQ(size_of("out/diagram.png").first, 1016);  // 300 dots per inch
  must(diagram({"--width", "180mm", "--height", "70mm", "--format", "pdf"}));
  EXPECT_NE(read("out/diagram.pdf").find("/MediaBox [0 0 510.2"), std::string::npos);
  for (const fs::directory_entry& entry : fs::directory_iterator(path("out")))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".diagram")) << entry.path();
  refuse(diagram({"--width", "86"}), "--width 86: give a length with mm, cm or in");
  refuse(diagram({"--format", "jpg"}), "--format");
  refuse(diagram({"--height", "86mm"}), "--width");
}

TEST_F(Picture, for_a_column_of_a_journal_has_its_panels_below_each_other) {
  make_scan();
  must(diagram({"--width", "86mm"}));
  EXPECT_EQ(size_of("out/diagram.png").first, 1016);
  const std::string narrow = read("out/diagram.svg");
  for (const char* title : {"energy gap", "smallest order", "largest"})
    EXPECT_NE(narrow.find(title), std::string::npos) << title;
  const auto [width, height] = size_of("out/diagram.png");
  must(diagram({"--width", "180mm"}));
  EXPECT_LT(size_of("out/diagram.png").second, height);
  must(diagram({"--width", "86mm", "--height", "200mm"}));
  EXPECT_EQ(size_of("out/diagram.png"), std::pair(1016, 2362));
  must({"picture", "scan", "out", "--only", "cuts", "--width", "86mm"});
  write("in.toml",
        "[scan]\nreduced_volume = [0.6, 0.65, 0.7, 0.75]\nL = 0.01\n[numerics]\nelements = 16\n");
  must(into("line", "scan"));
  for (const char* picture : {"diagram", "cuts"})
    must({"picture", "scan", "line", "--only", picture, "--width", "86mm"});
}

// SSH's oblates give way to m = 2 above V_r = 0.7497.
TEST_F(Picture, of_one_parameter_marks_what_is_no_minimum_in_3D) {
  const auto dots = [&](const std::string& folder, const std::string& volumes) {
    write("in.toml", "[scan]\nreduced_volume = " + volumes
                         + "\nL = 0.05\nmodels = ['SSH']\n[numerics]\nelements = 16\n");
    must(into(folder, "scan"));
    must({"picture", "scan", folder, "--only", "diagram", "--format", "svg"});
    const std::string svg = read(folder + "/diagram.svg"), white = "fill=\"rgb(255,255,255)\"";
    int count = 0;
    for (std::size_t at = svg.find(white); at != std::string::npos; at = svg.find(white, at + 1))
      ++count;
    EXPECT_NE(svg.find("energy"), std::string::npos);
    EXPECT_EQ(svg.find("no minimum in 3D") != std::string::npos, count > 0);
    return count;
  };
  EXPECT_EQ(dots("minima", "[0.65, 0.7, 0.74]"), 0);
  EXPECT_EQ(dots("both", "[0.65, 0.7, 0.74, 0.76, 0.8, 0.85]"),
            2 * 3 + 1);  // of two panels, and the legend
}

TEST_F(Picture, of_histories_for_a_column_has_its_panels_below_each_other) {
  write("in.toml",
        "[scan]\nreduced_volume = [0.85, 0.9, 0.95]\nL = 0.05\nmethod = \"flow\"\n"
        "models = [\"SSH\"]\n[numerics]\nelements = 8\n");
  must(into("out", "scan"));
  const auto height_of = [&](const char* width) {
    must({"picture", "scan", "out", "--only", "energy", "--width", width});
    return double(size_of("out/energy.png").second) / size_of("out/energy.png").first;
  };
  EXPECT_GT(height_of("86mm"), 1.5 * height_of("180mm"));
}

// Of a sphere with a small mode the energy falls by less than a line is wide.
TEST_F(Picture, of_an_energy_shows_how_it_falls) {
  write("in.toml",
        "model = \"SSH\"\n[start]\nshape = \"harmonics\"\nmodes = [[3, 0.01]]\n[time]\nend = 0.1\n"
        "[numerics]\nelements = 16\n");
  must(into("out", "relax"));
  must({"picture", "relax", "out", "--only", "energy"});
  EXPECT_NE(read("out/energy.svg").find("total above its least"), std::string::npos);
  must({"picture", "relax", "out", "--only", "energy", "--width", "86mm"});
}

TEST_F(Picture, of_modes_marks_the_unstable_and_fits_into_a_column) {
  must({"modes", "--model", "SSH", "--reduced-volume", "0.8", "--L", "0.05", "--largest-m", "3",
        "-o", "out", "--no-pictures"});
  must({"picture", "modes", "out"});
  const std::string profiles = read("out/profiles.svg");
  EXPECT_NE(profiles.find("m = 2, even, unstable<"), std::string::npos);
  EXPECT_EQ(profiles.find("m = 3, even, unstable<"), std::string::npos);
  must({"picture", "modes", "out", "--width", "86mm", "--format", "png"});
  for (const std::string picture : {"profiles", "surfaces"}) {
    const auto [width, height] = size_of("out/" + picture + ".png");
    EXPECT_EQ(width, 1016);
    EXPECT_LT(height, 2.5 * width) << picture;
  }
}

TEST_F(Picture, of_slender_modes_fits_onto_a_page) {
  must({"modes", "--model", "SSH", "--branch", "prolate", "--reduced-volume", "0.6", "--L", "0.05",
        "--largest-m", "2", "-o", "out", "--no-pictures"});
  must({"picture", "modes", "out", "--only", "profiles", "--width", "86mm", "--format", "png"});
  const auto [width, height] = size_of("out/profiles.png");
  EXPECT_LT(height, 2.5 * width);
}

TEST_F(Picture, is_the_same_in_one_format_as_in_several) {
  write("in.toml",
        "[scan]\nreduced_volume = [0.7, 0.75, 0.8]\nL = 1e-4\nmodels = [\"SBEH\"]\n"
        "[numerics]\nelements = 16\n");
  must(into("out", "scan"));
  must(diagram({"--format", "png"}));  // orders that differ by 1e-6: VTK shifts them first
  const std::string alone = read("out/diagram.png");
  must(diagram({"--format", "svg,png,pdf"}));
  EXPECT_TRUE(read("out/diagram.png") == alone);
}

TEST_F(Picture, shows_the_panels_colours_and_scale_that_were_asked_for) {
  make_scan();
  must(diagram({"--panels", "order"}));
  const std::string order = read("out/diagram.svg");
  must(diagram({"--panels", "order", "--scale", "0,1"}));
  EXPECT_TRUE(read("out/diagram.svg") != order);
  must(diagram({"--panels", "curvature,energy,gap", "--colours", "grey"}));
  const std::string three = read("out/diagram.svg");
  const std::size_t curvature = three.find("largest"), gap = three.find("energy gap");
  EXPECT_TRUE(curvature != std::string::npos && gap != std::string::npos);
  EXPECT_EQ(three.find("smallest order"), std::string::npos);
  refuse(diagram({"--panels", "mass"}), "--panels");
  refuse(diagram({"--panels", "lowest"}), "--panels lowest: the scan has one branch alone");
  refuse(diagram({"--scale", "0,1"}), "--scale is that of one quantity: choose it by --panels");
}

TEST_F(Picture, of_an_evolution_shows_the_frames_that_were_asked_for) {
  write("in.toml",
        "model = \"SSH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n[time]\nend = 0.1\n"
        "profiles = [0, 0.001, 0.01, 0.1]\n[numerics]\nelements = 16\n");
  must(into("out", "relax"));
  must({"picture", "relax", "out"});
  const std::string all = read("out/shapes.svg");
  EXPECT_NE(all.find("t = 0.001<"), std::string::npos);
  EXPECT_NE(all.find("mean curvature"), std::string::npos);  // the order of SSH is uniform
  must({"picture", "relax", "out", "--only", "shapes", "--frames", "0,0.09"});
  const std::string two = read("out/shapes.svg");
  EXPECT_EQ(two.find("t = 0.001<"), std::string::npos);
  EXPECT_NE(two.find("t = 0.1<"), std::string::npos);
  must({"picture", "relax", "out", "--only", "shapes", "--field", "order"});
  EXPECT_EQ(read("out/shapes.svg").find("mean curvature"), std::string::npos);
}

}  // namespace
}  // namespace sbeh::tools::test
