// `sbeh diagram`: the classical phase diagrams of SSH.
#include "studies/diagram/diagram.h"

#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace {

// A kind stands for its whole diagram.
studies::DiagramInput input_of(const std::string& word) {
  const auto kind = value_named<studies::DiagramKind>(word);
  if (!kind) return studies::read_diagram(word);
  return {.kind = *kind, .values = studies::usual_values(*kind)};
}

int diagram(const Study& study) {
  const studies::DiagramInput input = input_of(study.input);
  const std::filesystem::path folder = study.results();
  const studies::DiagramSummary s = studies::run_diagram(input, folder, SBEH_VERSION);
  fmt::print("{}{} states, {} bifurcations in {} in {:.0f} s\n", studies::table_of(s), s.states,
             s.bifurcations.size(), folder.string(), s.seconds);
  for (const double value : s.missing) complain(fmt::format("no branch at {}", value));
  if (s.interrupted) {
    complain("interrupted: the values that were done are in the tables");
    return exit_code_of_interrupt();
  }
  if (!study.no_pictures) draw_results(studies::ResultsKind::diagram, folder);
  return exit_code_of_success();
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
