#include "studies/io/input_path.h"

#include "studies/io/errors.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace fs = std::filesystem;

std::string path_from(const fs::path& input, const std::string& path) {
  const fs::path folder = input.parent_path();
  std::error_code ignored;
  if (folder.empty() || fs::path(path).is_absolute() || !fs::exists(folder / path, ignored))
    return path;
  return (folder / path).string();
}

void require_there(const std::string& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored)) return;
  if (fs::path(path).is_absolute()) throw InputError(fmt::format("{}: is not there", path));
  throw InputError(fmt::format("{}: is not there: neither from the folder of the input nor from {}",
                               path, fs::current_path(ignored).string()));
}

}  // namespace sbeh::studies
