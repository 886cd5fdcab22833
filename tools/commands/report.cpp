// `sbeh report`: a folder of results as one page of HTML.
#include "studies/report/report.h"

#include "studies/io/output.h"
#include "studies/report/path_kind.h"
#include "studies/report/sweep_report.h"
#include "studies/sweep/sweep_folder.h"
#include "tools/commands/commands.h"

namespace sbeh::tools {

namespace fs = std::filesystem;

namespace {

studies::ResultsKind kind_of(const fs::path& folder) {
  try {
    return studies::kind_of_results(folder);
  } catch (const studies::InputError&) {
    studies::refuse_other_kind(folder, "report");
    throw;
  }
}

// What makes a page live; nothing where the program was built without (SBEH_PAGE).
std::string page_script() {
  const fs::path script =
      fs::read_symlink("/proc/self/exe").parent_path() / "../share/sbeh/page/page.js";
  return fs::exists(script) ? studies::read_file(script) : "";
}

struct Words {
  std::string folder, units_from;
  bool no_pictures = false, units = false;
};

// All of them in units; otherwise those that are missing.
void draw_pictures(const Words& words, studies::ResultsKind kind, bool in_units) {
  std::vector<std::string> drawn{sbeh::name(kind), words.folder};
  if (in_units && words.units_from.empty()) drawn.emplace_back("--units");
  if (in_units && !words.units_from.empty())
    drawn.insert(drawn.end(), {"--units-from", words.units_from});
  if (in_units && draw(drawn) != 0) complain("the pictures cannot be drawn in these units");
  if (in_units) return;
  for (const std::string& picture : studies::missing_pictures(words.folder, kind))
    if (draw({sbeh::name(kind), words.folder, "--only", picture}) != 0)
      complain(fmt::format("{}: cannot be drawn; the report is without it", picture));
}

int tell(const studies::ReportSummary& s) {
  fmt::print("{} {}{}\n", s.replaced ? "replaced the earlier report" : "wrote", s.file.string(),
             s.live ? fmt::format(" ({:.1f} MB, to explore in a browser)",
                                  1e-6 * double(fs::file_size(s.file)))
                    : "");
  return 0;
}

int report(const Words& words) {
  const fs::path folder = words.folder;
  if (studies::holds_sweep(folder)) {
    if (words.units || !words.units_from.empty())
      throw studies::InputError(fmt::format(
          "{}: is a sweep, whose report has no units; those of its cases may", folder.string()));
    return tell(studies::write_sweep_report(folder, SBEH_VERSION));
  }
  const studies::ResultsKind kind = kind_of(folder);
  std::optional<studies::ResultUnits> units;
  if (words.units || !words.units_from.empty())
    units.emplace(folder, words.units_from.empty() ? std::nullopt
                                                   : std::optional(fs::path(words.units_from)));
  const bool have_units =
      units && kind != studies::ResultsKind::seifert && kind != studies::ResultsKind::diagram;
  if (!words.no_pictures) draw_pictures(words, kind, have_units);
  return tell(studies::write_report(folder, SBEH_VERSION, page_script(), units));
}

}  // namespace

Command add_report(CLI::App& program) {
  const auto words = std::make_shared<Words>();
  CLI::App* app = program.add_subcommand("report", "a folder of results as one page of HTML");
  app->add_option("DIR", words->folder,
                  "folder of a scan, run, relax, seifert, compare, stability, modes, states, "
                  "diagram or sweep")
      ->required();
  app->add_flag("--no-pictures", words->no_pictures, "do not draw those that are missing");
  app->add_flag("--units", words->units,
                "in physical units, those of [units] in DIR/run.toml; draws all pictures again");
  app->add_option("--units-from", words->units_from, "in those of the table [units] of this file");
  return {app, [words] { return report(*words); }};
}

}  // namespace sbeh::tools
