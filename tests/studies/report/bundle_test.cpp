// What a live page is given: numbers in 16 bits and back, the order of their bytes, and the packing of all.
#include "studies/report/bundle.h"

#include "studies/report/packed_fields.h"
#include "studies/report/packed_film.h"

#include <gtest/gtest.h>
#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace sbeh::studies {
namespace {

double back(std::uint16_t number, const NumberRange& range) {
  return range.low + (range.high - range.low) * number / 65534;
}

TEST(Bundle, numbers_in_16_bits_are_off_by_half_a_step_at_most) {
  NumberRange range;
  for (const double value : {0.3, -2.5, 7.25}) range.include(value);
  EXPECT_EQ(range.low, -2.5);
  EXPECT_EQ(range.high, 7.25);
  const double half_step = 0.5 * 9.75 / 65534;
  for (int k = 0; k <= 1000; ++k) {
    const double value = -2.5 + 9.75 * k / 1000;
    EXPECT_NEAR(back(quantised(value, range), range), value, half_step * (1 + 1e-9));
  }
  EXPECT_EQ(back(quantised(-2.5, range), range), -2.5);
  EXPECT_EQ(back(quantised(7.25, range), range), 7.25);
}

TEST(Bundle, what_is_not_finite_is_not_known_and_widens_no_range) {
  NumberRange range;
  range.include(NAN);
  range.include(INFINITY);
  EXPECT_TRUE(range.empty);
  range.include(3);
  EXPECT_EQ(range.low, 3);
  EXPECT_EQ(range.high, 3);
  EXPECT_EQ(quantised(NAN, range), quantised_unknown);
  EXPECT_EQ(quantised(-INFINITY, range), quantised_unknown);
  EXPECT_EQ(back(quantised(3, range), range), 3);
}

TEST(Bundle, differences_summed_again_are_the_numbers) {
  const std::vector<std::uint16_t> numbers{5, 65535, 0, 3, 65534, 1, 40000};
  for (const std::size_t stride : {std::size_t(1), std::size_t(3), numbers.size()}) {
    std::vector<std::uint16_t> summed = differences(numbers, stride);
    for (std::size_t k = stride; k < summed.size(); ++k)
      summed[k] = std::uint16_t(summed[k] + summed[k - stride]);
    EXPECT_EQ(summed, numbers) << stride;
  }
}

// The bytes within the element, whose number is known.
std::string unpacked(const std::string& element, std::size_t size) {
  const std::size_t from = element.find('>') + 1, to = element.find("</script>");
  std::string packed(to - from, '\0'), bytes(size, '\0');
  packed.resize(vtkBase64Utilities::DecodeSafely(
      reinterpret_cast<const unsigned char*>(element.data()) + from, to - from,
      reinterpret_cast<unsigned char*>(packed.data()), packed.size()));
  vtkNew<vtkZLibDataCompressor> zlib;
  bytes.resize(zlib->Uncompress(reinterpret_cast<const unsigned char*>(packed.data()),
                                packed.size(), reinterpret_cast<unsigned char*>(bytes.data()),
                                bytes.size()));
  return bytes;
}

TEST(FilmRoom, is_for_all_frames_where_they_fit_and_for_modes_in_what_they_leave) {
  const auto expect_room = [](std::size_t frames, std::size_t of_frame, std::size_t of_mode) {
    const FilmRoom room = film_room(frames, of_frame, of_mode);
    const std::size_t all = room.frames * (of_frame + room.modes * of_mode);
    EXPECT_LE(all, most_film_numbers);
    EXPECT_GT(all + room.frames * of_mode, most_film_numbers);  // no room for one mode more of each
    return room;
  };
  EXPECT_EQ(expect_room(60, 5 * 1442, 2 * 1442).frames, 60u);
  EXPECT_GE(expect_room(60, 5 * 1442, 2 * 1442).modes, 50u);
  EXPECT_EQ(expect_room(10'000, 5 * 1442, 2 * 1442).frames, most_film_numbers / (5 * 1442));
  EXPECT_EQ(film_room(3, most_film_numbers / 3, 1).modes, 0u);
  EXPECT_EQ(film_room(3, 2 * most_film_numbers, 1).frames, 1u);
  EXPECT_EQ(film_room(3, 2 * most_film_numbers, 1).modes, 0u);
  EXPECT_EQ(film_room(0, 5, 2).frames, 0u);
}

TEST(Evenly, chooses_the_first_the_last_and_between_them_at_equal_steps) {
  std::vector<int> all(101);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(evenly(all, 5), (std::vector{0, 25, 50, 75, 100}));
  EXPECT_EQ(evenly(all, 2), (std::vector{0, 100}));
  EXPECT_EQ(evenly(all, 1), (std::vector{0}));
  EXPECT_EQ(evenly(all, 101), all);
  EXPECT_EQ(evenly(all, 1000), all);
}

TEST(Bundle, has_an_index_and_the_parts_by_their_bytes) {
  Bundle bundle;
  bundle.add("a.csv", "x,y\n1,2\n");
  bundle.add("b", std::vector<std::uint16_t>{0x0102, 0x0304});
  bundle.add("c", std::vector<std::uint32_t>{0x01020304});
  const std::string expected =
      "name,type,bytes\na.csv,text,8\nb,u16,4\nc,u32,4\n\nx,y\n1,"
      "2\n\x02\x04\x01\x03\x04\x03\x02\x01";
  EXPECT_EQ(unpacked(bundle.element(), expected.size()), expected);
}

}  // namespace
}  // namespace sbeh::studies
