// `sbeh diagram`: the classical phase diagrams of SSH.
#include "studies/diagram/diagram.h"

#include "studies/io/errors.h"
#include "tools/commands/commands.h"

#include <fmt/ranges.h>

namespace sbeh::tools {

namespace {

// A kind stands for its whole diagram.
studies::DiagramInput input_of(const std::string& word) {
  const auto kind = value_named<studies::DiagramKind>(word);
  if (kind) return {.kind = *kind, .values = studies::usual_values(*kind)};
  if (!std::filesystem::exists(word))
    throw studies::InputError(fmt::format("{}: is no file, and no diagram: these are {}", word,
                                          fmt::join(names(studies::DiagramKind{}), ", ")));
  return studies::read_diagram(word);
}

int diagram(const Study& study) {
  const studies::DiagramInput input = input_of(study.input);
  const std::filesystem::path folder = study.results();
  const studies::DiagramSummary s = studies::run_diagram(input, folder, SBEH_VERSION);
  fmt::print("{}{} states and {} special ones at {} values in {}; {} values computed in {:.0f} s\n",
             studies::table_of(s), s.states, s.bifurcations.size(), input.values.size(),
             folder.string(), s.computed, s.seconds);
  if (!s.missing.empty())
    complain(fmt::format("no branch was found at {}", fmt::join(s.missing, ", ")));
  return finish(study, studies::ResultsKind::diagram, s.interrupted);
}

}  // namespace

Command add_diagram(CLI::App& program) {
  return add_study(program, studies::InputKind::diagram,
                   "a classical phase diagram: FILE, or spontaneous-curvature, bilayer-coupling, "
                   "area-difference",
                   diagram);
}

void check_diagram(const std::string& file) {
  const studies::DiagramInput input = studies::read_diagram(file);
  fmt::print("{}: the {} diagram at {} value{}, {} of one core\n\n{}", file, name(input.kind),
             input.values.size(), input.values.size() == 1 ? "" : "s",
             duration(4. * double(input.values.size())), studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
