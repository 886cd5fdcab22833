// A temporary folder in which the program is run, and what it leaves there.
#pragma once

#include "tests/temporary_folder.h"
#include "tests/tools/program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sbeh::tools::test {

/// Path relative to a folder → what the file holds; folders end in "/".
using Contents = std::map<std::string, std::string>;

/// A table of comma separated values. Rows and columns that are not there fail the test.
struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  std::string text(std::size_t row, const std::string& column) const;
  double number(std::size_t row, const std::string& column) const;
  std::vector<double> numbers(const std::string& column) const;
  /// The row of a point of a scan.
  std::size_t find(const std::string& model, const std::string& reduced_volume,
                   const std::string& L) const;
  /// The table as text again, without a column: what must not depend on the time of day.
  std::string without(const std::string& column) const;
};

/// A fixture: every test works in a folder of its own, removed at its end.
class Workplace : public testing::Test {
 protected:
  Workplace();

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  Contents contents(const std::string& name) const;
  Table table(const std::string& name) const;
  /// Complete lines of a file that may be growing; 0 when it is not there.
  int lines(const std::string& name) const;

  Surroundings here() const { return {.folder = folder_}; }
  Ended sbeh(const std::vector<std::string>& arguments) const { return run(here(), arguments); }
  /// `sbeh COMMAND FILE -o RESULTS --no-pictures`, as arguments.
  static std::vector<std::string> into(const std::string& results, const std::string& command,
                                       const std::string& file = "in.toml");

  /// Runs that must succeed.
  void must(const std::vector<std::string>& arguments) const;
  /// Runs that must be refused: exit 2, one sentence that starts so, nothing on standard output.
  void must_refuse(const std::vector<std::string>& arguments, const std::string& start) const;

 private:
  sbeh::test::TemporaryFolder top_;
  std::filesystem::path folder_;
};

}  // namespace sbeh::tools::test
