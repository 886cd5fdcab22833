// The commands of sbeh, a file each: its options, what `sbeh check` says of its input, and what it does.
#pragma once

#include "tools/commands/command.h"

namespace sbeh::tools {

Command add_scan(CLI::App& program);
Command add_relax(CLI::App& program);
Command add_run(CLI::App& program);
Command add_check(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_stability(CLI::App& program);
Command add_seifert(CLI::App& program);
Command add_report(CLI::App& program);
Command add_figures(CLI::App& program);
Command add_modes(CLI::App& program);
Command add_states(CLI::App& program);
Command add_diagram(CLI::App& program);
Command add_mesh(CLI::App& program);
Command add_shape(CLI::App& program);
Command add_picture(CLI::App& program);
Command add_units(CLI::App& program);
Command add_sweep(CLI::App& program);

/// In the order of the help.
inline constexpr Command (*all_commands[])(CLI::App& program) = {
    add_scan,      add_relax, add_run,    add_sweep,   add_check,   add_compare,
    add_stability, add_modes, add_states, add_diagram, add_seifert, add_report,
    add_figures,   add_shape, add_mesh,   add_picture, add_units};

// What an input asks for, printed; each throws studies::InputError if it is wrong.
void check_scan(const std::string& file);
void check_relax(const std::string& file);
void check_run(const std::string& file);
void check_compare(const std::string& file);
void check_stability(const std::string& file);
void check_modes(const std::string& file);
void check_states(const std::string& file);
void check_diagram(const std::string& file);
void check_sweep(const std::string& file);

}  // namespace sbeh::tools
