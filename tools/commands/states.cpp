// `sbeh states`: rest states in 3D by Newton's method.
#include "studies/rest_states/states.h"

#include "studies/rest_states/rest_start.h"
#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace {

int states(const Study& study) {
  const studies::StatesInput input = studies::read_states(study.input);
  const std::filesystem::path folder = study.results();
  const studies::StatesSummary s = studies::run_states(input, folder, SBEH_VERSION);
  fmt::print("{}{}{} states in {}; {} computed in {:.1f} s\n", studies::table_of(input, s.rows),
             studies::table_of(input, s.passes), s.rows.size(), (folder / "states.csv").string(),
             s.computed, s.seconds);
  return finish(study, studies::ResultsKind::states, s.interrupted);
}

}  // namespace

Command add_states(CLI::App& program) {
  return add_study(program, studies::InputKind::states, "rest states in 3D and their lowest modes",
                   states);
}

void check_states(const std::string& file) {
  const studies::StatesInput input = studies::read_states(file);
  const std::size_t count = studies::places_of(input).size();
  const int triangles =
      studies::brings_its_mesh(input.start)
          ? studies::rest_start(input, studies::places_of(input).front().at).mesh->count()
          : input.triangles;
  fmt::print("{}: {} rest state{} in 3D{} with about {} triangles, about {} of one core\n\n{}",
             file, count, count == 1 ? "" : "s",
             input.follow   ? ", and branches from it,"
             : input.search ? ", and others near it,"
                            : "",
             triangles, duration(studies::seconds_of(input, triangles)),
             studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
