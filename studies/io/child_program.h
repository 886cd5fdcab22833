// A program that runs beside this one.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// This program's own file.
std::string own_program();

/// Exit code of a program that could not be started; 128 and the signal of one that a signal has ended.
inline constexpr int exit_not_started = 127, exit_by_signal = 128;

/// Runs from its construction on, and is told to end (SIGTERM) when this program dies.
class ChildProgram {
 public:
  /// What it says goes to `output`, a file descriptor. Throws OutputError when there cannot be another process.
  ChildProgram(std::vector<std::string> words, int output);
  /// Tells it to end, and waits for that.
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  void send(int signal) const;
  /// Its exit code, once it has ended.
  std::optional<int> exit_code();

 private:
  pid_t pid_;
  std::optional<int> exit_code_;
};

struct ChildAnswer {
  int exit_code;
  std::string said;  ///< on standard output
};
/// Runs a program to its end; it is looked for in PATH. Its complaints go where those of this one go.
ChildAnswer answer_of(std::vector<std::string> words);

}  // namespace sbeh::studies
