// The command line of sbeh.

#include "axisym/diagnostics.h"
#include "studies/compare/compare.h"
#include "studies/evolution/relax.h"
#include "studies/evolution/run.h"
#include "studies/evolution/run_cost.h"
#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/io/spelling.h"
#include "studies/parameters/input_kind.h"
#include "studies/report/report.h"
#include "studies/scan/scan.h"
#include "studies/seifert/seifert.h"
#include "studies/stability/stability.h"
#include "tools/commands/figures_command.h"
#include "tools/commands/mesh_command.h"
#include "tools/commands/picture_program.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace sbeh;
using tools::draw;

struct Arguments {
  std::string input, folder;
  std::vector<std::string> picture;
  int threads = 0;
  int elements = 96;
  bool no_pictures = false, resume = false;
};

void complain(std::string_view what) { studies::tell(fmt::format("sbeh: {}\n", what)); }

// `results/NAME` for NAME.toml, unless -o says otherwise.
fs::path folder_of(const Arguments& a) {
  return a.folder.empty() ? fs::path("results") / fs::path(a.input).stem() : fs::path(a.folder);
}

void draw_results(const Arguments& a, const std::string& kind, const fs::path& folder) {
  if (a.no_pictures) return;
  if (draw({kind, folder.string()}) != 0)
    complain(
        fmt::format("no pictures; the tables in {0} are complete. "
                    "Try again with: sbeh picture {1} {0}",
                    folder.string(), kind));
}

int exit_code_of_interrupt() { return 128 + studies::interrupt_signal(); }
// What a program ends with that has done its work, unless it was told to end while drawing.
int exit_code_of_success() { return studies::interrupt_signal() ? exit_code_of_interrupt() : 0; }

int scan(const Arguments& a) {
  const studies::ScanInput input = studies::read_scan(a.input);
  const fs::path folder = folder_of(a);
  const studies::ScanSummary s = studies::run_scan(input, folder, SBEH_VERSION);
  fmt::print("{} points in {}: {} stationary, {} unresolved, {} failed; {} computed in {:.2f} s\n",
             s.points, (folder / "scan.csv").string(), s.stationary, s.unresolved, s.failed,
             s.computed, s.seconds);
  if (s.interrupted) {
    complain("interrupted; the same command goes on from here");
    return exit_code_of_interrupt();
  }
  draw_results(a, "scan", folder);
  return exit_code_of_success();
}

int relax(const Arguments& a) {
  const studies::RelaxInput input = studies::read_relax(a.input);
  const fs::path folder = folder_of(a);
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
  draw_results(a, "relax", folder);
  return s.run.stop == axisym::FlowStop::step_too_small ? 1 : exit_code_of_success();
}

int check_compare(const Arguments& a) {
  const studies::CompareInput input = studies::read_compare(a.input);
  const bool runs_3d = input.has(studies::Witness::surface3d) && input.surface3d.run.empty();
  // Measured on one core of 2026, from an ellipsoid with V_r = 0.8 to rest.
  const double seconds = 1 + (runs_3d ? 0.08 * input.surface3d.triangles : 0);
  fmt::print("{}: {} {} with reduced volume {} and L = {} by {} methods, about {:.0f} s\n\n{}",
             a.input, model::name(input.model), name(input.branch), input.reduced_volume, input.L,
             input.methods.size(), seconds, studies::describe(input, SBEH_VERSION));
  return 0;
}

