#include "studies/io/results_folder.h"

#include "studies/io/errors.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace fs = std::filesystem;

void refuse(const OutputFolder& folder, std::string_view holds) {
  throw OutputError(
      fmt::format("{}: {}; choose another folder with -o", folder.path().string(), holds));
}

void refuse_results(const OutputFolder& folder, std::initializer_list<const char*> files,
                    std::string_view what, std::string_view are) {
  for (const char* file : files)
    if (fs::exists(folder / file))
      throw OutputError(
          fmt::format("{}: already holds {} (see its {}), which {} not overwritten; choose another "
                      "folder with -o or move it away",
                      folder.path().string(), what, file, are));
}

void begin_or_continue(const OutputFolder& folder, const std::string& description,
                       std::string_view table, std::string_view what) {
  const fs::path run = folder / "run.toml";
  if (!fs::exists(run)) {
    if (fs::exists(folder / table)) refuse(folder, "holds a table without its run.toml");
    write_file(run, description);
  } else if (read_file(run) != description) {
    refuse(folder, fmt::format("holds {} with other parameters (see its run.toml)", what));
  }
}

}  // namespace sbeh::studies
