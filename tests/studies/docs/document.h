// The documents of the repository as tests read them: lines, and tables in Markdown.
#pragma once

#include "studies/io/output.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace sbeh::studies::test {

/// All *.md below the repository root, but for what is built or computed there.
inline const std::vector<std::filesystem::path>& documents() {
  namespace fs = std::filesystem;
  static const std::vector<fs::path> all = [] {
    std::vector<fs::path> found;
    const std::set<fs::path> skipped{"build", "results"};
    for (fs::recursive_directory_iterator at("."), end; at != end; ++at) {
      const fs::path name = at->path().filename();
      if (at->is_directory() && (skipped.contains(name) || name.string().starts_with('.')))
        at.disable_recursion_pending();
      else if (name.extension() == ".md")
        found.push_back(at->path().lexically_normal());
    }
    return found;
  }();
  return all;
}

inline std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::istringstream text(read_file(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// Fields of "| a | b |", without the spaces around them; none where the line is no row.
inline std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  if (!line.starts_with('|')) return fields;
  for (std::size_t at = 1, end; (end = line.find('|', at)) != std::string::npos; at = end + 1) {
    const std::size_t from = line.find_first_not_of(' ', at);
    const std::size_t to = line.find_last_not_of(' ', end - 1);
    fields.push_back(from < end ? line.substr(from, to - from + 1) : "");
  }
  return fields;
}

/// The rows below the first line that begins with `header`, without the line of dashes. None fail the test.
inline std::vector<std::vector<std::string>> table_below(const std::filesystem::path& document,
                                                         const std::string& header) {
  const std::vector<std::string> lines = lines_of(document);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!lines[k].starts_with(header)) continue;
    for (k += 2; k < lines.size() && lines[k].starts_with('|'); ++k)
      rows.push_back(fields_of(lines[k]));
    break;
  }
  EXPECT_FALSE(rows.empty()) << document << ": no table " << header;
  return rows;
}

/// A number as it is printed, and half a unit of its last digit.
struct Printed {
  double value, rounding;
};
inline Printed printed(const std::string& text) {
  const std::string minus = "−";
  const bool negative = text.starts_with(minus);
  const std::string number = negative ? text.substr(minus.size()) : text;
  const std::size_t point = number.find('.');
  const double digits = point == std::string::npos ? 0 : double(number.size() - point - 1);
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  EXPECT_EQ(*end, 0) << text << " is no number";
  return {negative ? -value : value, 0.5 * std::pow(10, -digits)};
}

/// Computed with an error of `accuracy` at most, then rounded.
inline void expect_printed(const std::string& text, double computed, double accuracy) {
  const Printed p = printed(text);
  EXPECT_NEAR(p.value, computed, p.rounding + accuracy) << "printed as " << text;
}

}  // namespace sbeh::studies::test
