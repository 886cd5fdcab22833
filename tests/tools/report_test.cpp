// Reports as their reader sees them: one page for every kind of results, whole and by itself.
#include "studies/report/report.h"

#include "studies/io/csv.h"
#include "tests/tools/workplace.h"

#include <cmath>
#include <fstream>
#include <set>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

// What is wrong with the page's tags; empty when every tag that is opened is closed in its place.
std::string fault_of(const std::string& page) {
  const std::set<std::string> without_end{"meta", "img"};
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    if (page.compare(at, 9, "<!DOCTYPE") == 0) continue;
    const std::size_t end = page.find('>', at);
    if (end == std::string::npos) return "a tag without an end";
    const bool closing = page[at + 1] == '/', closed = page[end - 1] == '/';
    const std::size_t first = at + (closing ? 2 : 1);
    const std::string name = page.substr(first, page.find_first_of(" />", first) - first);
    const auto quotes =
        std::count(page.begin() + std::ptrdiff_t(at), page.begin() + std::ptrdiff_t(end), '"');
    if (name.empty() || quotes % 2 != 0) return "the tag " + page.substr(at, end - at + 1);
    if (closing) {
      if (open.empty() || open.back() != name) return "the end of " + name;
      open.pop_back();
    } else if (!closed && !without_end.contains(name)) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : "no end of " + open.back();
}

// What tests/tools/page looks at is taken out.
std::string without_scripts(std::string page) {
  for (const std::string begin :
       {"<script type=\"application/octet-stream\" id=\"sbeh-data\">", "<script>"})
    if (const std::size_t from = page.find(begin); from != std::string::npos)
      page.erase(from, page.find("</script>", from) + 9 - from);
  return page;
}

class Report : public Workplace {
 protected:
  /// Makes the report and looks at it.
  std::string page_of(const std::string& folder) const {
    const Ended ended = sbeh({"report", folder, "--no-pictures"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_TRUE(ended.out.starts_with("wrote " + folder + "/report.html")) << ended.out;
    std::string page = without_scripts(read(folder + "/report.html"));
    EXPECT_EQ(fault_of(page), "");
    expect_links(page, folder);
    for (const char* outside : {"http", "url(", "@import", "<script", "src=\"/", "//"})
      EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    return page;
  }
  // To files beside the page, and to all of them.
  void expect_links(const std::string& page, const std::string& folder) const {
    const std::string begin = "href=\"";
    std::set<std::string> links;
    for (std::size_t at = page.find(begin); at != std::string::npos;
         at = page.find(begin, at + 1)) {
      const std::size_t from = at + begin.size();
      links.insert(page.substr(from, page.find('"', from) - from));
    }
    for (const std::string& file : links) EXPECT_TRUE(fs::exists(path(folder) / file)) << file;
    for (const fs::directory_entry& entry : fs::directory_iterator(path(folder))) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".") || name == "report.html") continue;
      EXPECT_TRUE(links.contains(name) || links.contains(name + "/")) << name;
    }
  }
  void expect_numbers(const std::string& page, const std::string& file) const {
    const Table numbers = table(file);
    for (const auto& row : numbers.rows)
      for (const std::string& field : row) {
        double value = 0;
        if (!studies::parse_number(field, value) || !std::isfinite(value)) continue;
        EXPECT_NE(page.find("<data value=\"" + field + "\">"), std::string::npos)
            << file << ": " << field;
      }
  }
  void expect_input(const std::string& page, const std::string& file) const {
    std::string text = read(file), escaped;
    for (const char c : text)
      escaped += c == '"' ? std::string("&quot;") : c == '\'' ? "&#39;" : std::string(1, c);
    EXPECT_NE(page.find("<pre>" + escaped + "</pre>"), std::string::npos);
  }
};

