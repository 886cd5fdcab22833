// A word of the command line that nobody knows.
#pragma once

#include <CLI/CLI.hpp>

#include <array>
#include <string>

namespace sbeh::tools {

/// What is said of the first word that CLI11 did not take, with what may have been meant; empty where it took all.
/// `subcommands`: what those of the program and those below them are called.
std::string about_unknown_word(const CLI::App& program,
                               const std::array<const char*, 2>& subcommands);

}  // namespace sbeh::tools
