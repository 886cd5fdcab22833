// `sbeh relax`: one axisymmetric evolution.
#include "studies/evolution/relax.h"

#include "axisym/diagnostics.h"
#include "model/relaxation.h"
#include "tools/commands/commands.h"
#include "tools/commands/evolution_end.h"

namespace sbeh::tools {

namespace {

constexpr EndWords relax_words{
    .unresolved =
        "a rim or a neck becomes sharper than the elements resolve; the last profile is the "
        "last state: try more elements in [numerics], or a residual_stiffness where the "
        "order vanishes",
    .self_contact =
        "the surface passes through itself, which nothing in the model keeps it from, so "
        "that the run ends here; the last profile is the first that does"};

int relax(const Study& study) {
  const studies::RelaxInput input = studies::read_relax(study.input);
  const std::filesystem::path folder = study.results();
  const studies::RelaxSummary s = studies::run_relax(input, folder, SBEH_VERSION);
  print_end(s.run.stop, s.run.last, s.run.steps,
            model::speed_at_rest(input.numerics.rest_speed, input.material, input.model));
  fmt::print("history in {}, {} profiles beside it\n", (folder / "series.csv").string(),
             s.profiles);
  if (s.run.stop == axisym::FlowStop::interrupted) {
    complain(
        fmt::format("interrupted; what is in {} stays there, but an evolution is not resumed: "
                    "to run it again from its start, choose another folder with -o",
                    folder.string()));
    return exit_code_of_interrupt();
  }
  const bool wrong = complain_of_end(s.run.stop, s.run.fault, s.run.last, relax_words);
  if (!study.no_pictures) draw_results(studies::ResultsKind::relax, folder);
  return wrong ? 1 : exit_code_of_success();
}

}  // namespace

Command add_relax(CLI::App& program) {
  return add_study(program, studies::InputKind::relax, "one axisymmetric evolution", relax);
}

void check_relax(const std::string& file) {
  const studies::RelaxInput input = studies::read_relax(file);
  const studies::RelaxStart start = studies::start_of(input);
  const axisym::Diagnostics d = axisym::diagnose(input.material, start.state);
  fmt::print(
      "{}: an evolution of {} to t = {}, from reduced volume {:.6g}, energy {:.6g}; "
      "about {:.2g} ms a step; {} lines of history{}, {} profiles\n\n{}",
      file, sbeh::name(input.model), input.times.end, d.reduced_volume, d.energy.total(),
      1e3 * studies::seconds_per_step(input), input.times.rows.size(),
      beside_times(input.times.every_step), input.times.states.size(),
      studies::with_remarks(studies::describe(input, SBEH_VERSION), start.remarks));
}

}  // namespace sbeh::tools
