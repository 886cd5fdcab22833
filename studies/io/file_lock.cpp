#include "studies/io/file_lock.h"

#include "studies/io/errors.h"
#include "studies/io/interrupt.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

namespace sbeh::studies {

std::optional<FileLock> FileLock::take(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw OutputError(
        fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
  FileLock lock(descriptor);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return lock;
  if (errno != EWOULDBLOCK)
    throw OutputError(fmt::format("{}: cannot be locked: {}; choose a file system that has locks",
                                  path.string(), std::strerror(errno)));
  return {};
}

std::optional<FileLock> FileLock::wait(const std::filesystem::path& path) {
  for (;;) {
    if (auto lock = take(path)) return lock;
    if (interrupt_signal()) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

bool FileLock::is_taken(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool taken = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0;
  ::close(descriptor);
  return taken;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

}  // namespace sbeh::studies
