// How both programs refuse what they cannot do: one line that begins with "sbeh: ", and the exit code.
#pragma once

#include <CLI/CLI.hpp>

#include <array>
#include <functional>
#include <string_view>

namespace sbeh::tools {

inline constexpr int exit_failed = 1, exit_bad_input = 2;

/// Writes "sbeh: what" to standard error.
void complain(std::string_view what);

/// The words of the command line could not be read, or ask for help: what there is to say of that, with what an unknown
/// word may have meant; the exit code. `subcommands`: what those of the program and those below them are called.
int refuse_words(const CLI::App& program, const CLI::ParseError& error,
                 const std::array<const char*, 2>& subcommands);

/// The exit code of `work`; complains of what it throws.
int exit_code_of(const std::function<int()>& work);
int exit_code_of_interrupt();

}  // namespace sbeh::tools
