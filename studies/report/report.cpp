#include "studies/report/report.h"

#include "studies/io/conventions.h"
#include "studies/io/output.h"
#include "studies/report/history_charts.h"
#include "studies/report/live_data.h"
#include "studies/report/svg_chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr const char* generator = "sbeh report";
constexpr std::size_t most_rows = 200;

// A picture (without ending) or a table, and what stands above or below it.
struct Titled {
  const char* name;
  const char* title;
};

// What each kind of folder holds. The first tables tell the kind, and must be there.
struct Contents {
  ResultsKind kind;
  std::vector<const char*> required;
  std::vector<Titled> pictures, tables;
};
const std::vector<Contents>& all_contents() {
  static const std::vector<Contents> all{
      {ResultsKind::scan,
       {"scan.csv"},
       {{"diagram", "The stationary shapes over reduced volume and L"},
        {"cuts", "Cross sections"},
        {"energy", "Energy over time"}},
       {{"folds.csv", "Folds in which the branches end"},
        {"equal_energy.csv", "Where two branches have equal energy"},
        {"lowest.csv", "The branch that is lowest"},
        {"beyond_fold.csv", "Beyond the fold"},
        {"scan.csv", "All points"}}},
      {ResultsKind::compare,
       {"compare.csv", "methods.csv"},
       {{"profiles", "Profiles on top of each other, and their distance from the first method's"},
        {"histories", "Energies over time, and how far they are from the first method's"}},
       {{"methods.csv", "What each method finds"},
        {"compare.csv", "All pairs of methods"},
        {"histories.csv", "Energies over time"}}},
      {ResultsKind::stability,
       {"stability.csv"},
       {{"stability",
         "Which states are stable in 3D, with the rates at which perturbations grow or decay"}},
       {{"thresholds.csv", "Where a state changes from stable to unstable"},
        {"stability.csv", "All runs"}}},
      {ResultsKind::modes,
       {"modes.csv"},
       {{"profiles", "The state in grey, displaced by its modes"},
        {"surfaces", "The displaced surfaces"},
        {"contour", "Fluctuations of the contour"}},
       {{"modes.csv", "Eigenvalues and rates"},
        {"fluctuations.csv", "Mean square amplitudes"},
        {"contour.csv", "The contour's spectrum"}}},
      {ResultsKind::states,
       {"states.csv"},
       {{"surfaces", "The states"}, {"branches", "Branches"}},
       {{"passes.csv", "Passes, and the states to which they lead"}, {"states.csv", "All states"}}},
      {ResultsKind::diagram,
       {"bifurcations.csv", "branches.csv"},
       {{"diagram", "The diagram"}},
       {{"bifurcations.csv", "Where branches leave, fold, end and change their stability"}}},
      {ResultsKind::seifert,
       {"branches.csv", "points.csv"},
       {{"branches", "Reduced energy of the branches"}},
       {{"points.csv", "Special points"},
        {"differences.csv", "Largest differences of the witnesses"},
        {"branches.csv", "Shapes"}}},
      {ResultsKind::run,
       {"series.csv", "frames.csv"},
       {{"energy", "Energy over time"}, {"shapes", "Shapes"}},
       {{"frames.csv", "Frames"}, {"series.csv", "History"}}},
      {ResultsKind::relax,
       {"series.csv", "profiles.csv"},
       {{"energy", "Energy over time"}, {"shapes", "Shapes"}},
       {{"profiles.csv", "Profiles"}, {"series.csv", "History"}}},
  };
  return all;
}

const Contents& contents_of(ResultsKind kind) {
  return *std::find_if(all_contents().begin(), all_contents().end(),
                       [&](const Contents& c) { return c.kind == kind; });
}

// Scans have histories only where they were computed in time.
bool has_histories(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / "points", ignored))
    if (entry.path().string().ends_with(".series.csv")) return true;
  return false;
}

// Only states that are followed lie on paths.
bool has_branches(const fs::path& folder) {
  return read_csv(folder / "states.csv").find("path").has_value();
}

fs::path picture_file(const fs::path& folder, const std::string& name) {
  for (const char* ending : {".png", ".svg"})
    if (fs::path file = folder / (name + ending); fs::exists(file)) return file;
  return {};
}

std::string pictures_of(const fs::path& folder, const Contents& contents) {
  std::string text;
  for (const Titled& picture : contents.pictures)
    if (const fs::path file = picture_file(folder, picture.name); !file.empty())
      text += html::figure(file, picture.title);
  if (const auto missing = missing_pictures(folder, contents.kind); !missing.empty())
    text += fmt::format(
        "<p class=\"note\">Not drawn: {}. To draw: <code>sbeh picture {} {}</code>, then make this "
        "report again.</p>\n",
        fmt::join(missing, ", "), name(contents.kind), html::escaped(folder.string()));
  return text;
}

