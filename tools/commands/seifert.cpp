// `sbeh seifert`: the classical diagram by three witnesses.
#include "studies/seifert/seifert.h"

#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace {

struct SeifertWords {
  std::string folder = "results/seifert";
  bool no_pictures = false;
  int elements = 96;
};

int seifert(const SeifertWords& w) {
  fmt::print("{}", studies::table_of(studies::run_seifert(w.folder, w.elements)));
  fmt::print("tables in {}\n", w.folder);
  if (!w.no_pictures) draw_results(studies::ResultsKind::seifert, w.folder);
  return 0;
}

}  // namespace

Command add_seifert(CLI::App& program) {
  const auto words = std::make_shared<SeifertWords>();
  CLI::App* app = program.add_subcommand("seifert", "the classical diagram by three witnesses");
  app->add_option("-o,--output", words->folder, "folder for the results (results/seifert)");
  app->add_flag("--no-pictures", words->no_pictures, "tables only");
  app->add_option("--elements", words->elements, "of the finite elements (96)")
      ->check(CLI::Range(32, 4096));
  return {app, [words] { return seifert(*words); }};
}

}  // namespace sbeh::tools
