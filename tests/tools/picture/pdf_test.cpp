// A page of PDF from an SVG as VTK writes it. The page is read as its reader does it: by the table at its end.
#include "tools/picture/canvas/pdf.h"

#include "tools/picture/canvas/outlines.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace sbeh::picture {
namespace {

std::string svg_of(const std::string& drawing) {
  return "<?xml version=\"1.0\"?>\n<svg\n     width=\"200pt\" height=\"100pt\" viewBox=\"0 0 200 "
         "100\">\n<g>\n"
         "<polygon fill=\"#ffffff\" points=\"0,100 200,100 200,0\"/>\n"
       + drawing + "</g>\n</svg>\n";
}

// The objects by their number, found through the table of their places.
std::vector<std::string> objects_of(const std::string& pdf) {
  std::size_t table = 0, count = 0, zero = 0;
  std::istringstream(pdf.substr(pdf.rfind("startxref") + 9)) >> table;
  std::istringstream lines(pdf.substr(table));
  std::string word;
  lines >> word >> zero >> count;
  EXPECT_EQ(word, "xref");
  std::vector<std::string> objects;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t place = 0, generation = 0;
    lines >> place >> generation >> word;
    if (k == 0) continue;  // no object
    const std::string begin = fmt::format("{} 0 obj\n", k);
    EXPECT_EQ(pdf.compare(place, begin.size(), begin), 0) << k;
    objects.push_back(pdf.substr(place, pdf.find("\nendobj", place) - place));
  }
  return objects;
}

TEST(Pdf, is_a_page_of_the_width_that_was_asked_for) {
  for (const double width : {100., 243.78, 612.}) {
    const std::string pdf = pdf_of(
        svg_of(
            "<polyline fill=\"none\" stroke=\"#102030\" stroke-width=\"2\" points=\"1,2 3,4\"/>\n"),
        {}, width);
    EXPECT_TRUE(pdf.starts_with("%PDF-1.4\n"));
    EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
    const auto objects = objects_of(pdf);
    ASSERT_EQ(objects.size(), 4u);
    EXPECT_NE(pdf.find(fmt::format("/MediaBox [0 0 {:.2f} {:.2f}]", width, width / 2)),
              std::string::npos);
    const std::string& content = objects[0];
    std::size_t length = 0;
    std::istringstream(content.substr(content.find("/Length") + 7)) >> length;
    const std::size_t begin = content.find("stream\n") + 7;
    EXPECT_EQ(content.size() - begin - std::string("\nendstream").size(), length);
  }
}

TEST(Pdf, refuses_what_is_no_svg) { EXPECT_THROW(pdf_of("no SVG", {}, 100), std::runtime_error); }

// Of Latin and of what pictures have besides; the width is that of all letters.
TEST(Outlines, are_there_for_every_letter) {
  double sum = 0;
  std::string all;
  for (const char* letter :
       {"a", "V", "ᵣ", "β", "π", "κ", "−", "⁻", "⁵", "₂", "∫", "±", "…", "×", "∣"}) {
    const Outlines one = outlines_of(letter);
    EXPECT_NE(one.path.find(" m "), std::string::npos) << letter;
    EXPECT_GT(one.width, 0.1) << letter;
    sum += one.width;
    all += letter;
  }
  EXPECT_NEAR(outlines_of(all).width, sum, 1e-9);
  EXPECT_GT(outlines_of("i i").width, outlines_of("ii").width);
  EXPECT_EQ(outlines_of("").path, "");
}

// PDF does not know exponents.
TEST(Outlines, have_plain_numbers) {
  for (const char* text : {"0.0001", "β = 1e-7", "L = 3.8 · 10⁻⁴"}) {
    const std::string path = outlines_of(text).path;
    EXPECT_EQ(path.find_first_not_of("0123456789.- mlc"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace sbeh::picture
