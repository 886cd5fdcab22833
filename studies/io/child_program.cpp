#include "studies/io/child_program.h"

#include "studies/io/errors.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace sbeh::studies {

namespace {

// Forks; the child becomes the program, its standard output the first descriptor, its complaints the second.
pid_t start(std::vector<std::string> words, int output, int complaints) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::fflush(nullptr);
  const pid_t parent = getpid(), child = fork();
  if (child < 0)
    throw OutputError(
        fmt::format("{}: cannot be started: {}", words.front(), std::strerror(errno)));
  if (child > 0) return child;
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() == parent && dup2(output, STDOUT_FILENO) >= 0
      && dup2(complaints, STDERR_FILENO) >= 0)
    execvp(argv.front(), argv.data());
  _exit(exit_not_started);
}

int exit_code_of_status(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : exit_by_signal + WTERMSIG(status);
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return exit_not_started;
  return exit_code_of_status(status);
}

}  // namespace

std::string own_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

ChildProgram::ChildProgram(std::vector<std::string> words, int output)
    : pid_(start(std::move(words), output, output)) {}

ChildProgram::~ChildProgram() {
  if (exit_code()) return;
  send(SIGTERM);
  wait_for(pid_);
}

void ChildProgram::send(int signal) const {
  if (!exit_code_) kill(pid_, signal);
}

std::optional<int> ChildProgram::exit_code() {
  int status = 0;
  if (!exit_code_ && waitpid(pid_, &status, WNOHANG) == pid_)
    exit_code_ = exit_code_of_status(status);
  return exit_code_;
}

ChildAnswer answer_of(std::vector<std::string> words) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    throw OutputError(
        fmt::format("{}: cannot be started: {}", words.front(), std::strerror(errno)));
  const pid_t child = start(std::move(words), ends[1], STDERR_FILENO);
  close(ends[1]);
  ChildAnswer answer{0, {}};
  std::array<char, 4096> text{};
  for (ssize_t size; (size = read(ends[0], text.data(), text.size())) > 0;)
    answer.said.append(text.data(), std::size_t(size));
  close(ends[0]);
  answer.exit_code = wait_for(child);
  return answer;
}

}  // namespace sbeh::studies
