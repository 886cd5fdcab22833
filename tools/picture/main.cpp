// sbeh-picture: the pictures of a scan, of one evolution, of the classical branches, of a comparison, of a
// study of stability or of a mesh, and the paper's figures, from the files they leave.
#include "studies/report/path_kind.h"
#include "studies/report/report.h"
#include "tools/picture/canvas/virtual_display.h"
#include "tools/picture/command_line.h"
#include "tools/picture/evolution/evolution.h"
#include "tools/picture/figures/figures.h"
#include "tools/picture/modes/modes.h"
#include "tools/picture/scan/scan.h"
#include "tools/picture/studies/studies.h"
#include "tools/refusals.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>

namespace sbeh::picture {
namespace {

void draw_scan(Canvas& canvas, const Options& options) {
  const ScanGrid scan(options.directory, options.branch);
  if (scan.branches().size() > 1 && options.branch.empty()) {
    fmt::print(
        "several branches ({}): the pictures show the one of lowest energy at each point; "
        "--branch chooses one\n",
        fmt::join(scan.branches(), ", "));
  }
  if (options.wants("diagram")) draw_diagram_picture(canvas, scan, options);
  if (options.wants("cuts")) draw_cuts_picture(canvas, scan, options);
  if (options.wants("energy")) draw_energy_picture(canvas, scan, options);
}

struct Picture {
  const char* name;  // as in --only
  void (*draw)(Canvas&, const Options&);
};
struct Command {
  const char *name, *description;
  std::vector<Picture> pictures;
  Has has{};
};
const Command commands[] = {
    {"relax",
     "energy, shapes from DIR/series.csv, profiles.csv",
     {{"energy", draw_evolution_energy}, {"shapes", draw_relaxation_shapes}},
     {.energies = true, .fields = true, .frames = true}},
    {"run",
     "energy, shapes from DIR/series.csv, frames.csv",
     {{"energy", draw_evolution_energy}, {"shapes", draw_run_shapes}},
     {.energies = true, .fields = true, .views = true, .frames = true}},
    {"seifert",
     "the classical diagram from DIR/branches.csv, points.csv",
     {{"branches", draw_classical_diagram}},
     {.units = false}},
    {"diagram",
     "a classical phase diagram from DIR/bifurcations.csv, shapes.csv",
     {{"diagram", draw_phase_diagram}},
     {.units = false}},
    {"compare",
     "profiles of all methods from DIR/profiles.csv, or their energies from DIR/histories.csv",
     {{"profiles", draw_compared_profiles}, {"histories", draw_compared_histories}}},
    {"figures",
     "the paper's figures from the tables of `sbeh figures` in DIR",
     {{"energy", draw_figure_energy},
      {"shapes", draw_figure_shapes},
      {"evolution", draw_figure_evolution},
      {"measures", draw_figure_measures}},
     {.energies = true, .fields = true, .views = true, .units = false}},
    {"stability",
     "which states are stable in 3D, from DIR/stability.csv",
     {{"stability", draw_stability}}},
    {"modes",
     "the modes of one state from DIR/modes.csv, modes/, contour.csv",
     {{"profiles", draw_mode_profiles},
      {"surfaces", draw_mode_surfaces},
      {"contour", draw_contour_spectrum}},
     {.fields = true, .views = true}},
    {"states",
     "rest states in 3D from DIR/states.csv, frames/",
     {{"surfaces", draw_rest_surfaces}, {"branches", draw_rest_branches}},
     {.fields = true, .views = true}},
};

void draw(const CLI::App& app, const Options& options) {
  Canvas canvas;
  if (app.got_subcommand("scan")) draw_scan(canvas, options);
  if (app.got_subcommand("mesh")) draw_mesh(canvas, options);
  for (const Command& command : commands)
    if (app.got_subcommand(command.name))
      for (const Picture& picture : command.pictures)
        if (options.wants(picture.name)) picture.draw(canvas, options);
}

int run(int count, char** arguments) {
  CLI::App app(
      "Pictures (PNG, SVG, PDF) of a scan, an evolution, the classical branches, a comparison, a "
      "study of stability or a mesh",
      "sbeh-picture");
  app.require_subcommand(1);
  Options options;
  Words words;
  const auto add_command = [&](const char* name, const char* description,
                               const std::vector<std::string>& pictures, const Has& has) {
    CLI::App* command = app.add_subcommand(name, description);
    command->add_option("DIR", options.directory, "Folder of the results; the pictures go there")
        ->required();
    add_options(*command, pictures, has, options, words);
    return command;
  };
  CLI::App* scan =
      add_command("scan", "diagram, cuts, energy from DIR/scan.csv", {"diagram", "cuts", "energy"},
                  {.energies = true, .fields = true, .panels = true});
  scan->add_option("--branch", options.branch, "Only this branch, e.g. oblate");
  for (const auto& [name, description, pictures, has] : commands) {
    std::vector<std::string> names;
    names.reserve(pictures.size());
    for (const Picture& picture : pictures) names.emplace_back(picture.name);
    add_command(name, description, names, has);
  }
  CLI::App* mesh = app.add_subcommand("mesh", "a curved mesh from FILE.vtu, into FILE.png");
  mesh->add_option("FILE", options.directory, "Mesh with curved triangles, as sbeh mesh writes it")
      ->required();
  add_options(*mesh, {}, {.fields = true, .views = true, .units = false}, options, words);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return tools::refuse_words(app, error, {"kind of results", "picture"});
  }
  studies::refuse_other_kind(options.directory,
                             "picture " + app.get_subcommands().front()->get_name());
  if (!*mesh) studies::require_folder(options.directory);
  read_words(words, options);
  ensure_display(arguments);
  draw(app, options);
  return 0;
}

}  // namespace
}  // namespace sbeh::picture

int main(int count, char** arguments) {
  return sbeh::tools::exit_code_of([&] { return sbeh::picture::run(count, arguments); });
}
