// `sbeh compare`: one case by several methods.
#include "studies/compare/compare.h"

#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace {

int compare(const Study& study) {
  const studies::CompareInput input = studies::read_compare(study.input);
  const std::filesystem::path folder = study.results();
  const studies::CompareSummary s = studies::run_compare(input, folder, SBEH_VERSION);
  fmt::print("{} {}, reduced volume {}, L = {}\n{}tables in {}\n", sbeh::name(input.state.model),
             name(input.state.branch), input.state.reduced_volume, input.state.L(),
             studies::table_of(s), folder.string());
  if (!study.no_pictures) draw_results(studies::ResultsKind::compare, folder);
  for (const std::string& sentence : studies::complaints(s)) complain(sentence);
  return s.agrees() ? exit_code_of_success() : 1;
}

}  // namespace

Command add_compare(CLI::App& program) {
  return add_study(program, studies::InputKind::compare, "one case by several methods", compare);
}

void check_compare(const std::string& file) {
  const studies::CompareInput input = studies::read_compare(file);
  const bool runs_3d = input.has(studies::Witness::surface3d) && input.surface3d.run.empty();
  // Measured on one core of 2026, from an ellipsoid with V_r = 0.8 to rest.
  const bool solves_3d = input.has(studies::Witness::states);
  const double seconds = 0.1 + (runs_3d ? 0.2 + 0.0085 * input.surface3d.triangles : 0)
                       + (solves_3d ? 0.002 * input.surface3d.triangles : 0);
  fmt::print(
      "{}: {} {} with reduced volume {} and L = {} by {} methods, about {} of one core\n\n{}", file,
      sbeh::name(input.state.model), name(input.state.branch), input.state.reduced_volume,
      input.state.L(), input.methods.size(), duration(seconds),
      studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