// ---- histories ------------------------------------------------------------------------------------

// The energies of a comparison's evolutions; the file has them one after the other.
std::string energies_of_methods(const CsvTable& histories,
                                const std::optional<ResultUnits>& units) {
  std::vector<ChartLine> lines;
  for (std::size_t row = 0; row < histories.rows.size(); ++row) {
    const std::string method = histories.text(row, "method");
    if (lines.empty() || lines.back().name != method) lines.push_back({.name = method});
    lines.back().x.push_back(histories.number(row, "time"));
    lines.back().y.push_back(histories.number(row, "energy"));
  }
  ChartFrame frame{"Energy", AxisScale::logarithmic, AxisScale::linear, "U"};
  if (units) {
    frame.x_name = units->titled(frame.x_name, dimension::time);
    frame.y_name = units->titled(frame.y_name, dimension::energy);
  }
  return svg_chart(frame, lines);
}

// ---- sections -----------------------------------------------------------------------------------

std::string over_time(const fs::path& folder, const std::optional<ResultUnits>& units) {
  const auto table = [&](const char* name) {
    const CsvTable read = read_csv(folder / name);
    return units ? units->values(read, name) : read;
  };
  std::string text;
  if (fs::exists(folder / "series.csv"))
    text = still_charts(table("series.csv"), units);
  else if (fs::exists(folder / "histories.csv"))
    text = energies_of_methods(table("histories.csv"), units);
  return text.empty() ? text : "<div class=\"charts\">\n" + text + "</div>\n";
}

// How the numbers are meant.
std::string conventions_note(const std::optional<ResultUnits>& units) {
  std::string text;
  const auto add = [&](std::string_view line) { text += html::element("li", line) + "\n"; };
  if (units) add("In physical units; what has none is a pure number:");
  if (units)
    for (const std::string& line : units->text()) add(line);
  for (std::size_t k = units ? 1 : 0; k < conventions.size(); ++k) add(conventions[k]);
  add("Numbers are rounded to nine digits in this page and complete in the files"
      + std::string(units ? ", which are dimensionless." : "."));
  return "<ul class=\"note\">\n" + text + "</ul>\n";
}

std::string tables_of(const fs::path& folder, const Contents& contents,
                      const std::optional<ResultUnits>& units) {
  std::string text = conventions_note(units);
  for (const auto& [file, heading] : contents.tables) {
    if (!fs::exists(folder / file)) continue;
    const CsvTable rows = read_csv(folder / file);
    if (rows.rows.empty()) continue;
    text += fmt::format("<h3>{} ({})</h3>\n", html::escaped(heading), html::link(file));
    text += html::table(units ? units->converted(rows, file) : rows, most_rows, file);
  }
  return text;
}

// What lies in the folder, of a folder in it how many files.
std::string files_of(const fs::path& folder) {
  std::vector<fs::directory_entry> entries{fs::directory_iterator(folder), {}};
  std::ranges::sort(entries);
  std::string text;
  for (const fs::directory_entry& entry : entries) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(".") || name == "report.html") continue;
    std::string count;
    if (entry.is_directory())
      count = fmt::format(" ({} files)", std::distance(fs::directory_iterator(entry.path()),
                                                       fs::directory_iterator()));
    text +=
        fmt::format("<li>{}{}</li>\n", html::link(entry.is_directory() ? name + "/" : name), count);
  }
  return "<ul class=\"files\">\n" + text + "</ul>\n";
}

// Where the script shows its page, or why there is none.
std::string explore(bool live, const std::string& too_many) {
  if (live)
    return html::section(
        "Explore",
        "<div id=\"explore\"><p class=\"note\">Here the results can be explored when "
        "the page is whole and its script may run. The pictures are below.</p></div>\n");
  if (!too_many.empty())
    return fmt::format(
        "<p class=\"note\">This page is still: there is too much to explore in one ({}).</p>\n",
        too_many);
  return "<p class=\"note\">This page is still. In one that can be explored shapes are a click "
         "away: build sbeh with <code>-DSBEH_PAGE=ON</code> (what that needs is installed by "
         "<code>tools/setup page</code>), then make this report again.</p>\n";
}

