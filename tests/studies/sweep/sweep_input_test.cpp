// What a sweep makes of an input: its cases, their order, and what is refused.
#include "studies/evolution/relax_input.h"
#include "studies/sweep/sweep_slurm.h"
#include "tests/studies/parameters/input_file.h"

#include <algorithm>
#include <set>

namespace sbeh::studies {
namespace {

using namespace test;

const std::string base = small_relax;  // model, [start], [time]

SweepCases cases_in(const std::string& text) {
  return cases_of(read_sweep(written(text)), "1.2.3");
}

std::string joined(const SweepCase& of) {
  std::string text;
  for (const std::string& value : of.values) text += (text.empty() ? "" : " ") + value;
  return text;
}

TEST(SweepCases, are_all_combinations_the_last_key_fastest) {
  const SweepCases all = cases_in(base
                                  + "[sweep.grid]\nmodel = [\"SBEH\", \"SSH\"]\n"
                                    "\"start.reduced_volume\" = {from = 0.7, to = 0.9, count = 3}\n"
                                    "[[sweep.together]]\nmaterial.viscosity = [2, 3]\n"
                                    "\"material.friction\" = [0.5, 0.5]\n");
  ASSERT_EQ(all.cases.size(), 12u);
  EXPECT_EQ(all.kind, InputKind::relax);
  EXPECT_EQ(joined(all.cases[0]), "\"SBEH\" 0.7 2 0.5");
  EXPECT_EQ(joined(all.cases[1]), "\"SBEH\" 0.7 3 0.5");
  EXPECT_EQ(joined(all.cases[2]), "\"SBEH\" 0.8 2 0.5");
  EXPECT_EQ(joined(all.cases[11]), "\"SSH\" 0.9 3 0.5");
  for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(all.cases[k].number, int(k) + 1);
}

TEST(SweepCases, are_inputs_as_if_written_by_hand) {
  const std::string grid = "[sweep.grid]\n\"material.L\" = [0.03]\nnumerics.elements = [20]\n";
  const SweepCases all = cases_in(base + grid);
  const std::string by_hand = base + "[material]\nL = 0.03\n[numerics]\nelements = 20\n";
  EXPECT_EQ(all.cases.front().description, describe(read_relax(written(by_hand)), "1.2.3"));
}

TEST(SweepCases, have_a_base_beside_the_file_or_in_it) {
  const std::string grid = "[sweep.grid]\n\"time.end\" = [1, 2]\n";
  std::ofstream(path_of("base.toml")) << base;
  const SweepCases inside = cases_in(base + grid),
                   beside = cases_in("[sweep]\nbase = \"base.toml\"\n" + grid);
  ASSERT_EQ(inside.cases.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(inside.cases[k].description, beside.cases[k].description);
}

TEST(SweepCases, may_be_random_the_same_for_the_same_seed) {
  const auto random = [](const std::string& seed) {
    std::string text = base + "[sweep.random]\nsamples = 20\n";
    text += "\"material.L\" = {from = 1e-3, to = 0.1, spacing = \"log\"}\n";
    text += "\"start.reduced_volume\" = {from = 0.6, to = 0.9}\nseed = ";
    text += seed;
    std::vector<std::string> values;
    for (const SweepCase& of : cases_in(text).cases) values.push_back(joined(of));
    return values;
  };
  const std::vector<std::string> first = random("1");
  EXPECT_EQ(first, random("1"));
  EXPECT_NE(first, random("2"));
  EXPECT_EQ(std::set(first.begin(), first.end()).size(), 20u);
  int small = 0;  // by decades, half of them lie below the geometric mean
  for (const std::string& values : first) {
    const double L = std::stod(values), volume = std::stod(values.substr(values.find(' ')));
    EXPECT_TRUE(L >= 1e-3 && L <= 0.1 && volume >= 0.6 && volume <= 0.9) << values;
    small += L < 1e-2;
  }
  EXPECT_TRUE(small >= 4 && small <= 16) << small;
}

TEST(SweepCases, cost_more_the_longer_they_are) {
  const SweepCases all = cases_in(base + "[sweep.grid]\n\"time.end\" = [1, 1000]\n");
  EXPECT_LT(all.cases[0].cost.seconds, all.cases[1].cost.seconds);
  EXPECT_GT(all.cases[0].cost.megabytes, 0);
}

std::string message(const std::string& text) {
  return message_for([](const auto& path) { return cases_of(read_sweep(path), "0"); },
                     written(text));
}

TEST(Sweep, that_is_wrong_is_refused_with_file_line_and_what_is_allowed) {
  const std::string kinds = "must be a list of values, or a range { from, to, count }";
  const std::vector<Case> wrong{
      {"[sweep]",
       ": [sweep] sweeps no key: give values in [sweep.grid], as in \"material.L\" = "
       "[0.03, 0.05], in [[sweep.together]] or in [sweep.random]"},
      {"[sweep.grdi]\nx = [1]",
       ":4: [sweep.grdi]: unknown table; did you mean \"grid\"? Known: "
       "base, grid, random, together"},
      {"[sweep.grid]\n'material.L' = []", ":5: [sweep.grid] 'material.L' = []: must not be empty"},
      {"[sweep.grid]\n'material.L' = 0.05", ":5: [sweep.grid] 'material.L' = 0.05: " + kinds},
      {"[sweep.grid]\n'material.L' = [0.1, 0.1]",
       ":5: [sweep.grid] 'material.L' = 0.1: must not be there twice"},
      {"[sweep.grid]\n'material.L' = {from = 0.1, to = 0.2}",
       ":5: [sweep.grid] 'material.L'.count: missing; must be an integer"},
      {"[sweep.grid]\n'time.end' = [1]\n[[sweep.together]]\ntime.end = [2]",
       ":4: [sweep.grid]: time.end must not be swept twice"},
      {"[[sweep.together]]\n'material.viscosity' = [1, 2]\n'material.friction' = [1]",
       ":6: [sweep] together.'material.friction' = [1]: must have as many values as "
       "material.viscosity, 2: they go together"},
      {"[sweep.random]\nseed = 1", ":4: [sweep.random] samples: missing; must be an integer"},
      {"[sweep.random]\nsamples = 3\nseed = 1\n'material.L' = {from = 2, to = 1}",
       ":7: [sweep.random] 'material.L'.to = 1: must be > from"},
      {"[sweep.grid]\n'time.end' = {from = 1, to = 2, count = 100}\n'material.L' = {from = 1, to = "
       "2, count = 100}",
       ":4: [sweep.grid]: must have fewer values: that makes 10000 cases with the other lists, "
       "more than 9999"},
  };
  expect_messages([](const auto& path) { return cases_of(read_sweep(path), "0"); }, base, wrong);
}

TEST(Sweep, of_a_wrong_case_says_which_it_is) {
  const std::string at = written("").string();
  EXPECT_EQ(message(base + "[sweep.grid]\n\"material.L\" = [0.1, -1]\n"),
            ": case 2 (material.L = -1): " + at + ": [material] L = -1: must be > 0");
  EXPECT_EQ(
      message(base + "[sweep.grid]\n\"material.viscositty\" = [1]\n").substr(0, 40 + at.size()),
      (": case 1 (material.viscositty = 1): " + at + ": [material] ").substr(0, 40 + at.size()));
  EXPECT_EQ(message(base + "[sweep.grid]\n\"model.x\" = [1]\n"),
            ": case 1 (model.x = 1): " + at
                + ": model = \"SBEH\": is no table, so that there is no x in it");
  EXPECT_EQ(message("[modes]\nreduced_volume = 0.8\nL = 0.05\n[sweep.grid]\n\"modes.L\" = [0.1]\n"),
            ": case 1 (modes.L = 0.1): " + at
                + ": is an input of sbeh modes: what can be swept is one of run, relax, scan and "
                  "states");
}

TEST(SlurmArray, is_written_in_ranges) {
  EXPECT_EQ(ranges_text({}), "");
  EXPECT_EQ(ranges_text({4}), "4");
  EXPECT_EQ(ranges_text({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
}

}  // namespace
}  // namespace sbeh::studies
