#include "tools/refusals.h"

#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace sbeh::tools {

namespace {

using Words = std::vector<std::string>;

std::string about(const std::string& word, const char* what, const Words& known, bool list) {
  const auto meant = studies::nearest(word, known);
  return fmt::format("{}: unknown {}{}{}", word, what,
                     meant ? fmt::format("; did you mean {}?", *meant) : ".",
                     list ? fmt::format(" Known: {}", fmt::join(known, ", ")) : "");
}

Words options_of(const CLI::App& command) {
  Words names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

Words subcommands_of(const CLI::App& command) {
  Words names;
  for (const CLI::App* subcommand : command.get_subcommands({}))
    names.push_back(subcommand->get_name());
  return names;
}

// Of the first word that CLI11 did not take; empty where it took all.
std::string about_unknown_word(const CLI::App& program,
                               const std::array<const char*, 2>& subcommands) {
  const CLI::App* at = &program;  // the command they belong to
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  const Words rest = program.remaining(true);
  const auto option = std::ranges::find_if(rest, [](const auto& w) { return w.starts_with('-'); });
  const bool is_program = at == &program;
  if (option != rest.end()) return about(*option, "option", options_of(*at), is_program);
  const Words below = subcommands_of(*at);
  if (below.empty() || rest.empty()) return {};
  return about(rest.front(), subcommands[is_program ? 0 : 1], below, true);
}

}  // namespace

void complain(std::string_view what) { studies::tell(fmt::format("sbeh: {}\n", what)); }

int refuse_words(const CLI::App& program, const CLI::ParseError& error,
                 const std::array<const char*, 2>& subcommands) {
  if (error.get_exit_code() == 0) return program.exit(error);  // --help
  const std::string unknown = about_unknown_word(program, subcommands);
  complain(unknown.empty() ? fmt::format("{}; see --help", error.what()) : unknown);
  return exit_bad_input;
}

int exit_code_of_interrupt() { return 128 + studies::interrupt_signal(); }

int exit_code_of(const std::function<int()>& work) {
  try {
    return work();
  } catch (const studies::InputError& error) {
    complain(error.what());
    return exit_bad_input;
  } catch (const studies::OutputError& error) {
    complain(error.what());
    return exit_bad_input;
  } catch (const studies::Interrupted&) {
    complain("interrupted; nothing is kept, the same command begins again");
    return exit_code_of_interrupt();
  } catch (const std::exception& error) {
    complain(error.what());
    return exit_failed;
  }
}

}  // namespace sbeh::tools