int run_3d(const Arguments& a) {
  const studies::RunInput input = studies::read_run(a.input);
  const fs::path folder = folder_of(a);
  const studies::RunSummary s = studies::run_surface(input, folder, SBEH_VERSION, a.resume);
  const model::FlowRecord& last = s.run.last;
  fmt::print("{} at t = {:.6g} after {} steps ({} rejected): energy {:.10g}\n",
             model::describe(s.run.stop), last.time, s.run.steps, last.rejected,
             last.energy.total());
  if (s.resumed_from > 0) fmt::print("resumed from t = {:.6g}\n", s.resumed_from);
  fmt::print("history in {}, {} frames: open {} in ParaView\n", (folder / "series.csv").string(),
             s.frames, (folder / "run.pvd").string());
  if (s.run.stop == model::FlowStop::interrupted) {
    complain("interrupted; the same command with --resume goes on from here");
    return exit_code_of_interrupt();
  }
  if (s.unresolved_from)
    complain(
        fmt::format("unresolved from t = {:.6g}: what comes later is not to be trusted, see {}",
                    *s.unresolved_from, (folder / "events.csv").string()));
  if (s.run.stop == model::FlowStop::step_too_small) complain(model::describe(s.run.fault));
  if (s.run.stop == model::FlowStop::unresolved)
    complain(
        "the triangles degenerate; the last frame is the last state: try more triangles, remesh = "
        "true in [numerics], or a residual_stiffness where the order vanishes");
  if (s.run.stop == model::FlowStop::self_contact)
    complain(
        "the surface comes nearer to itself than its nodes are to each other; nothing in the model "
        "keeps it from passing through, so that the run ends here");
  draw_results(a, "run", folder);
  const bool wrong = s.run.stop == model::FlowStop::step_too_small
                  || s.run.stop == model::FlowStop::unresolved
                  || s.run.stop == model::FlowStop::self_contact;
  return wrong ? 1 : exit_code_of_success();
}

// What an evolution's history has besides the rows of the output times.
const char* beside_times(const auto& input) {
  return input.times.every_step ? " and one for each step" : "";
}

int check_run(const Arguments& a) {
  const studies::RunInput input = studies::read_run(a.input);
  const studies::RunStart start = studies::start_of(input);
  const int triangles = start.mesh.triangle_count();
  const studies::RunCost cost = studies::cost_of(input, triangles);
  fmt::print(
      "{}: a 3D run of {} to t = {}, reduced volume {:.6g}, {} triangles, {} unknowns; about "
      "{:.2g} s "
      "a step and {:.0f} MB of memory; {} lines of history{}, {} frames of {:.2f} MB\n\n{}",
      a.input, model::name(input.model), input.times.end,
      surface3d::reduced_volume(start.target.area, start.target.volume), triangles, cost.unknowns,
      cost.seconds_per_step, cost.megabytes, input.times.rows.size(), beside_times(input),
      input.times.states.size(), cost.frame_megabytes, studies::describe(input, SBEH_VERSION));
  return 0;
}

int check_stability(const Arguments& a) {
  const studies::StabilityInput input = studies::read_stability(a.input);
  const std::vector<studies::StabilityKey> runs = studies::keys_of(input);
  double steps = 0;
  for (const studies::StabilityKey& key : runs)
    steps += input.end_time / input.material.with_L(key.L).kappa(model::full_order)
           / input.numerics_3d.largest_step;
  const double minutes = 4.3e-4 * input.triangles * steps / 60;  // measured on one core of 2026
  fmt::print(
      "{}: {} runs of perturbed states with about {} triangles, at most about {:.0f} min of one "
      "core\n\n{}",
      a.input, runs.size(), input.triangles, std::max(1., minutes),
      studies::describe(input, SBEH_VERSION));
  return 0;
}

int check(const Arguments& a) {
  const studies::InputKind kind = studies::kind_of(a.input);
  if (kind == studies::InputKind::compare) return check_compare(a);
  if (kind == studies::InputKind::run) return check_run(a);
  if (kind == studies::InputKind::stability) return check_stability(a);
  if (kind == studies::InputKind::scan) {
    const studies::ScanInput input = studies::read_scan(a.input);
    const std::size_t points = studies::point_count(input);
    // About 10 ms a point by Newton, 1 s by the flow, on one core of 2026; 20 kB a profile.
    const double seconds = double(points) * (input.method == studies::Method::newton ? 0.01 : 1);
    fmt::print("{}: a scan of {} points by {}, about {:.0f} s of one core and {:.1f} MB\n\n{}",
               a.input, points, studies::name(input.method), std::max(1., seconds),
               double(points) * 0.02, studies::describe(input, SBEH_VERSION));
    return 0;
  }
  const studies::RelaxInput input = studies::read_relax(a.input);
  const studies::RelaxStart start = studies::start_of(input);
  const axisym::Diagnostics d = axisym::diagnose(start.material, start.state);
  fmt::print(
      "{}: an evolution of {} to t = {}, from reduced volume {:.6g}, energy {:.6g}; "
      "{} lines of history{}, {} profiles\n\n{}",
      a.input, model::name(input.model), input.times.end, d.reduced_volume, d.energy.total(),
      input.times.rows.size(), beside_times(input), input.times.states.size(),
      studies::describe(input, SBEH_VERSION));
  return 0;
}

