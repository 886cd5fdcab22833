// Misspelt keys and tables of every kind of input are told with what was meant, before any fault that follows from them.
#include "studies/compare/compare_input.h"
#include "studies/diagram/diagram_input.h"
#include "studies/evolution/relax_input.h"
#include "studies/evolution/run_input.h"
#include "studies/modes/modes_input.h"
#include "studies/parameters/input_kind.h"
#include "studies/rest_states/states_input.h"
#include "studies/scan/scan_input.h"
#include "studies/stability/stability_input.h"
#include "studies/sweep/sweep_input.h"
#include "tests/studies/parameters/input_file.h"

#include <iterator>
#include <regex>

namespace sbeh::studies {
namespace {

using namespace test;
namespace fs = std::filesystem;

void read(const fs::path& path) {
  switch (kind_of(path)) {
    case InputKind::scan:
      read_scan(path);
      break;
    case InputKind::relax:
      read_relax(path);
      break;
    case InputKind::run:
      read_run(path);
      break;
    case InputKind::compare:
      read_compare(path);
      break;
    case InputKind::stability:
      read_stability(path);
      break;
    case InputKind::modes:
      read_modes(path);
      break;
    case InputKind::states:
      read_states(path);
      break;
    case InputKind::diagram:
      read_diagram(path);
      break;
    case InputKind::sweep:
      cases_of(read_sweep(path), "0");
      break;
  }
}

/// Complete inputs: those that come with the toolkit, and others for keys that these have not.
std::vector<std::string> inputs() {
  const std::string time = "[time]\nend = 1\noutput = { from = 1e-3, to = 1, count = 4 }\n";
  std::vector<std::string> texts{
      "model = \"SSH\"\n[start]\nshape = \"harmonics\"\nmodes = [[2, 0.04]]\n"
      "reduced_volume = 0.9\n[material]\nL1 = 0.05\n"
      "landau_de_gennes = { a = 0, b = -27, c = 13.5 }\n"
          + time,
      "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\naxes = [1.2, 1, 0.5]\n"
      "triangles = 80\n[material]\nL = 0.05\n"
          + time,
      "model = \"SBEH\"\n[start]\nshape = \"ellipsoid\"\naxes = [1.2, 0.5]\n" + time,
      "[scan]\nreduced_volume = 0.7\nL = 0.05\nmethod = \"flow\"\nend_time = 7\n",
  };
  for (const auto& entry : fs::directory_iterator("studies/inputs")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string bare = std::regex_replace(text, std::regex("#.*"), "");
    // What one names lies beside it.
    texts.push_back(
        std::regex_replace(bare, std::regex("\"(\\w+\\.toml)\""), "\"studies/inputs/$1\""));
  }
  return texts;
}

struct Word {
  std::size_t at, length;
};

/// The keys and the names of tables of an input.
std::vector<Word> words_of(const std::string& text) {
  static const std::regex word(R"((?:(?:^|\n|[{,] *)([A-Za-z_0-9]+) *=)|(?:\n\[([a-z_0-9]+)\]))");
  std::vector<Word> found;
  for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) {
    const int group = (*at)[1].matched ? 1 : 2;
    found.push_back({std::size_t(at->position(group)), std::size_t(at->length(group))});
  }
  return found;
}

std::vector<std::string> misspelt(const std::string& word) {
  std::vector<std::string> all{word + "l", word + "_", word.substr(0, 1) + word};
  if (word.size() > 3) {
    all.push_back(word);
    std::swap(all.back()[word.size() - 2], all.back()[word.size() - 1]);
  }
  std::erase(all, word);
  return all;
}

TEST(MisspeltInput, is_told_with_the_nearest_word) {
  int tried = 0;
  for (const std::string& text : inputs()) {
    EXPECT_EQ(message_for(read, written(text)), "accepted") << text;
    for (const auto& [at, length] : words_of(text)) {
      const std::string word = text.substr(at, length);
      for (const std::string& wrong : misspelt(word)) {
        std::string changed = text;
        changed.replace(at, length, wrong);
        const std::string said = message_for(read, written(changed));
        EXPECT_NE(said.find(": unknown "), std::string::npos) << wrong << said;
        EXPECT_NE(said.find("; did you mean \"" + word + "\"?"), std::string::npos)
            << wrong << said;
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 500);
}

TEST(MisspeltInput, is_not_seen_in_keys_that_have_their_place) {
  int tried = 0;
  for (const std::string& text : inputs())
    for (const auto& [at, length] : words_of(text)) {
      const std::size_t end = text.find('\n', at);
      const bool whole_line = at == 0 || text[at - 1] == '\n';
      if (!whole_line
          || std::ranges::count(text.substr(at, end - at), '[')
                 != std::ranges::count(text.substr(at, end - at), ']'))
        continue;  // its value goes on below
      std::string without = text;
      without.erase(at, end - at);
      EXPECT_EQ(message_for(read, written(without)).find("unknown"), std::string::npos)
          << text.substr(at, length) << message_for(read, written(without));
      ++tried;
    }
  EXPECT_GT(tried, 100);
}

}  // namespace
}  // namespace sbeh::studies
