// Input files of a test: written to a folder of its own, read, and what the reader says of them.
#pragma once

#include "studies/io/errors.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace sbeh::studies::test {

inline std::filesystem::path path_of(const std::string& file) {
  static const sbeh::test::TemporaryFolder folder;
  return folder.path() / file;
}

inline std::filesystem::path written(const std::string& text) {
  auto path = path_of("input.toml");
  std::ofstream(path) << text;
  return path;
}

/// A folder with what an input reads of a scan: its run.toml with this end, and no row.
inline std::string scan_folder(const std::string& end) {
  const std::filesystem::path folder = path_of("scan");
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "run.toml") << "[scan]\nreduced_volume = 0.7\nL = 0.03\n" << end;
  std::ofstream(folder / "scan.csv") << "model,status\n";
  return folder.string();
}

/// What the reader says of the file, without the file's name: ":7: [scan] …" or ": …".
template <class Reader>
std::string message_for(Reader&& read, const std::filesystem::path& path) {
  try {
    read(path);
  } catch (const InputError& error) {
    const std::string text = error.what(), file = path.string();
    return text.substr(0, file.size()) == file ? text.substr(file.size()) : "no file in: " + text;
  }
  return "accepted";
}

/// Both with ' in place of ".
struct Case {
  std::string text;     ///< what stands in the file after the common part
  std::string message;  ///< from the line's number on
};

/// Reads `before` + text of every case.
template <class Reader>
void expect_messages(Reader&& read, const std::string& before, const std::vector<Case>& cases) {
  for (auto [text, message] : cases) {
    std::replace(text.begin(), text.end(), '\'', '"');
    std::replace(message.begin(), message.end(), '\'', '"');
    EXPECT_EQ(message_for(read, written(before + text)), message) << text;
  }
}

inline const std::string small_scan = "[scan]\nreduced_volume = 0.7\nL = 0.05\n";
inline const std::string small_relax =
    "model = \"SBEH\"\nstart = { shape = \"ellipsoid\", reduced_volume = 0.7 }\ntime.end = 10\n";

}  // namespace sbeh::studies::test
