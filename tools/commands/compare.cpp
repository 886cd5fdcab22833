// `sbeh compare`: one case by several methods.
#include "studies/compare/compare.h"

#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace {

std::string title_of(const studies::CompareInput& input) {
  if (input.evolution)
    return fmt::format("the evolution of {} ({}) to t = {:.4g}",
                       input.evolution->file.empty() ? "[evolution]" : input.evolution->file,
                       sbeh::name(input.state.model), input.evolution->run.times.end);
  return fmt::format("{} {}, reduced volume {}, L = {}", sbeh::name(input.state.model),
                     name(input.state.branch), input.state.reduced_volume, input.state.L());
}

int compare(const Study& study) {
  const studies::CompareInput input = studies::read_compare(study.input);
  const std::filesystem::path folder = study.results();
  const studies::CompareSummary s = studies::run_compare(input, folder, SBEH_VERSION);
  fmt::print("{}\n{}tables in {}\n", title_of(input), studies::table_of(s), folder.string());
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
  if (input.evolution) {
    fmt::print("{}: {} by {} methods\n\n{}", file, title_of(input), input.methods.size(),
               studies::describe(input, SBEH_VERSION));
    return;
  }
  const bool runs_3d = input.has(studies::Witness::surface3d) && input.surface3d.run.empty();
  // Measured on one core of 2026, from an ellipsoid with V_r = 0.8 to rest.
  const bool solves_3d = input.has(studies::Witness::states);
  const double seconds = 0.1 + (runs_3d ? 0.2 + 0.0085 * input.surface3d.triangles : 0)
                       + (solves_3d ? 0.002 * input.surface3d.triangles : 0);
  fmt::print("{}: {} by {} methods, about {} of one core\n\n{}", file, title_of(input),
             input.methods.size(), duration(seconds), studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
