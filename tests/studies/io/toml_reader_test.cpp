// The TOML reader: what it accepts, and with which words it refuses the rest.
#include "studies/io/toml_reader.h"

#include "studies/io/spelling.h"
#include "studies/scan/scan_input.h"
#include "tests/studies/parameters/input_file.h"

#include <random>

namespace sbeh::studies {
namespace {

using namespace test;

std::vector<double> grid_of(const std::string& value) {
  return TomlFile::parse(written("g = " + value + "\n")).grid("g");
}

// ---- files --------------------------------------------------------------------------------------

TEST(TomlFile, that_cannot_be_read_is_refused_with_the_reason) {
  const auto parse = [](const auto& path) { TomlFile::parse(path); };
  EXPECT_EQ(message_for(parse, path_of("missing.toml")),
            ": cannot be read: No such file or directory");
  EXPECT_EQ(message_for(parse, path_of("")), ": is a directory, not a file");
  EXPECT_EQ(message_for(parse, written("") / "x.toml"), ": cannot be read: Not a directory");
  EXPECT_EQ(message_for(parse, written(std::string(1 << 21, '#'))),
            ": is too long for an input, more than 1048576 bytes");
}

TEST(TomlFile, with_a_syntax_error_is_refused_with_its_line) {
  const auto parse = [](const auto& path) { TomlFile::parse(path); };
  for (const std::string bad :
       {"L = ", "L = [1, 2", "L 3", "L = 1\nL = 2", "[scan", "L = 'a", "L = \xff", "L = 1e",
        "L = 1e999", "[a]\n[a]", "L = 99999999999999999999"}) {
    const std::string message = message_for(parse, written("a = 1\n" + bad));
    EXPECT_TRUE(message.starts_with(":2: is not TOML: ")
                || message.starts_with(":3: is not TOML: "))
        << bad << " gives " << message;
  }
}

TEST(TomlFile, of_bytes_at_random_is_refused_or_read_but_never_harmful) {
  const std::string whole =
      small_scan
      + "models = [\"SSH\"]\n[material]\npotential = [0, 0, 1]\n[numerics]\ngrading = 2\n";
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text = whole;
    for (int change = 0; change < 3; ++change) text[random() % text.size()] = char(random());
    const auto message = message_for(read_scan, written(text));
    EXPECT_TRUE(message.starts_with(":") || message == "accepted") << message;
  }
}

// ---- numbers and grids --------------------------------------------------------------------------

TEST(Grid, may_be_a_number_a_list_or_a_range) {
  EXPECT_EQ(grid_of("0.7"), std::vector{0.7});
  EXPECT_EQ(grid_of("2"), std::vector{2.0});
  EXPECT_EQ(grid_of("[0.8, 0.6, 1]"), (std::vector{0.6, 0.8, 1.0}));
  EXPECT_EQ(grid_of("{ from = 1, to = 2, count = 3 }"), (std::vector{1.0, 1.5, 2.0}));
  EXPECT_EQ(grid_of("{ from = 2, to = 1, count = 3 }"), (std::vector{1.0, 1.5, 2.0}));
  EXPECT_EQ(grid_of("{ from = 3, to = 3, count = 1 }"), std::vector{3.0});
  EXPECT_EQ(grid_of("{ from = 1e-2, to = 100, count = 5, spacing = \"log\" }"),
            (std::vector{0.01, 0.1, 1.0, 10.0, 100.0}));
}

TEST(Grid, of_a_range_has_the_numbers_that_one_would_write) {
  const std::vector<double> values = grid_of("{ from = 0.6, to = 0.8, count = 21 }");
  ASSERT_EQ(values.size(), 21u);
  for (int i = 0; i <= 20; ++i) EXPECT_EQ(values[i], (60 + i) / 100.0);
}

TEST(Grid, has_the_ends_of_its_range_exactly) {
  const auto linear = evenly_spaced(1.0 / 3, 2.0 / 3, 7, Spacing::linear);
  const auto logarithmic = evenly_spaced(1.0 / 3, 2.0 / 3, 7, Spacing::logarithmic);
  for (const auto& values : {linear, logarithmic}) {
    EXPECT_EQ(values.front(), 1.0 / 3);
    EXPECT_EQ(values.back(), 2.0 / 3);
  }
}

TEST(Grid, that_is_wrong_is_refused_with_what_is_allowed) {
  const std::string kind = "must be a number, a list of numbers, or a range { from, to, count }";
  const auto read = [](const auto& path) { TomlFile::parse(path).grid("g", above(0)); };
  const std::vector<Case> positive{
      {"'a'", ":1: g = 'a': " + kind},
      {"true", ":1: g = true: " + kind},
      {"1979-05-27", ":1: g = 1979-05-27: " + kind},
      {"[]", ":1: g = []: must not be empty"},
      {"[1, 'a']", ":1: g = 'a': " + kind},
      {"[1, [2]]", ":1: g = [2]: " + kind},
      {"-0.1", ":1: g = -0.1: must be > 0"},
      {"0", ":1: g = 0: must be > 0"},
      {"nan", ":1: g = nan: must be a finite number"},
      {"-inf", ":1: g = -inf: must be a finite number"},
      {"[1,\n2,\n-3]", ":3: g = -3: must be > 0"},
      {"[1, 2, 1.0]", ":1: g = 1.0: must not be there twice"},
      {"{}", ":1: g.from: missing; must be a number"},
      {"{ from = 1, to = 2 }", ":1: g.count: missing; must be an integer"},
      {"{ from = 1, to = 2, cuont = 3 }", ":1: g.cuont: unknown key; did you mean 'count'?"},
      {"{ from = 1, to = 2, count = 3, step = 1 }",
       ":1: g.step: unknown key. Known: from, to, count, spacing"},
      {"{ from = 'a', to = 2, count = 3 }", ":1: g.from = 'a': must be a number"},
      {"{ from = -1, to = 2, count = 3 }", ":1: g.from = -1: must be > 0"},
      {"{ from = 1, to = 2, count = 2.5 }", ":1: g.count = 2.5: must be an integer"},
      {"{ from = 1, to = 2, count = 0 }", ":1: g.count = 0: must be >= 1 and <= 100000"},
      {"{ from = 1, to = 2, count = 1 }", ":1: g.count = 1: must be > 1, since from and to differ"},
      {"{ from = 1, to = 1, count = 2 }", ":1: g.to = 1: must differ from from, since count > 1"},
      {"{ from = 1, to = 1.0000000000001, count = 9 }",
       ":1: g.count = 9: must be smaller: the values are equal to 12 digits"},
      {"{ from = 1, to = 2, count = 3, spacing = 'lin' }",
       ":1: g.spacing = 'lin': must be one of 'linear', 'log'"},
  };
  expect_messages(read, "g = ", positive);
  const auto read_any = [](const auto& path) { TomlFile::parse(path).grid("g"); };
  const std::vector<Case> any{
      {"{ from = 0, to = 2, count = 3, spacing = 'log' }",
       ":1: g.from = 0: must be > 0 for spacing = 'log'"},
      {"{ from = 1, to = -2, count = 3, spacing = 'log' }",
       ":1: g.to = -2: must be > 0 for spacing = 'log'"},
  };
  expect_messages(read_any, "g = ", any);
}

TEST(Message, shows_a_long_value_shortened) {
  const auto read = [](const auto& path) { TomlFile::parse(path).number("x"); };
  const std::string message =
      message_for(read, written("x = \"" + std::string(57, 'a') + "\xc3\xa4\xc3\xa4\""));
  EXPECT_EQ(message, ":1: x = \"" + std::string(56, 'a') + "...: must be a number");
}

TEST(Message, stays_on_one_line_whatever_the_key) {
  const auto read = [](const auto& path) { TomlFile::parse(path).reject_unknown_keys(); };
  expect_messages(read, "", {{"\"a\\nb\" = 1", ":1: \"a\\u000ab\": unknown key. Known: "}});
}

TEST(NearestWord, is_found_by_edit_distance_without_regard_to_capitals) {
  EXPECT_EQ(edit_distance("elemnts", "elements"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("cuont", "count"), 1u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);
  EXPECT_EQ(edit_distance("l1", "L1"), 0u);
  EXPECT_EQ(nearest("elemnts", {"grading", "elements"}), "elements");
  EXPECT_EQ(nearest("foo", {"grading", "elements"}), std::nullopt);
  EXPECT_EQ(nearest("foo", {}), std::nullopt);
}

}  // namespace
}  // namespace sbeh::studies
