// `sbeh figures`: the paper's figures, with the runs they need.
#include "studies/figures/figures.h"

#include "meshing/resolution.h"
#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "tools/commands/commands.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

namespace sbeh::tools {

namespace fs = std::filesystem;
namespace figures = studies::figures;
using figures::Figure;

namespace {

struct FigureWords {
  std::vector<std::string> figures;
  std::string folder = "results/figures", inputs = "studies/inputs";
  std::optional<int> triangles;
  bool draw_only = false, no_pictures = false;
};

std::vector<Figure> figures_of(const std::vector<std::string>& words) {
  constexpr std::array all = values_of(Figure{});
  if (words.empty()) return {all.begin(), all.end()};
  std::vector<Figure> wanted;
  for (const std::string& word : words) {
    const auto figure = figures::figure_of(word);
    if (!figure)
      throw studies::InputError(fmt::format(
          "{}: unknown figure. Known: energy (1), shapes (2), evolution (3), measures (4)", word));
    if (std::find(wanted.begin(), wanted.end(), *figure) == wanted.end()) wanted.push_back(*figure);
  }
  return wanted;
}

// Draws the figures that have their tables; false when one has none or cannot be drawn.
bool draw_all(const figures::Summary& summary, const fs::path& folder) {
  std::vector<std::string> arguments{"figures", folder.string()};
  bool all = true;
  for (const auto& [figure, missing] : summary.missing) {
    const std::string name = sbeh::name(figure);
    if (fs::exists(folder / (name + ".csv"))) {
      arguments.insert(arguments.end(), {"--only", name});
      continue;
    }
    complain(fmt::format("figure {} ({}): there is nothing to draw it from", number(figure), name));
    all = false;
  }
  if (arguments.size() == 2 || draw(arguments) == 0) return all;
  complain(
      fmt::format("not all is drawn; the tables in {0} are complete. Try again with: sbeh figures "
                  "--draw-only -o {0}",
                  folder.string()));
  return false;
}

void tell_missing(const figures::Summary& summary) {
  constexpr std::size_t most = 6;
  for (const auto& [figure, missing] : summary.missing) {
    if (missing.empty()) continue;
    const auto shown = std::vector<std::string>(
        missing.begin(), missing.begin() + std::ptrdiff_t(std::min(most, missing.size())));
    complain(fmt::format(
        "figure {} ({}) lacks {}{}", number(figure), name(figure), fmt::join(shown, "; "),
        missing.size() > most ? fmt::format(" and {} more", missing.size() - most) : ""));
  }
}

int make(const FigureWords& w) {
  const fs::path folder = w.folder;
  const figures::Summary summary = figures::make_figures({.figures = figures_of(w.figures),
                                                          .folder = folder,
                                                          .inputs = w.inputs,
                                                          .triangles = w.triangles,
                                                          .draw_only = w.draw_only},
                                                         SBEH_VERSION);
  for (const std::string& sentence : summary.failed) complain(sentence);
  if (!summary.unresolved.empty())
    complain(
        fmt::format("not resolved by their triangles, what comes later is not to be trusted: {}",
                    fmt::join(summary.unresolved, "; ")));
  if (summary.interrupted) {
    complain("interrupted; the same command goes on from here");
    return exit_code_of_interrupt();
  }
  tell_missing(summary);
  const bool drawn = w.no_pictures || draw_all(summary, folder);
  fmt::print(
      "{}tables in {}\n",
      figures::text_of(studies::read_rows(figures::figure_columns(), folder / "figures.csv")),
      folder.string());
  if (studies::interrupt_signal()) return exit_code_of_interrupt();
  return drawn && summary.failed.empty() ? 0 : 1;
}

}  // namespace

Command add_figures(CLI::App& program) {
  const auto words = std::make_shared<FigureWords>();
  FigureWords& w = *words;
  CLI::App* app =
      program.add_subcommand("figures", "the paper's figures: the runs they need, then pictures");
  app->add_option("FIGURE", w.figures,
                  "energy, shapes, evolution, measures, or 1 to 4 (all of them)");
  app->add_option("-o,--output", w.folder, "folder for runs and figures (results/figures)");
  app->add_option("--inputs", w.inputs, "folder of their inputs (studies/inputs)");
  app->add_option("--triangles", w.triangles,
                  "of the 3D runs, instead of those of the inputs (1280)")
      ->check(CLI::Range(meshing::fewest_triangles, meshing::most_triangles));
  app->add_flag("--draw-only", w.draw_only, "run nothing, draw from what is there");
  app->add_flag("--no-pictures", w.no_pictures, "tables only");
  return {app, [words] {
            studies::catch_interrupts();
            return make(*words);
          }};
}

}  // namespace sbeh::tools
