// A file that one process has for itself, until that process ends, however it does.
#pragma once

#include <filesystem>
#include <optional>

namespace sbeh::studies {

class FileLock {
 public:
  /// Locks the file, made where it is not there; empty where another has it. Throws OutputError when it cannot be opened.
  static std::optional<FileLock> take(const std::filesystem::path& path);
  /// The same, after others have given it back; empty only where a signal asks for the end.
  static std::optional<FileLock> wait(const std::filesystem::path& path);
  /// Whether somebody has it.
  static bool is_taken(const std::filesystem::path& path);

  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&&) = delete;

  /// Of the open file, to whose end it writes. A child that has it too holds the lock until both have ended.
  int descriptor() const { return descriptor_; }

 private:
  explicit FileLock(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

}  // namespace sbeh::studies
