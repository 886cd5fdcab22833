// `sbeh report`: a folder of results as one page of HTML.
#include "studies/report/report.h"

#include "studies/io/output.h"
#include "studies/report/path_kind.h"
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

int report(const fs::path& folder, bool no_pictures) {
  const studies::ResultsKind kind = kind_of(folder);
  if (!no_pictures)
    for (const std::string& picture : studies::missing_pictures(folder, kind))
      if (draw({sbeh::name(kind), folder.string(), "--only", picture}) != 0)
        complain(fmt::format("{}: cannot be drawn; the report is without it", picture));
  const studies::ReportSummary s = studies::write_report(folder, SBEH_VERSION, page_script());
  fmt::print("{} {}{}\n", s.replaced ? "replaced the earlier report" : "wrote", s.file.string(),
             s.live ? fmt::format(" ({:.1f} MB, to explore in a browser)",
                                  1e-6 * double(fs::file_size(s.file)))
                    : "");
  return 0;
}

}  // namespace

Command add_report(CLI::App& program) {
  const auto folder = std::make_shared<std::string>();
  const auto no_pictures = std::make_shared<bool>(false);
  CLI::App* app = program.add_subcommand("report", "a folder of results as one page of HTML");
  app->add_option("DIR", *folder,
                  "folder of a scan, run, relax, seifert, compare, stability or modes")
      ->required();
  app->add_flag("--no-pictures", *no_pictures, "do not draw those that are missing");
  return {app, [=] { return report(*folder, *no_pictures); }};
}

}  // namespace sbeh::tools
