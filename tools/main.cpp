// The command line of sbeh.

#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/spelling.h"
#include "tools/commands/commands.h"

#include <fmt/ranges.h>
#include <malloc.h>

#include <algorithm>
#include <cstdio>

namespace {

using namespace sbeh;
using tools::complain;

// Matrices come and go by the thousand: their memory is not given back to the system in between.
void keep_memory() {
  constexpr int most = 1 << 28;  // bytes
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, most);
}

// A word of the command line that CLI11 did not take, with what may have been meant.
int complain_of(const std::string& word, const char* what, const std::vector<std::string>& known,
                bool list) {
  const auto meant = studies::nearest(word, known);
  complain(fmt::format("{}: unknown {}{}{}", word, what,
                       meant ? fmt::format("; did you mean {}?", *meant) : ".",
                       list ? fmt::format(" Known: {}", fmt::join(known, ", ")) : ""));
  return 2;
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

int complain_of_command_line(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App* at = &program;  // the command they belong to
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  const std::vector<std::string> rest = program.remaining(true);
  const auto option = std::ranges::find_if(rest, [](const auto& w) { return w.starts_with('-'); });
  if (option != rest.end()) return complain_of(*option, "option", options_of(*at), at == &program);
  const bool has_commands = !at->get_subcommands({}).empty();
  if (!has_commands || rest.empty()) return program.exit(error) == 0 ? 0 : 2;
  std::vector<std::string> commands;
  for (const CLI::App* command : at->get_subcommands({})) commands.push_back(command->get_name());
  return complain_of(rest.front(), at == &program ? "command" : "shape", commands, true);
}

int run(int argc, char** argv) {
  CLI::App program{"Shapes and dynamics of fluid lipid membranes with liquid-crystalline order.",
                   "sbeh"};
  program.set_version_flag("--version", SBEH_VERSION);
  program.require_subcommand(1);
  std::vector<tools::Command> commands;
  for (const auto add : tools::all_commands) commands.push_back(add(program));
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return complain_of_command_line(program, error);
  }
  studies::let_writes_fail();
  for (const tools::Command& command : commands)
    if (*command.app) return command.run();
  return 2;
}

int run_and_report(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const studies::InputError& error) {
    complain(error.what());
    return 2;
  } catch (const studies::OutputError& error) {
    complain(error.what());
    return 2;
  } catch (const studies::Interrupted&) {
    complain("interrupted; nothing is kept, the same command begins again");
    return tools::exit_code_of_interrupt();
  } catch (const std::exception& error) {
    complain(error.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  const int code = run_and_report(argc, argv);
  if (std::fflush(stdout) == 0) return code;
  complain("standard output cannot be written");
  return code == 0 ? 2 : code;
}