int seifert(const Arguments& a) {
  const fs::path folder = a.folder.empty() ? fs::path("results/seifert") : fs::path(a.folder);
  fmt::print("{}", studies::table_of(studies::run_seifert(folder, a.elements)));
  fmt::print("tables in {}\n", folder.string());
  draw_results(a, "seifert", folder);
  return 0;
}

int compare(const Arguments& a) {
  const studies::CompareInput input = studies::read_compare(a.input);
  const fs::path folder = folder_of(a);
  const studies::CompareSummary s = studies::run_compare(input, folder, SBEH_VERSION);
  fmt::print("{} {}, reduced volume {}, L = {}\n{}tables in {}\n", model::name(input.model),
             name(input.branch), input.reduced_volume, input.L, studies::table_of(s),
             folder.string());
  draw_results(a, "compare", folder);
  for (const std::string& sentence : studies::complaints(s)) complain(sentence);
  return s.agrees() ? exit_code_of_success() : 1;
}

int stability(const Arguments& a) {
  const studies::StabilityInput input = studies::read_stability(a.input);
  const fs::path folder = folder_of(a);
  const studies::StabilitySummary s = studies::run_stability(input, folder, SBEH_VERSION);
  fmt::print("{}{} runs in {}; {} computed in {:.0f} s\n", studies::table_of(s), s.rows.size(),
             (folder / "stability.csv").string(), s.computed, s.seconds);
  if (s.interrupted) {
    complain("interrupted; the same command goes on from here");
    return exit_code_of_interrupt();
  }
  draw_results(a, "stability", folder);
  return exit_code_of_success();
}

int report(const Arguments& a) {
  const fs::path folder = a.input;
  const studies::ResultsKind kind = studies::kind_of_results(folder);
  if (!a.no_pictures)
    for (const std::string& picture : studies::missing_pictures(folder, kind))
      if (draw({studies::name(kind), folder.string(), "--only", picture}) != 0)
        complain(fmt::format("{}: cannot be drawn; the report is without it", picture));
  const studies::ReportSummary s = studies::write_report(folder, SBEH_VERSION);
  fmt::print("{} {}\n", s.replaced ? "replaced the earlier report" : "wrote", s.file.string());
  return 0;
}

// The words of the command line that CLI11 did not take, with what may have been meant.
int complain_of_command_line(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* at = &app;  // the command they belong to
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  const std::vector<std::string> rest = app.remaining(true);
  const bool has_commands = !at->get_subcommands({}).empty();
  if (!has_commands || rest.empty()) return app.exit(error) == 0 ? 0 : 2;
  const std::string& word = rest.front();
  const bool option = word.starts_with('-');
  std::vector<std::string> known;
  if (option)
    known = {"--help", "--version"};
  else
    for (const CLI::App* command : at->get_subcommands({})) known.push_back(command->get_name());
  const auto meant = studies::nearest(word, known);
  complain(fmt::format("{}: unknown {}{} Known: {}", word,
                       option       ? "option"
                       : at == &app ? "command"
                                    : "shape",
                       meant ? fmt::format("; did you mean {}?", *meant) : ".",
                       fmt::join(known, ", ")));
  return 2;
}

