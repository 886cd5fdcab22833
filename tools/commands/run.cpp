// `sbeh run`: one 3D evolution.
#include "studies/evolution/run.h"

#include "model/relaxation.h"
#include "studies/evolution/run_start.h"
#include "studies/io/errors.h"
#include "studies/rest_states/run_end.h"
#include "tools/commands/commands.h"
#include "tools/commands/evolution_end.h"

namespace sbeh::tools {

namespace {

namespace fs = std::filesystem;
using model::FlowStop;

constexpr EndWords run_words{
    .unresolved =
        "the triangles degenerate; the last frame is the last state: try more triangles, remesh = "
        "true in [numerics], or a residual_stiffness where the order vanishes",
    .self_contact =
        "the surface comes nearer to itself than its nodes are to each other; nothing in the model "
        "keeps it from passing through, so that the run ends here"};

// Whether something was wrong with it.
bool end_at_rest(const studies::RunInput& input, const studies::RunSummary& summary,
                 const Study& study, const fs::path& folder) {
  const auto rest = studies::rest_of_run(input, summary, folder, SBEH_VERSION);
  if (!rest) return false;
  const fs::path states = folder / studies::rest_folder;
  if (rest->measures)
    fmt::print("at rest by Newton's method: {}; in {}\n", studies::describe_rest(*rest),
               (states / "states.csv").string());
  if (rest->status != studies::PointStatus::stationary)
    complain(fmt::format("state at rest {}: {}", sbeh::name(rest->status), rest->stop_reason));
  if (!study.no_pictures) draw_results(studies::ResultsKind::states, states);
  return rest->status != studies::PointStatus::stationary;
}

int run(const Study& study, bool resume) {
  const fs::path folder = study.results();
  const studies::RunInput input =
      resume ? studies::read_resumed_run(study.input, folder) : studies::read_run(study.input);
  const studies::RunSummary s = studies::run_surface(input, folder, SBEH_VERSION, resume);
  print_end(s.run.stop, s.run.last, s.run.steps,
            model::speed_at_rest(input.numerics.rest_speed, input.material, input.model));
  if (s.resumed_from > 0) fmt::print("resumed from t = {:.6g}\n", s.resumed_from);
  fmt::print("history in {}, {} frames: open {} in ParaView\n", (folder / "series.csv").string(),
             s.frames, (folder / "run.pvd").string());
  if (s.run.stop == FlowStop::interrupted) {
    complain("interrupted; the same command with --resume goes on from here");
    return exit_code_of_interrupt();
  }
  if (s.unresolved_from)
    complain(
        fmt::format("unresolved from t = {:.6g}: what comes later is not to be trusted, see {}",
                    *s.unresolved_from, (folder / "events.csv").string()));
  const bool wrong = complain_of_end(s.run.stop, s.run.fault, s.run.last, run_words);
  if (!study.no_pictures) draw_results(studies::ResultsKind::run, folder);
  try {
    const bool restless = end_at_rest(input, s, study, folder);
    return wrong || restless ? 1 : exit_code_of_success();
  } catch (const studies::Interrupted&) {
    complain("interrupted; the same command with --resume goes on from here");
    return exit_code_of_interrupt();
  }
}

}  // namespace

Command add_run(CLI::App& program) {
  const auto resume = std::make_shared<bool>(false);
  Command command = add_study(program, studies::InputKind::run, "one 3D evolution",
                              [resume](const Study& study) { return run(study, *resume); });
  command.app->add_flag("--resume", *resume, "go on with a run that was interrupted or killed");
  return command;
}

void check_run(const std::string& file) {
  const studies::RunInput input = studies::read_run(file);
  const auto [start, remarks] = studies::start_of(input);
  const int triangles = start.mesh->count();
  const studies::RunCost cost = studies::cost_of(input, triangles);
  fmt::print(
      "{}: a 3D run of {} to t = {}, reduced volume {:.6g}, {} triangles, {} unknowns; about "
      "{:.2g} s "
      "a step and {:.0f} MB of memory; {} lines of history{}, {} frames of {:.2f} MB\n\n{}",
      file, sbeh::name(input.model), input.times.end,
      surface3d::reduced_volume(start.target.area, start.target.volume), triangles, cost.unknowns,
      cost.seconds_per_step, cost.megabytes, input.times.rows.size(),
      beside_times(input.times.every_step), input.times.states.size(), cost.frame_megabytes,
      studies::with_remarks(studies::describe(input, SBEH_VERSION), remarks));
}

}  // namespace sbeh::tools
