// Pieces of a page: what is escaped, what is encoded, which rows are shown.
#include "studies/report/html.h"

#include "studies/report/svg_chart.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace sbeh::studies {
namespace {

TEST(Html, escapes_what_would_be_markup) {
  EXPECT_EQ(html::escaped("a<b> & \"c\" 'd' β"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39; β");
  EXPECT_EQ(html::escaped(std::string_view("a\0\x1b\n\tb", 6)), "a&#xfffd;&#xfffd;\n\tb");
  EXPECT_EQ(html::element("td", "<"), "<td>&lt;</td>\n");
}

// The test vectors of RFC 4648.
TEST(Html, encodes_bytes_in_base64) {
  for (const auto& [bytes, text] : {std::pair{"", ""},
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"}})
    EXPECT_EQ(html::base64(bytes), text);
  EXPECT_EQ(html::base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(Html, rounds_numbers_and_keeps_their_text) {
  EXPECT_EQ(html::value("0.12345678901234"), "<data value=\"0.12345678901234\">0.123456789</data>");
  EXPECT_EQ(html::value("nan"), "nan");
  EXPECT_EQ(html::value("1 < 2"), "1 &lt; 2");
  EXPECT_EQ(html::value(""), "");
}

TEST(Html, shows_a_long_table_with_its_first_and_last_row) {
  CsvTable table{.columns = {"k", "word"}, .rows = {}};
  for (int k = 0; k < 1000; ++k) table.rows.push_back({std::to_string(k), "w"});
  const std::string text = html::table(table, 10, "a<b.csv");
  for (const char* there : {"<th class=\"n\">k</th><th>word</th>", "<data value=\"0\">",
                            "<data value=\"999\">", "10 of 1000 rows", "a&lt;b.csv"})
    EXPECT_NE(text.find(there), std::string::npos) << there;
  std::size_t rows = 0;
  for (std::size_t at = text.find("<tr>"); at != std::string::npos; at = text.find("<tr>", at + 1))
    ++rows;
  EXPECT_EQ(rows, 11u);  // the header too
  EXPECT_EQ(html::table(table, 1000, "x").find("of 1000 rows"), std::string::npos);
}

// Rows of a scan: 2 L, 2 models at each of many reduced volumes, in the order they were finished.
CsvTable scan_rows(int volumes, int of_each) {
  CsvTable table{.columns = {"model", "reduced_volume", "k"}, .rows = {}};
  for (int k = 0; k < of_each; ++k)
    for (int v = 0; v < volumes; ++v)
      table.rows.push_back({"SSH", std::to_string(0.3 + 0.01 * v), std::to_string(k)});
  return table;
}

TEST(Html, shows_the_rows_of_a_reduced_volume_together_or_not_at_all) {
  struct Case {
    int volumes, of_each;
    std::size_t most;
  };
  for (const auto& [volumes, of_each, most] :
       {Case{50, 4, 30}, {13, 7, 20}, {3, 100, 250}, {40, 9, 9}, {2, 60, 50}, {5, 6, 200}}) {
    const std::string text = html::table(scan_rows(volumes, of_each), most, "scan.csv");
    const auto count = [&](const std::string& word) {
      std::size_t found = 0;
      for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++found;
      return found;
    };
    std::size_t all = 0, groups = 0;
    for (int v = 0; v < volumes; ++v) {
      const std::size_t rows = count(fmt::format("\"{}\"", std::to_string(0.3 + 0.01 * v)));
      EXPECT_TRUE(rows == 0 || rows == std::size_t(of_each)) << rows;
      all += rows;
      groups += rows > 0;
    }
    const bool fits = std::size_t(volumes) * std::size_t(of_each) <= most;
    EXPECT_EQ(groups, fits ? std::size_t(volumes) : most / std::size_t(of_each));
    EXPECT_LE(all, most);
    EXPECT_EQ(count("<a href=\"scan.csv\">"), fits ? 0u : 1u);  // where the others are
  }
}

TEST(Html, shows_rows_of_a_history_evenly_spread) {
  CsvTable series{.columns = {"time", "reduced_volume"}, .rows = {}};
  for (int row = 0; row < 500; ++row)  // kept to rounding
    series.rows.push_back({std::to_string(row), fmt::format("{}", 0.8 + 1e-13 * (row % 7))});
  EXPECT_NE(html::table(series, 100, "series.csv").find("100 of 500 rows, evenly spread"),
            std::string::npos);
}

TEST(Html, links_to_files_of_any_name) {
  EXPECT_EQ(html::link("points/a.csv"), "<a href=\"points/a.csv\">points/a.csv</a>");
  EXPECT_EQ(html::link("a b\"<%.csv"), "<a href=\"a%20b%22%3C%25.csv\">a b&quot;&lt;%.csv</a>");
}

TEST(Chart, names_its_axes) {
  const std::string text =
      svg_chart({.title = "Energy", .y_name = "U < 0"}, {{"one", {0, 1}, {2, 3}}});
  EXPECT_NE(text.find(">t</text>"), std::string::npos);
  EXPECT_NE(text.find(">U &lt; 0</text>"), std::string::npos);
}

TEST(Chart, leaves_out_what_an_axis_cannot_show) {
  constexpr auto log = AxisScale::logarithmic;
  const ChartFrame frame{.title = "a & b", .x = log, .y = log};
  EXPECT_EQ(svg_chart(frame, {}), "");
  EXPECT_EQ(svg_chart(frame, {{"one", {0, 1, 2}, {1, -1, 3}}}), "");
  const std::string text = svg_chart(frame, {{"one", {0, 1, 10, 20}, {1, 1, NAN, 3}}});
  EXPECT_NE(text.find("a &amp; b"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

TEST(Chart, leaves_out_lines_of_rounding_on_a_logarithmic_axis) {
  constexpr auto log = AxisScale::logarithmic;
  const std::vector<ChartLine> lines{{"large", {1, 2}, {1, 1e-10}},
                                     {"rounding", {1, 2}, {1e-28, 1e-30}}};
  const std::string text = svg_chart({.title = "c", .y = log}, lines);
  EXPECT_NE(text.find("large"), std::string::npos);
  EXPECT_NE(text.find("1e-10"), std::string::npos);
  EXPECT_EQ(text.find("rounding"), std::string::npos);
  EXPECT_EQ(text.find("1e-20"), std::string::npos);
  EXPECT_NE(svg_chart({.title = "c"}, lines).find("rounding"), std::string::npos);
}

// What is drawn of a chart: its ticks.
std::string labels_of(const std::string& chart) {
  std::string labels;
  for (std::size_t at = 0; (at = chart.find("fill=\"var(--soft)\">", at)) != std::string::npos;
       ++at) {
    const std::size_t begin = chart.find('>', at) + 1;
    labels += chart.substr(begin, chart.find('<', begin) - begin) + " ";
  }
  return labels;
}

TEST(Charts, of_one_kind_have_the_same_axes) {
  const ChartFrame energies{.title = "low", .y_name = "U"}, others{.title = "W", .y_name = "W"};
  const Chart low{energies, {{"U", {0, 1}, {2, 3}}}}, high{energies, {{"U", {0, 4}, {5, 7}}}},
      other{others, {{"W", {0, 1}, {0, 1e-3}}}}, empty{energies, {{"U", {100}, {100}}}};
  const std::string all = svg_charts({low, high, empty, other});
  const auto nth = [&](int n) {
    std::size_t begin = 0;
    for (int k = 0; k < n; ++k) begin = all.find("<figure", begin + 1);
    return all.substr(begin, all.find("</figure>", begin) - begin);
  };
  EXPECT_EQ(labels_of(nth(0)), labels_of(nth(1)));
  EXPECT_EQ(labels_of(nth(0)), "0 1 2 3 4 2 4 6 ");
  EXPECT_EQ(nth(2) + "</figure>\n", svg_chart(other.frame, other.lines));  // as it is alone
  EXPECT_NE(nth(0), svg_chart(low.frame, low.lines));
}

TEST(Chart, of_a_constant_has_ticks) {
  for (const double constant : {0., 2. / 3, -1e9, 1e-12}) {
    const std::string text = svg_chart({.title = "c"}, {{"c", {0, 1}, {constant, constant}}});
    EXPECT_NE(text.find("text-anchor=\"end\""), std::string::npos) << constant;
    EXPECT_LT(text.size(), 5000u) << constant;
  }
}

}  // namespace
}  // namespace sbeh::studies