TEST_F(Report, of_a_scan_has_its_numbers_and_its_input) {
  write("in.toml", "[scan]\nreduced_volume = [0.7, 0.8]\nL = [0.03, 0.05]\n");
  must(into("out", "scan"));
  const std::string page = page_of("out");
  expect_numbers(page, "out/scan.csv");
  expect_numbers(page, "out/folds.csv");
  expect_input(page, "out/run.toml");
  for (const char* text : {"<h1>Stationary shapes: SBEH, SSH over 8 points</h1>",
                           "sbeh scan out/run.toml -o NEW_FOLDER", "sbeh picture scan out",
                           "Not drawn: diagram, cuts."})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(Report, of_evolutions_has_their_numbers_and_charts) {
  write("relax.toml",
        "model = \"SBEH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n"
        "[time]\nend = 0.01\noutput = {from = 0.001, to = 0.01, count = 10}\n");
  must(into("relax", "relax", "relax.toml"));
  write("run.toml",
        "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\ntriangles = 80\n"
        "[time]\nend = 0.001\nframes = [0, 0.001]\noutput = [0, 0.0005, 0.001]\n");
  must(into("run", "run", "run.toml"));
  for (const std::string folder : {"relax", "run"}) {
    SCOPED_TRACE(folder);
    const std::string page = page_of(folder);
    expect_numbers(page, folder + "/series.csv");
    expect_input(page, folder + "/run.toml");
    EXPECT_NE(page.find("<svg "), std::string::npos);
    EXPECT_NE(page.find("Order β"), std::string::npos);
  }
  EXPECT_NE(read("run/report.html").find("<h1>3D evolution of SSH to t = 0.001</h1>"),
            std::string::npos);
}

TEST_F(Report, of_a_comparison_and_of_the_classical_diagram_has_their_numbers) {
  write("in.toml",
        "[compare]\nmodel = \"SSH\"\nreduced_volume = 0.8\nL = 0.05\n"
        "methods = [\"newton\", \"flow\"]\n[tolerance]\nenergy = 1e-8\n");
  must(into("compare", "compare"));
  const std::string page = page_of("compare");
  expect_numbers(page, "compare/compare.csv");
  expect_numbers(page, "compare/methods.csv");
  expect_numbers(page, "compare/histories.csv");
  EXPECT_NE(page.find("<svg "), std::string::npos);
  EXPECT_NE(page.find("<dt>tolerances kept</dt><dd>1</dd>"), std::string::npos);

  must({"seifert", "-o", "seifert", "--no-pictures", "--elements", "48"});
  expect_numbers(page_of("seifert"), "seifert/points.csv");
}

TEST_F(Report, of_rest_states_has_their_numbers_and_says_which_frame_is_damaged) {
  write("in.toml",
        "[states]\nmodel = \"SSH\"\nbranch = \"oblate\"\nreduced_volume = [0.8, 0.85]\nL = 0.05\n"
        "triangles = 180\neigenpairs = 1\n");
  must(into("out", "states"));
  const std::string page = page_of("out");
  expect_numbers(page, "out/states.csv");
  expect_input(page, "out/run.toml");
  EXPECT_NE(page.find("<h1>Rest states in 3D: SSH</h1>"), std::string::npos);
  write("out/frames/state_0002.vtu", "");
  EXPECT_THROW(studies::write_report(path("out"), "0", "begin()"), studies::InputError);
  fs::remove(path("out/frames/state_0002.vtu"));
  EXPECT_TRUE(studies::write_report(path("out"), "0", "begin()").live);
}

TEST_F(Report, can_be_explored_with_a_script_and_says_how_to_have_it_without) {
  write("in.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\nmodels = [\"SSH\"]\n");
  must(into("out", "scan"));
  const std::string data = "id=\"sbeh-data\"", how = "-DSBEH_PAGE=ON";
  EXPECT_FALSE(studies::write_report(path("out"), "0", "").live);
  const std::string still = read("out/report.html");
  EXPECT_EQ(still.find(data), std::string::npos);
  EXPECT_NE(still.find(how), std::string::npos);
  EXPECT_TRUE(studies::write_report(path("out"), "0", "begin()").live);
  const std::string live = read("out/report.html");
  EXPECT_NE(live.find(data), std::string::npos);
  EXPECT_NE(live.find("<script>begin()</script>"), std::string::npos);
  EXPECT_EQ(live.find(how), std::string::npos);
}

TEST_F(Report, holds_the_pictures_that_are_there) {
  write("in.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\nmodels = [\"SSH\"]\n");
  must(into("out", "scan"));
  std::ofstream(path("out/diagram.png"), std::ios::binary) << "foobar";
  const std::string page = page_of("out");
  EXPECT_NE(page.find("src=\"data:image/png;base64,Zm9vYmFy\""), std::string::npos);
  EXPECT_NE(page.find("Not drawn: cuts."), std::string::npos);
}

TEST_F(Report, replaces_an_earlier_report_and_nothing_else) {
  write("in.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\nmodels = [\"SSH\"]\n");
  must(into("out", "scan"));
  page_of("out");
  const Contents before = contents("out");
  const Ended again = sbeh({"report", "out", "--no-pictures"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(again.out.starts_with("replaced the earlier report out/report.html")) << again.out;
  EXPECT_EQ(contents("out"), before);
  write("out/report.html", "<html>mine</html>");
  must_refuse({"report", "out", "--no-pictures"},
              "out/report.html: is there and is no report of sbeh");
  EXPECT_EQ(read("out/report.html"), "<html>mine</html>");
}

TEST_F(Report, escapes_names_and_inputs) {
  write("in.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\nmodels = [\"SSH\"]\n");
  must(into("a<b>&c", "scan"));
  write("a<b>&c/run.toml", "# </pre><script>1 & 2</script>\n" + read("a<b>&c/run.toml"));
  const std::string page = page_of("a<b>&c");
  EXPECT_NE(page.find("a&lt;b&gt;&amp;c, results of"), std::string::npos);
  EXPECT_NE(page.find("# &lt;/pre&gt;&lt;script&gt;1 &amp; 2&lt;"), std::string::npos);
}

TEST_F(Report, refuses_a_folder_that_holds_no_results_and_says_what_is_missing) {
  must_refuse({"report", "nowhere"}, "nowhere: is not there");
  write("in.toml", "");
  must_refuse({"report", "in.toml"}, "in.toml: is no folder");
  fs::create_directory(path("empty"));
  must_refuse({"report", "empty"},
              "empty: holds no results to report; missing is one of: scan.csv");
  write("part/series.csv", "time,energy\n");
  must_refuse({"report", "part"}, "part: holds no results to report");
  write("begun/scan.csv", "model,reduced_volume\n");
  must_refuse({"report", "begun", "--no-pictures"}, "begun/scan.csv: has no rows yet");
  write("damaged/scan.csv", "model,reduced_volume\nSSH\n");
  must_refuse({"report", "damaged", "--no-pictures"},
              "damaged/scan.csv:2: has 1 fields instead of 2");
  for (const char* folder : {"empty", "part", "begun", "damaged"})
    EXPECT_FALSE(exists(path(folder) / "report.html")) << folder;
}

}  // namespace
}  // namespace sbeh::tools::test
