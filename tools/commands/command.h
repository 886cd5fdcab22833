// A command of sbeh, and what the commands share.
#pragma once

#include "studies/io/part.h"
#include "studies/parameters/input_kind.h"
#include "studies/report/report.h"
#include "tools/refusals.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::tools {

struct Command {
  CLI::App* app;             ///< its words on the command line
  std::function<int()> run;  ///< what it does when it is the one; the exit code
};

/// What stands on the command line of a command that reads an input and fills a folder.
struct Study {
  std::string input;
  std::string folder;
  bool no_pictures = false;
  int threads = 0;  ///< 0: all cores

  /// `results/NAME` for NAME.toml, unless -o says otherwise.
  std::filesystem::path results() const;
};

/// FILE, -o, --no-pictures and --threads. `run` may be interrupted, and uses no more threads than said; a file of
/// another kind is refused with the command that it is for.
Command add_study(CLI::App& program, studies::InputKind kind, const char* text,
                  std::function<int(const Study&)> run);

/// From "3/16", the third of sixteen, as it stands after --part. Throws InputError for another text.
studies::Part part_of(const std::string& text);

/// Runs sbeh-picture with these arguments; its exit code, 127 when it cannot be started.
int draw(const std::vector<std::string>& arguments);
/// All pictures of a folder; complains when they cannot be drawn.
void draw_results(studies::ResultsKind kind, const std::filesystem::path& folder);

/// What a program ends with that has done its work, unless it was told to end while drawing.
int exit_code_of_success();
/// Draws, unless pictures are not wanted or the study was interrupted, to go on later; the exit code.
int finish(const Study& study, studies::ResultsKind kind, bool interrupted);

/// "7.5 s", "12 min", "3 h": what `sbeh check` estimates.
std::string duration(double seconds);

/// What an evolution's history has besides the rows of the output times, for `sbeh check`.
const char* beside_times(bool every_step);

}  // namespace sbeh::tools
