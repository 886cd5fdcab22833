#include "studies/report/path_kind.h"

#include "studies/io/errors.h"
#include "studies/mesh_files/mesh_file.h"
#include "studies/parameters/input_kind.h"
#include "studies/report/report.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

struct PathKind {
  std::string is;                     // "is a mesh"
  std::vector<std::string> commands;  // that are for it
  fs::path argument;                  // of these
};

// Empty where `read` throws what a file of another kind makes it throw.
template <class Read>
auto tried(const Read& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const InputError&) {
    return {};
  } catch (const OutputError&) {
    return {};
  }
}

std::optional<PathKind> results_at(const fs::path& folder, const char* is) {
  const auto kind = tried([&] { return kind_of_results(folder); });
  if (!kind) return {};
  return PathKind{fmt::format("{} of sbeh {}", is, sbeh::name(*kind)),
                  {"report", fmt::format("picture {}", sbeh::name(*kind))},
                  folder};
}

std::optional<PathKind> kind_of_path(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return results_at(path, "holds the results");
  if (is_mesh_name(path)) return PathKind{"is a mesh", {"mesh file", "picture mesh"}, path};
  if (path.extension() == ".csv") {
    if (tried([&] { return read_profile(path); }))
      return PathKind{"is a profile", {"mesh revolve"}, path};
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    return results_at(folder, "is a table of the results");
  }
  if (const auto kind = tried([&] { return kind_of(path); }))
    return PathKind{"is an input", {sbeh::name(*kind), "check"}, path};
  return {};
}

}  // namespace

void refuse_other_kind(const fs::path& path, std::string_view command) {
  const auto kind = kind_of_path(path);
  if (!kind) return;
  const bool for_it = std::ranges::find(kind->commands, command) != kind->commands.end();
  if (for_it && kind->argument == path) return;
  std::vector<std::string> commands;
  for (const std::string& known : kind->commands)
    commands.push_back(fmt::format("sbeh {} {}", known, kind->argument.string()));
  throw InputError(
      fmt::format("{}: {}: for {}", path.string(), kind->is, fmt::join(commands, " or ")));
}

}  // namespace sbeh::studies
