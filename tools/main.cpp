// The command line of sbeh.

#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "tools/commands/commands.h"
#include "tools/unknown_word.h"

#include <malloc.h>

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
    const std::string unknown = tools::about_unknown_word(program, {"command", "shape"});
    if (unknown.empty()) return program.exit(error) == 0 ? 0 : 2;
    complain(unknown);
    return 2;
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
