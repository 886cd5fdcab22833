// The command line of sbeh.

#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "tools/commands/commands.h"
#include "tools/commands/self_test.h"
#include "tools/ranks.h"
#include "tools/refusals.h"

#include <malloc.h>

#include <algorithm>
#include <cstdio>

namespace {

using namespace sbeh;

// Matrices come and go by the thousand: their memory is not given back to the system in between.
void keep_memory() {
  constexpr int most = 1 << 28;  // bytes
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, most);
}

int run(int argc, char** argv, tools::RanksAtWork& ranks) {
  CLI::App program{"Shapes and dynamics of fluid lipid membranes with liquid-crystalline order.",
                   "sbeh"};
  program.set_version_flag("--version", SBEH_VERSION);
  program.add_flag_callback(
      "--self-test", [] { throw CLI::RuntimeError(tools::self_test()); },
      "Hold what is installed against known numbers, and exit");
  program.require_subcommand(1);
  std::vector<tools::Command> commands;
  for (const auto add : tools::all_commands) commands.push_back(add(program));
  if (std::any_of(argv + 1, argv + argc, [](const char* word) { return *word == '\0'; }))
    throw studies::InputError(
        "a word of the command line is empty: is there a variable of the shell that is not set?");
  try {
    program.parse(argc, argv);
  } catch (const CLI::RuntimeError& tested) {
    return tested.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return tools::refuse_words(program, error, {"command", "shape"});
  }
  studies::let_writes_fail();
  for (const tools::Command& command : commands) {
    if (!*command.app) continue;
    ranks.begin(command.app->get_name());
    return command.run();
  }
  return tools::exit_bad_input;
}

}  // namespace

int main(int argc, char** argv) {
  keep_memory();
  const int code = tools::exit_code_of([&] {
    tools::become_one_of_many(argv);
    tools::RanksAtWork ranks;
    if (ranks.is_first()) return run(argc, argv, ranks);
    ranks.serve();
    return 0;
  });
  if (std::fflush(stdout) == 0) return code;
  tools::complain("standard output cannot be written");
  return code == 0 ? tools::exit_bad_input : code;
}
