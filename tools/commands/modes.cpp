// `sbeh modes`: the modes of one stationary state.
#include "studies/modes/modes.h"

#include "studies/io/errors.h"
#include "studies/parameters/material_input.h"
#include "tools/commands/commands.h"

#include <algorithm>

namespace sbeh::tools {

namespace {

using studies::InputError;
using studies::ModesInput;

// Instead of FILE, or over it.
struct ModesWords {
  std::string scan, model, branch;
  std::optional<double> reduced_volume, L, fluctuations;
  std::optional<int> largest_m, number;
};

void take_state(const ModesWords& w, ModesInput& input) {
  if (!w.reduced_volume || !w.L)
    throw InputError(
        "modes: of which state? Give FILE, or --reduced-volume and --L with --model and --branch; "
        "with --scan DIR it is the row of that scan");
  if (*w.reduced_volume == 1)
    throw InputError(fmt::format("--reduced-volume 1: {}", studies::no_sphere));
  axisym::StationaryCase& state = input.state;
  if (!w.scan.empty()) studies::require_folder(w.scan);
  input.scan = w.scan;
  if (!w.model.empty()) state.model = *value_named<model::Model>(w.model);
  if (!w.branch.empty()) state.branch = *value_named<axisym::Branch>(w.branch);
  state.reduced_volume = *w.reduced_volume;
  state.material.L1 = *w.L;
  if (!input.scan.empty()) studies::take_from_scan(input);
}

ModesInput input_of(const std::string& file, const ModesWords& w) {
  ModesInput input;
  if (file.empty())
    take_state(w, input);
  else
    input = studies::read_modes(file);
  input.largest_m = w.largest_m.value_or(input.largest_m);
  input.number = w.number.value_or(input.number);
  input.thermal_energy = w.fluctuations.value_or(input.thermal_energy);
  return input;
}

int modes(const Study& asked, const ModesWords& words) {
  Study study = asked;
  if (study.input.empty() && study.folder.empty()) study.folder = "results/modes";
  const ModesInput input = input_of(study.input, words);
  const std::filesystem::path folder = study.results();
  const studies::ModesSummary summary = studies::run_modes(input, folder, SBEH_VERSION);
  fmt::print("{}{} modes in {}\n", studies::table_of(input, summary), summary.modes.size(),
             (folder / "modes.csv").string());
  for (const std::string& warning : summary.warnings) complain(warning);
  return finish(study, studies::ResultsKind::modes, false);
}

template <class Values>
CLI::IsMember one_of(const Values& values) {
  std::vector<std::string> words;
  words.reserve(std::size(values));
  for (const auto value : values) words.emplace_back(name(value));
  return CLI::IsMember(words);
}

// As in an input, whose ranges these are.
CLI::Validator in(const studies::Interval& allowed) {
  return {[allowed](const std::string& text) {
            double value = 0;
            const bool ok = studies::parse_number(text, value) && allowed.contains(value);
            return ok ? std::string() : fmt::format("{}: must be {}", text, allowed.text());
          },
          allowed.text()};
}

}  // namespace

Command add_modes(CLI::App& program) {
  const auto words = std::make_shared<ModesWords>();
  ModesWords& w = *words;
  Command command = add_study(
      program, studies::InputKind::modes,
      "the modes of one stationary state: what is stable in 3D, how fast, how it fluctuates",
      [words](const Study& study) { return modes(study, *words); });
  CLI::App& app = *command.app;
  CLI::Option* file = app.get_option("FILE")->required(false);
  for (CLI::Option* option :
       {app.add_option("--scan", w.scan, "folder of a scan, whose row is the state"),
        app.add_option("--model", w.model, "SBEH or SSH (SBEH)")
            ->check(one_of(studies::rest_models)),
        app.add_option("--branch", w.branch, "oblate, prolate, stomatocyte or pear (oblate)")
            ->check(one_of(values_of(axisym::Branch{}))),
        app.add_option("--reduced-volume", w.reduced_volume, "of the state, < 1")
            ->check(in(studies::reduced_volumes)),
        app.add_option("--L", w.L, "elastic constant")->check(in(studies::above(0)))})
    option->excludes(file);
  app.add_option("--largest-m", w.largest_m, "modes go with cos m phi, m = 0 up to this (5)")
      ->check(CLI::Range(0, studies::largest_mode_m));
  app.add_option("--number", w.number, "so many of each m and parity (1), and all unstable ones")
      ->check(CLI::Range(1, studies::most_mode_number));
  app.add_option("--fluctuations", w.fluctuations, "thermal energy k_B T, in units of the model")
      ->check(in(studies::at_least(0)));
  return command;
}

void check_modes(const std::string& file) {
  const ModesInput input = studies::read_modes(file);
  const studies::ModesCost cost = studies::cost_of(input);
  fmt::print("{}: about {} modes of one state, {} of one core and {:.0f} MB\n\n{}", file,
             cost.modes, duration(cost.seconds), std::max(1., cost.megabytes),
             studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
