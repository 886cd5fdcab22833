// What the documents tell to type.
#include "tests/studies/docs/document.h"
#include "tests/tools/workplace.h"

namespace sbeh::tools::test {
namespace {

using DocumentedCommands = Workplace;

// The words after `start`; in a block only where a line begins with it.
std::vector<std::string> words_after(const std::string& start, const std::string& line,
                                     bool in_block) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = line.find(start, at)) != std::string::npos;) {
    if (in_block && at > 0) break;
    at += start.size();
    words.push_back(line.substr(at, line.find_first_not_of("abcdefghijklmnopqrstuvwxyz", at) - at));
  }
  return words;
}

std::vector<std::string> commands_in(const std::string& line, bool in_block) {
  if (!in_block) return words_after("`sbeh ", line, false);
  return words_after(line.starts_with('$') ? "$ sbeh " : "sbeh ", line, true);
}

TEST_F(DocumentedCommands, exist) {
  const std::string known = sbeh({"--help"}).out;
  int found = 0;
  for (const std::filesystem::path& document : studies::test::documents()) {
    bool in_block = false;
    for (const std::string& line : studies::test::lines_of(document)) {
      if (line.starts_with("```")) in_block = !in_block;
      for (const std::string& word : commands_in(line, in_block)) {
        if (word.empty()) continue;  // an option of the program itself
        ++found;
        EXPECT_NE(known.find("\n  " + word + " "), std::string::npos)
            << document << ": sbeh " << word;
      }
    }
  }
  EXPECT_GE(found, 10);  // the table of commands in README.md
}

}  // namespace
}  // namespace sbeh::tools::test
