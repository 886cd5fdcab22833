// A command of sbeh, and what the commands share.
#pragma once

#include "studies/report/report.h"

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

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

// Words of a command. The header of CLI11 takes seconds to compile: who needs no more than these
// goes without it.
CLI::App* add_command(CLI::App& program, const char* name, const char* text);
void add_required(CLI::App* command, const char* name, std::string& value, const char* text);
void add_option(CLI::App* command, const char* name, std::string& value, const char* text);
void add_option(CLI::App* command, const char* name, int& value, const char* text, int least,
                int most);
void add_flag(CLI::App* command, const char* name, bool& value, const char* text);

/// FILE, -o, --no-pictures and --threads. `run` may be interrupted, and uses no more threads than said.
Command add_study(CLI::App& program, const char* name, const char* text,
                  std::function<int(const Study&)> run);

/// Writes "sbeh: what" to standard error.
void complain(std::string_view what);

/// Runs sbeh-picture with these arguments; its exit code, 127 when it cannot be started.
int draw(const std::vector<std::string>& arguments);
/// All pictures of a folder; complains when they cannot be drawn.
void draw_results(studies::ResultsKind kind, const std::filesystem::path& folder);

int exit_code_of_interrupt();
/// What a program ends with that has done its work, unless it was told to end while drawing.
int exit_code_of_success();

/// What an evolution's history has besides the rows of the output times, for `sbeh check`.
const char* beside_times(bool every_step);

}  // namespace sbeh::tools
