// `sbeh relax`: one axisymmetric evolution.
#include "studies/evolution/relax.h"

#include "axisym/diagnostics.h"
#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace {

int relax(const Study& study) {
  const studies::RelaxInput input = studies::read_relax(study.input);
  const std::filesystem::path folder = study.results();
  const studies::RelaxSummary s = studies::run_relax(input, folder, SBEH_VERSION);
  const axisym::FlowRecord& last = s.run.last;
  fmt::print(
      "{} at t = {:.6g} after {} steps ({} rejected): energy {:.10g}\n"
      "history in {}, {} profiles beside it\n",
      axisym::describe(s.run.stop), last.time, s.run.steps, last.rejected, last.energy.total(),
      (folder / "series.csv").string(), s.profiles);
  if (s.run.stop == axisym::FlowStop::interrupted) {
    complain(
        fmt::format("interrupted; what is in {} stays there, but an evolution is not resumed: "
                    "to run it again from its start, choose another folder with -o",
                    folder.string()));
    return exit_code_of_interrupt();
  }
  if (!study.no_pictures) draw_results(studies::ResultsKind::relax, folder);
  return s.run.stop == axisym::FlowStop::step_too_small ? 1 : exit_code_of_success();
}

}  // namespace

Command add_relax(CLI::App& program) {
  return add_study(program, "relax", "one axisymmetric evolution", relax);
}

void check_relax(const std::string& file) {
  const studies::RelaxInput input = studies::read_relax(file);
  const studies::RelaxStart start = studies::start_of(input);
  const axisym::Diagnostics d = axisym::diagnose(input.material, start.state);
  fmt::print(
      "{}: an evolution of {} to t = {}, from reduced volume {:.6g}, energy {:.6g}; "
      "{} lines of history{}, {} profiles\n\n{}",
      file, sbeh::name(input.model), input.times.end, d.reduced_volume, d.energy.total(),
      input.times.rows.size(), beside_times(input.times.every_step), input.times.states.size(),
      studies::with_remarks(studies::describe(input, SBEH_VERSION), start.remarks));
}

}  // namespace sbeh::tools
