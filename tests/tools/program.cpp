#include "tests/tools/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace sbeh::tools::test {

namespace fs = std::filesystem;
using std::chrono::steady_clock;

namespace {

constexpr std::chrono::minutes patience(10);  // to end what hangs; no test measures time

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment_with(const std::vector<std::string>& added) {
  std::vector<std::string> all = added;  // the first of a name counts
  for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
  return all;
}

std::string text_of(const fs::path& path) {
  if (!fs::is_regular_file(path)) return "";  // /dev/full never ends
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// In the child, between fork and exec: system calls only.
[[noreturn]] void become(char** arguments, char** environment, const char* folder, const char* out,
                         const char* err, const rlimit* largest_file) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_DFL);
  const int to_out = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const int to_err = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const bool ready = to_out >= 0 && to_err >= 0 && dup2(to_out, STDOUT_FILENO) >= 0
                  && dup2(to_err, STDERR_FILENO) >= 0 && chdir(folder) == 0
                  && (!largest_file || setrlimit(RLIMIT_FSIZE, largest_file) == 0);
  if (ready) execve(arguments[0], arguments, environment);
  _exit(126);
}

}  // namespace

Program::Program(const Surroundings& surroundings, const std::vector<std::string>& arguments)
    : out_(surroundings.out), err_(surroundings.err) {
  static int count = 0;
  const std::string caught = surroundings.folder.string() + "." + std::to_string(++count);
  if (out_.empty()) out_ = caught + ".out";
  if (err_.empty()) err_ = caught + ".err";
  std::vector<std::string> words{SBEH_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_with(surroundings.environment);
  const auto words_given = pointers(words), environment_given = pointers(environment);
  rlimit limit{};
  limit.rlim_cur = limit.rlim_max = rlim_t(surroundings.largest_file.value_or(0));
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ == 0)
    become(const_cast<char**>(words_given.data()), const_cast<char**>(environment_given.data()),
           surroundings.folder.c_str(), out_.c_str(), err_.c_str(),
           surroundings.largest_file ? &limit : nullptr);
}

Program::~Program() {
  if (!is_running()) return;
  send(SIGKILL);
  collect(0);
}

void Program::collect(int options) {
  int status = 0;
  if (!status_ && waitpid(pid_, &status, options) == pid_) status_ = status;
}

bool Program::is_running() {
  collect(WNOHANG);
  return !status_;
}

void Program::send(int signal) const {
  if (!status_) kill(pid_, signal);
}

void Program::pause() const {
  int ignored = 0;
  send(SIGSTOP);
  waitpid(pid_, &ignored, WUNTRACED);
}

long Program::resident_kilobytes() const {
  std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
  const std::string key = "VmRSS:";
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stol(line.substr(key.size()));
  return 0;
}

Ended Program::wait() {
  if (!wait_until([this] { return !is_running(); })) {
    ADD_FAILURE() << "the program did not end in time; it said: " << text_of(err_);
    send(SIGKILL);
    collect(0);
  }
  return {.exit_code = WIFEXITED(*status_) ? WEXITSTATUS(*status_) : -1,
          .signal = WIFSIGNALED(*status_) ? WTERMSIG(*status_) : 0,
          .out = text_of(out_),
          .err = text_of(err_)};
}

Ended run(const Surroundings& surroundings, const std::vector<std::string>& arguments) {
  return Program(surroundings, arguments).wait();
}

bool wait_until(const std::function<bool()>& holds) {
  const auto start = steady_clock::now();
  while (!holds()) {
    if (steady_clock::now() - start > patience) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace sbeh::tools::test
