// Cross sections, and which states of an evolution a picture shows.
#include "tools/picture/section/cut.h"

#include "tools/picture/surface/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sbeh::picture {
namespace {

using std::numbers::pi;

// Half a circle around z = 3, its order growing from pole to pole.
axisym::State half_circle(int points) {
  axisym::State state{axisym::Nodes(2, points), axisym::Field(points)};
  for (int i = 0; i < points; ++i) {
    const double angle = pi * i / (points - 1);
    state.X.col(i) << std::sin(angle), 3 + std::cos(angle);
    state.beta[i] = i;
  }
  return state;
}

TEST(Cut, is_closed_and_centred) {
  const Cut cut = mirrored(half_circle(31));
  ASSERT_EQ(cut.points.size(), 61u);
  EXPECT_EQ(cut.points.front()[1], cut.points.back()[1]);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_NEAR(std::hypot(cut.points[i][0], cut.points[i][1]), 1, 1e-15);
    EXPECT_EQ(cut.points[i][0], -cut.points[60 - i][0]);
    EXPECT_EQ(cut.order[i], cut.order[60 - i]);
    EXPECT_EQ(cut.curvature[i], cut.curvature[60 - i]);
    EXPECT_NEAR(cut.curvature[i], -2, std::pow(pi / 10, 3));  // of cubics on ten elements
  }
  EXPECT_NEAR(cut.half_width, 1, 1e-15);
  EXPECT_NEAR(cut.half_height, 1, 1e-15);
}

TEST(Cut, thinned_keeps_some_of_its_points_their_order_and_its_ends) {
  const Cut cut = mirrored(half_circle(2002));
  const Cut thin = thinned(cut, 0.5);
  EXPECT_LT(thin.points.size(), cut.points.size() / 4);
  EXPECT_EQ(thin.points.front(), cut.points.front());
  EXPECT_EQ(thin.points.back(), cut.points.back());
  std::size_t at = 0;
  for (std::size_t k = 0; k < thin.points.size(); ++k, ++at) {
    while (at < cut.points.size() && cut.points[at] != thin.points[k]) ++at;
    ASSERT_LT(at, cut.points.size());
    EXPECT_EQ(cut.order[at], thin.order[k]);
    EXPECT_EQ(cut.curvature[at], thin.curvature[k]);
  }
}

// It turns by 0.04 between two points, or is 0.15 of the spacing long: so far is a chord from the circle.
TEST(Cut, thinned_does_not_leave_the_curve) {
  for (const double spacing : {0.02, 0.2}) {
    const Cut thin = thinned(mirrored(half_circle(4003)), spacing);
    const double turn = std::max(0.04, 0.15 * spacing) + 2 * pi / 8000;
    for (std::size_t k = 1; k < thin.points.size(); ++k) {
      const double x = (thin.points[k][0] + thin.points[k - 1][0]) / 2,
                   y = (thin.points[k][1] + thin.points[k - 1][1]) / 2;
      EXPECT_LE(1 - std::hypot(x, y), turn * turn / 8);
    }
  }
}

// SBEH's by their order; SSH's, whose order is uniform, by H; either way where the user says so.
TEST(Cut, is_coloured_by_its_order_unless_that_is_uniform) {
  const Cut ordered = mirrored(half_circle(31));
  Cut uniform = ordered;
  for (std::size_t i = 0; i < uniform.order.size(); ++i)
    uniform.order[i] = 2. / 3 + (i % 2 ? 1e-15 : 0);
  FieldRanges of_ordered, of_uniform;
  of_ordered.include(ordered);
  of_uniform.include(uniform);
  EXPECT_EQ(colours_for(of_ordered, {}).field, Field::order);
  EXPECT_EQ(colours_for(of_uniform, {}).field, Field::curvature);
  for (const Field field : {Field::order, Field::curvature}) {
    Options options;
    options.field = field;
    EXPECT_EQ(colours_for(of_ordered, options).field, field);
    EXPECT_EQ(colours_for(of_uniform, options).field, field);
  }
}

Colour colour_at(Palette palette, double share) {
  return ColourMap(palette, {2, 4})(2 + 2 * share);
}
double lightness(Colour c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

// So that they are told apart in grey; small values dark in all pictures.
TEST(Colours, get_lighter_with_the_value) {
  for (const Palette palette : values_of(Palette{}))
    for (double share = 0.05; share <= 1; share += 0.05)
      EXPECT_GT(lightness(colour_at(palette, share)), lightness(colour_at(palette, share - 0.05)))
          << name(palette) << share;
  const Colour bare = colour_at(order_palette, 0.3);
  const Colour on_surface = ColourMap(order_palette, {2, 4}, white_on_surfaces)(2.6);
  EXPECT_NEAR(on_surface.red, bare.red + white_on_surfaces * (255 - bare.red), 1.5);
}

TEST(Frames, that_are_shown_are_the_first_the_last_and_between_them_in_geometric_progression) {
  std::vector<studies::FrameEntry> frames{{0, "0"}};
  for (int i = 0; i <= 40; ++i) frames.push_back({std::pow(10., i / 10. - 3), std::to_string(i)});
  const auto chosen = chosen_frames(frames, 6);
  ASSERT_EQ(chosen.size(), 6u);
  const std::vector<double> times{0, 1e-3, 1e-2, 0.1, 1, 10};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(chosen[k].time, times[k], 1e-9) << k;
  EXPECT_EQ(chosen_frames(frames, 100).size(), frames.size());
}

TEST(Frames, that_are_shown_are_different_ones) {
  const std::vector<studies::FrameEntry> frames{
      {0, "a"}, {1, "b"}, {1.1, "c"}, {1.2, "d"}, {100, "e"}};
  const auto chosen = chosen_frames(frames, 4);
  ASSERT_EQ(chosen.size(), 4u);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_GT(chosen[k].time, chosen[k - 1].time);
  EXPECT_EQ(chosen.back().time, 100);
}

TEST(Frames, that_are_asked_for_are_the_nearest_each_once) {
  const std::vector<studies::FrameEntry> frames{{0, "a"}, {1, "b"}, {2, "c"}, {100, "d"}};
  const auto times = [&](const std::vector<double>& wanted) {
    std::vector<double> all;
    for (const auto& frame : nearest_frames(frames, wanted)) all.push_back(frame.time);
    return all;
  };
  EXPECT_EQ(times({0, 1, 100}), (std::vector<double>{0, 1, 100}));
  EXPECT_EQ(times({1e9, 0.4, -3, 0}), (std::vector<double>{0, 100}));
  EXPECT_EQ(times({1.4, 1.6}), (std::vector<double>{1, 2}));
  EXPECT_TRUE(times({}).empty());
  EXPECT_TRUE(nearest_frames({}, {1}).empty());
}

}  // namespace
}  // namespace sbeh::picture
