// A run of the program sbeh as its user sees it: started, watched, signalled, and what came of it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::tools::test {

struct Ended {
  int exit_code = -1;  ///< -1: it was ended by `signal`
  int signal = 0;
  std::string out, err;
};

struct Surroundings {
  std::filesystem::path folder;            ///< working directory; output is caught beside it
  std::vector<std::string> environment{};  ///< NAME=value, added to that of the test
  std::optional<long> largest_file{};      ///< bytes: a longer write fails, as on a full disk
  std::filesystem::path out{}, err{};      ///< instead of catching: goes there
};

/// The program, running. One that outlives this object, or 60 s of waiting, is killed.
class Program {
 public:
  Program(const Surroundings& surroundings, const std::vector<std::string>& arguments);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool is_running();
  void send(int signal) const;
  /// Stops it where it is, as Ctrl-Z does; returns when it stands.
  void pause() const;
  Ended wait();
  /// Memory it has now, in kB; 0 once it has ended.
  long resident_kilobytes() const;

 private:
  void collect(int options);
  pid_t pid_ = -1;
  std::optional<int> status_;  // of waitpid, once ended
  std::filesystem::path out_, err_;
};

/// From start to end.
Ended run(const Surroundings& surroundings, const std::vector<std::string>& arguments);

/// Waits until it holds; false after 60 s.
bool wait_until(const std::function<bool()>& holds);

}  // namespace sbeh::tools::test
