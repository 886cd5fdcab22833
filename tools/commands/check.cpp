// `sbeh check`: whether an input is right, and what it asks for.
#include "studies/io/errors.h"
#include "studies/parameters/input_kind.h"
#include "studies/report/path_kind.h"
#include "tools/commands/commands.h"

#include <stdexcept>

namespace sbeh::tools {

namespace {

void check(const std::string& file) {
  switch (studies::kind_of(file)) {
    case studies::InputKind::scan:
      return check_scan(file);
    case studies::InputKind::relax:
      return check_relax(file);
    case studies::InputKind::run:
      return check_run(file);
    case studies::InputKind::compare:
      return check_compare(file);
    case studies::InputKind::stability:
      return check_stability(file);
    case studies::InputKind::modes:
      return check_modes(file);
    case studies::InputKind::states:
      return check_states(file);
    case studies::InputKind::diagram:
      return check_diagram(file);
    case studies::InputKind::sweep:
      return check_sweep(file);
  }
}

}  // namespace

Command add_check(CLI::App& program) {
  const auto file = std::make_shared<std::string>();
  CLI::App* app =
      program.add_subcommand("check", "say whether an input is right, and what it asks for");
  app->add_option("FILE", *file, "input (TOML)")->required();
  return {app, [file] {
            try {
              check(*file);
              return 0;
            } catch (const studies::InputError&) {
              studies::refuse_other_kind(*file, "check");
              throw;
            } catch (const std::invalid_argument& error) {  // only the start itself could tell
              throw studies::InputError(fmt::format("{}: {}", *file, error.what()));
            }
          }};
}

}  // namespace sbeh::tools