int run(int argc, char** argv) {
  CLI::App app{"Shapes and dynamics of fluid lipid membranes with liquid-crystalline order.",
               "sbeh"};
  app.set_version_flag("--version", SBEH_VERSION);
  app.require_subcommand(1);
  Arguments a;
  const auto add = [&](const char* name, const char* text, bool runs) {
    CLI::App* command = app.add_subcommand(name, text);
    command->add_option("FILE", a.input, "input (TOML)")->required();
    if (!runs) return command;
    command->add_option("-o,--output", a.folder, "folder for the results (results/NAME)");
    command->add_flag("--no-pictures", a.no_pictures, "tables only");
    command->add_option("--threads", a.threads, "at most so many (all cores)")
        ->check(CLI::Range(1, 4096));
    return command;
  };
  const CLI::App* scan_command = add("scan", "stationary shapes over a (V_r, L) grid", true);
  const CLI::App* relax_command = add("relax", "one axisymmetric evolution", true);
  CLI::App* run_command = add("run", "one 3D evolution", true);
  run_command->add_flag("--resume", a.resume, "go on with a run that was interrupted or killed");
  const CLI::App* check_command =
      add("check", "say whether an input is right, and what it asks for", false);
  const CLI::App* compare_command = add("compare", "one case by several methods", true);
  const CLI::App* stability_command =
      add("stability", "axisymmetric states, perturbed in 3D", true);
  CLI::App* seifert_command =
      app.add_subcommand("seifert", "the classical diagram by three witnesses");
  seifert_command->add_option("-o,--output", a.folder, "folder for the results (results/seifert)");
  seifert_command->add_flag("--no-pictures", a.no_pictures, "tables only");
  seifert_command->add_option("--elements", a.elements, "of the finite elements (96)")
      ->check(CLI::Range(32, 4096));
  CLI::App* report_command =
      app.add_subcommand("report", "a folder of results as one page of HTML");
  report_command
      ->add_option("DIR", a.input, "folder of a scan, run, relax, seifert, compare or stability")
      ->required();
  report_command->add_flag("--no-pictures", a.no_pictures, "do not draw those that are missing");
  const tools::FiguresCommand figures_command(app);
  const tools::MeshCommand mesh_command(app);
  CLI::App* picture_command = app.add_subcommand("picture",
                                                 "draw the pictures of a folder again: picture "
                                                 "scan|relax|run|seifert|compare|figures|stability "
                                                 "DIR");
  picture_command->prefix_command();
  picture_command->set_help_flag();  // `sbeh picture --help` is the picture program's
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return complain_of_command_line(app, error);
  }
  if (*picture_command) return draw(picture_command->remaining());

  studies::let_writes_fail();
  if (*scan_command || *relax_command || *run_command || *compare_command || *stability_command
      || figures_command.parsed())
    studies::catch_interrupts();
  std::unique_ptr<tbb::global_control> limit;
  if (a.threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  std::size_t(a.threads));
  try {
    if (*scan_command) return scan(a);
    if (*relax_command) return relax(a);
    if (*run_command) return run_3d(a);
    if (*compare_command) return compare(a);
    if (*stability_command) return stability(a);
    if (*check_command) return check(a);
    if (*seifert_command) return seifert(a);
    if (*report_command) return report(a);
    if (figures_command.parsed()) return figures_command.run();
    if (app.got_subcommand("mesh")) return mesh_command.run();
  } catch (const std::invalid_argument& error) {  // only the start itself could tell
    throw studies::InputError(fmt::format("{}: {}", a.input, error.what()));
  }
  return 2;
}

int run_and_report(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const studies::InputError& error) {
    complain(error.what());
    return 2;
  } catch (const studies::OutputError& error) {
    complain(error.what());
    return 2;
  } catch (const studies::Interrupted&) {
    complain("interrupted; nothing is kept, the same command begins again");
    return exit_code_of_interrupt();
  } catch (const std::exception& error) {
    complain(error.what());
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int code = run_and_report(argc, argv);
  if (std::fflush(stdout) == 0) return code;
  complain("standard output cannot be written");
  return code == 0 ? 2 : code;
}
