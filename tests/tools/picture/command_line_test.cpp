// What the options of pictures mean, and what is refused.
#include "tools/picture/command_line.h"

#include <gtest/gtest.h>

namespace sbeh::picture {
namespace {

TEST(Lengths, have_a_unit_and_are_those_of_paper) {
  for (const char* text : {"86mm", "8.6cm", "86.0mm"})
    EXPECT_NEAR(parse_length("--width", text), 86, 1e-12) << text;
  EXPECT_NEAR(parse_length("--width", "3.375in"), 85.725, 1e-12);
  for (const char* text : {"86", "mm", "", "86 mm", "8,6cm", "-86mm", "5mm", "2000mm", "86px",
                           "nanmm", "1e9mm", "86mmm"})
    EXPECT_THROW(parse_length("--width", text), InputError) << text;
}

TEST(Scales, have_two_ends_in_order) {
  EXPECT_EQ(parse_scale("0.4,0.67"), (Range{0.4, 0.67}));
  EXPECT_EQ(parse_scale("-3,1e2"), (Range{-3, 100}));
  for (const char* text : {"0.4", "0.67,0.4", "1,1", "1,2,3", "a,b", "", ",", "1,", "1;2", "nan,1"})
    EXPECT_THROW(parse_scale(text), InputError) << text;
}

TEST(Sizes, are_two_numbers_of_pixels) {
  EXPECT_EQ(parse_size("1600x1200").width, 1600);
  EXPECT_EQ(parse_size("1600x1200").height, 1200);
  for (const char* text :
       {"1600", "1600x", "x1200", "100x1200", "1600x9000", "1600x1200x3", "-1x500"})
    EXPECT_THROW(parse_size(text), InputError) << text;
}

TEST(Views, are_a_name_or_a_direction) {
  EXPECT_EQ(parse_view("side").from, side_view.from);
  EXPECT_EQ(parse_view("top").up, top_view.up);
  EXPECT_EQ(parse_view("1,-1,0.5").from, Eigen::Vector3d(1, -1, 0.5));
  for (const char* along_z : {"0,0,1", "0,0,-2"}) {
    const View view = parse_view(along_z);
    EXPECT_EQ(view.from.dot(view.up), 0) << along_z;  // what is up cannot be towards the eye
  }
  for (const char* text : {"front", "0,0,0", "1,2", "1,2,3,4", "", "1, 2, 3"})
    EXPECT_THROW(parse_view(text), InputError) << text;
}

// Letters of eight points, and all else in proportion to them.
TEST(OnPaper, letters_have_one_size_at_any_width) {
  Options narrow, wide;
  narrow.width_mm = 86;
  wide.width_mm = 180;
  EXPECT_EQ(narrow.text_size(), wide.text_size());
  const double points = narrow.text_size() / (narrow.width(0) / (86 / 25.4 * 72));
  EXPECT_NEAR(points, 8, 1e-9);
  EXPECT_NEAR(narrow.unit(), narrow.text_size() / Options().text_size(), 1e-12);
  EXPECT_EQ(Options().unit(), 1);
}

}  // namespace
}  // namespace sbeh::picture
