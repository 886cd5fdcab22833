// Writing results so that nothing is lost or overwritten silently.
#pragma once

#include "studies/io/errors.h"

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

namespace sbeh::studies {

/// Writes to a temporary name beside `path` and renames. Throws OutputError.
void write_file(const std::filesystem::path& path, std::string_view text);

/// Removes the file, if it is there, and what an interrupted write_file may have left of it.
void remove_file(const std::filesystem::path& path);

/// The whole file as text. Throws OutputError.
std::string read_file(const std::filesystem::path& path);

/// Makes the folder, and those it lies in, unless it is there. Throws OutputError.
void make_folder(const std::filesystem::path& path);

/// A folder of results that belongs to one process as long as this object lives; made if it is not
/// there. Throws OutputError when it cannot be made or written, or when another process holds it.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(std::string_view name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
  int lock_;  // file descriptor; the lock goes with the process, however it ends
};

/// A text file that grows line by line; a line is handed to the system before append returns.
class AppendFile {
 public:
  explicit AppendFile(std::filesystem::path path);
  /// Adds the text and a line end. Throws OutputError when it cannot be written.
  void append(std::string_view line);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  int reason_ = 0;  // errno of the first failure: after it nothing is tried any more
};

// ---- results that are in a folder already -------------------------------------------------------

/// Throws OutputError, "<folder>: <what it holds>; choose another folder with -o".
[[noreturn]] void refuse(const OutputFolder& folder, std::string_view holds);

/// Refuses a folder in which one of these files tells of earlier results.
void refuse_results(const OutputFolder& folder, std::initializer_list<const char*> files);

/// For a study that is completed row by row: writes its description to run.toml, or finds the same there, but for [units], which
/// are then those of the description.
/// Refuses a folder that holds `what` with other parameters, which it names, or of another version, or the table
/// without run.toml.
void begin_or_continue(const OutputFolder& folder, const std::string& description,
                       std::string_view table, std::string_view what);

}  // namespace sbeh::studies
