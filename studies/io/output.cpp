#include "studies/io/output.h"

#include "studies/io/description.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iterator>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {
[[noreturn]] void fail(const fs::path& path, std::string_view what) {
  const std::string reason = errno ? std::strerror(errno) : "no reason given by the system";
  throw OutputError(fmt::format("{}: {}: {}", path.string(), what, reason));
}

fs::path temporary_of(const fs::path& path) { return path.string() + ".part"; }
}  // namespace

void write_file(const fs::path& path, std::string_view text) {
  const fs::path temporary = temporary_of(path);
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file << text;
  file.close();
  if (!file) {
    std::error_code ignored;
    const int reason = errno;
    fs::remove(temporary, ignored);
    errno = reason;
    fail(path, "cannot be written");
  }
  std::error_code error;
  fs::rename(temporary, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw OutputError(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
  }
}

void remove_file(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
  fs::remove(temporary_of(path), ignored);
}

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw OutputError(fmt::format("{}: is a directory, not a file", path.string()));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path, "cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

void make_folder(const fs::path& path) {
  std::error_code error, ignored;
  fs::create_directories(path, error);
  if (fs::is_directory(path, ignored)) return;
  const bool file = fs::exists(path, ignored);
  throw OutputError(fmt::format("{}: cannot be made a folder for results: {}", path.string(),
                                file ? "there is a file of that name" : error.message()));
}

OutputFolder::OutputFolder(fs::path path) : path_(std::move(path)) {
  make_folder(path_);
  const fs::path lock = path_ / ".lock";
  errno = 0;
  lock_ = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0) fail(path_, "cannot be written; choose another folder with -o");
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    throw OutputError(fmt::format(
        "{}: another run is writing there; wait for it or choose another folder with -o",
        path_.string()));
  }
}

OutputFolder::~OutputFolder() { ::close(lock_); }

AppendFile::AppendFile(fs::path path) : path_(std::move(path)) {
  errno = 0;
  file_.open(path_, std::ios::binary | std::ios::app);
  if (!file_) fail(path_, "cannot be written");
}

void AppendFile::append(std::string_view line) {
  if (file_) {
    errno = 0;
    file_ << line << '\n';
    file_.flush();
    reason_ = errno;
  }
  errno = reason_;
  if (!file_) fail(path_, "cannot be written any further");
}

void refuse(const OutputFolder& folder, std::string_view holds) {
  throw OutputError(
      fmt::format("{}: {}; choose another folder with -o", folder.path().string(), holds));
}

void refuse_results(const OutputFolder& folder, std::initializer_list<const char*> files) {
  for (const char* file : files)
    if (fs::exists(folder / file))
      throw OutputError(
          fmt::format("{}: already holds results (see its {}), which are not overwritten; choose "
                      "another folder with -o or move it away",
                      folder.path().string(), file));
}

void begin_or_continue(const OutputFolder& folder, const std::string& description,
                       std::string_view table, std::string_view what) {
  const fs::path run = folder / "run.toml";
  if (!fs::exists(run)) {
    if (fs::exists(folder / table)) refuse(folder, "holds a table without its run.toml");
    write_file(run, description);
  } else if (const auto other = mismatch(read_file(run), description, what); !other.empty()) {
    refuse(folder, other);
  } else {  // with other [units], it may be
    const std::string before = read_file(run);
    const std::string now = with_remarks(description, remarks_in(before));
    if (now != before) write_file(run, now);
  }
}

}  // namespace sbeh::studies