std::string how_to_run(const fs::path& folder, const Contents& contents, bool has_input) {
  const std::string results = folder.string();
  if (!has_input)
    return contents.kind == ResultsKind::seifert
             ? html::element("pre", "sbeh seifert -o NEW_FOLDER")
             : "<p>The folder has no run.toml, so that the input is not known.</p>\n";
  std::string text = html::element(
      "pre", fmt::format("sbeh {} {}/run.toml -o NEW_FOLDER", name(contents.kind), results));
  text += fmt::format(
      "<p>Or save the input above as <code>input.toml</code> and run <code>sbeh {} input.toml -o "
      "NEW_FOLDER</code>; files and folders that it names must be there.</p>\n",
      name(contents.kind));
  if (contents.kind == ResultsKind::run)
    text += fmt::format(
        "<p>An interrupted run goes on by <code>sbeh run {0}/run.toml -o {0} "
        "--resume</code>.</p>\n",
        html::escaped(results));
  return text;
}

}  // namespace

void require_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return;
  throw InputError(fmt::format("{}: {}", folder.string(),
                               fs::exists(folder, ignored) ? "is no folder" : "is not there"));
}

ResultsKind kind_of_results(const fs::path& folder) {
  require_folder(folder);
  for (const Contents& contents : all_contents())
    if (std::all_of(contents.required.begin(), contents.required.end(),
                    [&](const char* file) { return fs::exists(folder / file); }))
      return contents.kind;
  std::string wanted;
  for (const Contents& contents : all_contents())
    wanted += fmt::format("{}{} (sbeh {})", wanted.empty() ? "" : ", ",
                          fmt::join(contents.required, " and "), name(contents.kind));
  throw InputError(fmt::format("{}: holds no results to report; missing is one of: {}",
                               folder.string(), wanted));
}

std::vector<std::string> missing_pictures(const fs::path& folder, ResultsKind kind) {
  std::vector<std::string> missing;
  for (const auto& [name, caption] : contents_of(kind).pictures) {
    const std::string_view picture = name;
    const bool never =
        (kind == ResultsKind::scan && picture == "energy" && !has_histories(folder))
        || (kind == ResultsKind::modes && picture == "contour"
            && !fs::exists(folder / "contour.csv"))
        || (kind == ResultsKind::compare && !fs::exists(folder / (std::string(picture) + ".csv")))
        || (kind == ResultsKind::states && picture == "branches" && !has_branches(folder));
    if (!never && picture_file(folder, name).empty()) missing.emplace_back(name);
  }
  return missing;
}

std::string generator_of(std::string_view version) {
  return fmt::format("{} {}", generator, version);
}

bool replaces_report(const fs::path& file) {
  if (!fs::exists(file)) return false;
  const std::string begin = read_file(file).substr(0, 1000);
  if (begin.find(fmt::format("<meta name=\"generator\" content=\"{}", generator))
      == std::string::npos)
    throw OutputError(
        fmt::format("{}: is there and is no report of sbeh, so it is not overwritten; move it away",
                    file.string()));
  return true;
}

ReportSummary write_report(const fs::path& folder, std::string_view version,
                           std::string_view script, const std::optional<ResultUnits>& units) {
  const Contents& contents = contents_of(kind_of_results(folder));
  ReportSummary summary{.file = folder / "report.html"};
  summary.replaced = replaces_report(summary.file);
  const KeyNumbers numbers = key_numbers(folder, contents.kind, units);
  const std::string too_many = too_many_for_a_page(folder, contents.kind);
  summary.live = has_live_page(contents.kind) && !script.empty() && too_many.empty();
  summary.missing = missing_pictures(folder, contents.kind);
  const std::string where = fs::absolute(folder).lexically_normal().filename().string();
  const bool has_input = fs::exists(folder / "run.toml");

  std::string body = "<header>\n" + html::element("h1", numbers.title);
  body +=
      fmt::format("<p class=\"note\">{}, results of <code>sbeh {}</code>; page by sbeh {}</p>\n",
                  html::escaped(where.empty() ? folder.string() : where), name(contents.kind),
                  html::escaped(version));
  body += "</header>\n<main>\n" + html::section("Key numbers", html::facts(numbers.facts));
  if (has_live_page(contents.kind)) body += explore(summary.live, too_many);
  if (const std::string pictures = pictures_of(folder, contents); !pictures.empty())
    body += html::section("Pictures", pictures);
  if (const std::string history = over_time(folder, units); !history.empty())
    body += html::section("Over time", history);
  body += html::section("Tables", tables_of(folder, contents, units));
  body += html::section("Files", files_of(folder));
  if (has_input)
    body += html::section("Input with every parameter",
                          html::element("pre", read_file(folder / "run.toml")));
  body += html::section("How to run it again", how_to_run(folder, contents, has_input));
  body += "</main>\n";
  if (summary.live)
    body += fmt::format("{}<script>{}</script>\n",
                        live_data(folder, contents.kind, units).element(), script);
  write_file(summary.file, html::page(numbers.title, generator_of(version), body));
  return summary;
}

}  // namespace sbeh::studies
