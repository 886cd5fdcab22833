// sbeh-picture: the pictures of a scan, of one evolution, of the classical branches, of a comparison, of a
// study of stability or of a mesh, and the paper's figures, from the files they leave.
#include "studies/io/output.h"
#include "tools/picture/canvas/virtual_display.h"
#include "tools/picture/evolution/mesh.h"
#include "tools/picture/evolution/relax.h"
#include "tools/picture/evolution/run.h"
#include "tools/picture/figures/figures.h"
#include "tools/picture/scan/cuts.h"
#include "tools/picture/scan/diagram.h"
#include "tools/picture/scan/energy.h"
#include "tools/picture/studies/classical.h"
#include "tools/picture/studies/compare.h"
#include "tools/picture/studies/stability.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace sbeh::picture {
namespace {

constexpr int exit_failed = 1;
constexpr int exit_bad_input = 2;

Size parse_size(const std::string& text) {
  Size size;
  char rest = 0;
  const int found = std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest);
  const auto possible = [](int length) { return length >= 300 && length <= 8000; };
  if (found != 2 || !possible(size.width) || !possible(size.height)) {
    throw InputError(
        fmt::format("--size {}: give width and height in pixels, each 300 to 8000, "
                    "as in 1600x1200.",
                    text));
  }
  return size;
}

void picture_scan(const Options& options) {
  const ScanGrid scan(options.directory, options.branch);
  if (scan.branches().size() > 1 && options.branch.empty()) {
    fmt::print(
        "several branches ({}): the pictures show the one of lowest energy at each point; "
        "--branch chooses one\n",
        fmt::join(scan.branches(), ", "));
  }
  Canvas canvas;
  if (options.wants("diagram")) draw_diagram_picture(canvas, scan, options);
  if (options.wants("cuts")) draw_cuts_picture(canvas, scan, options);
  if (options.wants("energy")) draw_energy_picture(canvas, scan, options);
}

void picture_relaxation(const Options& options) {
  Canvas canvas;
  if (options.wants("energy")) draw_relaxation_energy(canvas, options);
  if (options.wants("shapes")) draw_relaxation_shapes(canvas, options);
}

void picture_run(const Options& options) {
  Canvas canvas;
  if (options.wants("energy")) draw_relaxation_energy(canvas, options);
  if (options.wants("shapes")) draw_run_shapes(canvas, options);
}

void picture_figures(const Options& options) {
  using Draw = void (*)(Canvas&, const Options&);
  constexpr std::pair<const char*, Draw> figures[] = {{"energy", draw_figure_energy},
                                                      {"shapes", draw_figure_shapes},
                                                      {"evolution", draw_figure_evolution},
                                                      {"measures", draw_figure_measures}};
  Canvas canvas;
  for (const auto& [name, draw] : figures)
    if (options.wants(name)) draw(canvas, options);
}

void add_common_options(CLI::App* command, Options& options, std::string& size,
                        std::vector<std::string> pictures) {
  command->add_option("DIR", options.directory, "Folder of the results; the pictures go there")
      ->required();
  command->add_option("--only", options.only, "Only this picture")
      ->check(CLI::IsMember(std::move(pictures)))
      ->allow_extra_args(false);
  command->add_option("--size", size, "Width and height in pixels, e.g. 1600x1200");
  command->add_option("--energy-shift", options.energy_shift,
                      "What is added to the energy before its logarithm, by default 4π");
}

int run(int count, char** arguments) {
  CLI::App app(
      "Pictures (PNG and SVG) of a scan, an evolution, the classical branches, a comparison, a "
      "study of stability or a mesh",
      "sbeh-picture");
  app.require_subcommand(1);
  Options options;
  std::string size;
  CLI::App* scan = app.add_subcommand("scan", "diagram, cuts, energy from DIR/scan.csv");
  add_common_options(scan, options, size, {"diagram", "cuts", "energy"});
  scan->add_option("--branch", options.branch, "Only this branch, e.g. oblate");
  CLI::App* relax = app.add_subcommand("relax", "energy, shapes from DIR/series.csv, profiles.csv");
  add_common_options(relax, options, size, {"energy", "shapes"});
  CLI::App* run_3d = app.add_subcommand("run", "energy, shapes from DIR/series.csv, frames.csv");
  add_common_options(run_3d, options, size, {"energy", "shapes"});
  CLI::App* seifert =
      app.add_subcommand("seifert", "the classical diagram from DIR/branches.csv, points.csv");
  add_common_options(seifert, options, size, {"branches"});
  CLI::App* compare =
      app.add_subcommand("compare", "profiles of all methods from DIR/profiles.csv");
  add_common_options(compare, options, size, {"profiles"});
  CLI::App* figures =
      app.add_subcommand("figures", "the paper's figures from the tables of `sbeh figures` in DIR");
  add_common_options(figures, options, size, {"energy", "shapes", "evolution", "measures"});
  CLI::App* stability =
      app.add_subcommand("stability", "which states are stable in 3D, from DIR/stability.csv");
  add_common_options(stability, options, size, {"stability"});
  CLI::App* mesh = app.add_subcommand("mesh", "a curved mesh from FILE.vtu, into FILE.png");
  mesh->add_option("FILE", options.directory, "Mesh with curved triangles, as sbeh mesh writes it")
      ->required();
  mesh->add_option("--size", size, "Width and height in pixels, e.g. 1600x1200");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_bad_input;
  }
  if (!size.empty()) options.size = parse_size(size);
  ensure_display(arguments);
  if (scan->parsed()) picture_scan(options);
  if (relax->parsed()) picture_relaxation(options);
  if (run_3d->parsed()) picture_run(options);
  if (seifert->parsed()) {
    Canvas canvas;
    draw_classical_diagram(canvas, options);
  }
  if (compare->parsed()) {
    Canvas canvas;
    draw_compared_profiles(canvas, options);
  }
  if (figures->parsed()) picture_figures(options);
  if (stability->parsed()) {
    Canvas canvas;
    draw_stability(canvas, options);
  }
  if (mesh->parsed()) {
    Canvas canvas;
    draw_mesh(canvas, options);
  }
  return 0;
}

}  // namespace
}  // namespace sbeh::picture

int main(int count, char** arguments) {
  try {
    return sbeh::picture::run(count, arguments);
  } catch (const sbeh::studies::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return sbeh::picture::exit_bad_input;
  } catch (const sbeh::studies::OutputError& error) {  // of a table that cannot be read
    fmt::print(stderr, "{}\n", error.what());
    return sbeh::picture::exit_bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return sbeh::picture::exit_failed;
  }
}
