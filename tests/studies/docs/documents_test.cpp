// The documents stay true: their inputs are accepted, their links lead somewhere, their tables are complete.
#include "studies/compare/compare_input.h"
#include "studies/diagram/diagram_input.h"
#include "studies/evolution/relax.h"
#include "studies/evolution/run_start.h"
#include "studies/io/csv.h"
#include "studies/modes/modes_input.h"
#include "studies/parameters/input_kind.h"
#include "studies/rest_states/states_input.h"
#include "studies/scan/scan_input.h"
#include "studies/stability/stability_input.h"
#include "studies/states/series_file.h"
#include "studies/sweep/sweep_input.h"
#include "tests/studies/docs/document.h"
#include "tests/studies/parameters/input_file.h"

namespace sbeh::studies {
namespace {

using namespace test;
namespace fs = std::filesystem;

struct Block {
  std::string where, text;
};

// What stands between the line that opens a block and the one that closes it.
std::vector<Block> blocks(const fs::path& document, const std::string& opening) {
  std::vector<Block> found;
  bool inside = false;
  int number = 0;
  for (const std::string& line : lines_of(document)) {
    ++number;
    if (inside && line == "```")
      inside = false;
    else if (inside)
      found.back().text += line + "\n";
    else if (line == opening) {
      inside = true;
      found.push_back({document.string() + ":" + std::to_string(number), ""});
    }
  }
  return found;
}

// ---- inputs -----------------------------------------------------------------------------------------

bool contains(const std::vector<double>& values, double value) {
  return std::ranges::any_of(values, [&](double v) { return std::abs(v - value) < 1e-12; });
}

// A point of one of the scans that the document has before.
void expect_in_a_scan(const ScanRow& row, const std::vector<ScanInput>& scans) {
  EXPECT_TRUE(std::ranges::any_of(scans, [&](const ScanInput& scan) {
    return contains(scan.reduced_volume, row.reduced_volume) && contains(scan.L, row.L)
        && std::ranges::find(scan.branches, row.branch) != scan.branches.end();
  })) << "no scan above has the row from which it begins";
}

// Leaves what an evolution reads of the scan from whose folder it begins, the last one of the document; where
// that is not read, nothing.
class ScanFolder {
 public:
  ScanFolder(const std::string& evolution, const std::vector<ScanInput>& scans) {
    const std::string key = "\nfolder = \"";
    const std::size_t at = evolution.find(key);
    if (at == std::string::npos || scans.empty()) return;
    const std::size_t from = at + key.size();
    const fs::path folder = top_.path() / evolution.substr(from, evolution.find('"', from) - from);
    fs::create_directories(folder);
    write_file(folder / "run.toml", describe(scans.back(), "0"));
    write_file(folder / "scan.csv", "model,status\n");
    fs::current_path(top_.path());
  }
  ~ScanFolder() { fs::current_path(root_); }
  ScanFolder(const ScanFolder&) = delete;
  ScanFolder& operator=(const ScanFolder&) = delete;

 private:
  sbeh::test::TemporaryFolder top_;
  fs::path root_ = fs::current_path();
};

template <class Input>
void check_evolution(const Input& input, const std::vector<ScanInput>& scans) {
  if (const auto* row = std::get_if<ScanRow>(&input.start))
    expect_in_a_scan(*row, scans);
  else
    start_of(input);
}

void check_input(const fs::path& path, std::vector<ScanInput>& scans) {
  switch (kind_of(path)) {
    case InputKind::scan:
      scans.push_back(read_scan(path));
      break;
    case InputKind::relax:
      check_evolution(read_relax(path), scans);
      break;
    case InputKind::run:
      check_evolution(read_run(path), scans);
      break;
    case InputKind::compare:
      read_compare(path);
      break;
    case InputKind::stability:
      read_stability(path);
      break;
    case InputKind::modes:
      read_modes(path);
      break;
    case InputKind::states:
      read_states(path);
      break;
    case InputKind::diagram:
      read_diagram(path);
      break;
    case InputKind::sweep:
      cases_of(read_sweep(path), "0");
      break;
  }
}

TEST(Documents, have_inputs_that_are_accepted) {
  int inputs = 0;
  for (const fs::path& document : documents()) {
    std::vector<ScanInput> scans;
    for (const Block& block : blocks(document, "```toml")) {
      SCOPED_TRACE(block.where);
      ++inputs;
      const ScanFolder folder(block.text, scans);
      EXPECT_NO_THROW(check_input(written(block.text), scans));
    }
  }
  EXPECT_GE(inputs, 4);  // README.md alone has a scan, two evolutions and a comparison
}

// ---- links ------------------------------------------------------------------------------------------

// The targets of [text](target) in a line.
std::vector<std::string> links_of(const std::string& line) {
  std::vector<std::string> targets;
  for (std::size_t at = 0; (at = line.find("](", at)) != std::string::npos;) {
    at += 2;
    const std::size_t end = line.find(')', at);
    if (end == std::string::npos) break;
    targets.push_back(line.substr(at, end - at));
  }
  return targets;
}

TEST(Documents, link_to_files_that_exist) {
  int links = 0;
  for (const fs::path& document : documents())
    for (const std::string& line : lines_of(document))
      for (const std::string& target : links_of(line)) {
        if (target.find("://") != std::string::npos) continue;
        ++links;
        EXPECT_EQ(target.find('#'), std::string::npos)
            << document << ": " << target << ": a link to a file, not to a place in it";
        EXPECT_TRUE(fs::exists(document.parent_path() / target)) << document << ": " << target;
      }
  EXPECT_GE(links, 10);  // the table of documents in README.md
}

// Words in `...` that are paths of the studies.
TEST(Documents, name_inputs_that_exist) {
  const std::string start = "studies/", end = ".toml";
  for (const fs::path& document : documents())
    for (const std::string& line : lines_of(document))
      for (std::size_t at = 0; (at = line.find(start, at)) != std::string::npos;) {
        const std::size_t stop = line.find_first_of(" `),;", at);
        const std::string path = line.substr(at, stop - at);
        at += start.size();
        if (!path.ends_with(end)) continue;
        EXPECT_TRUE(fs::exists(path)) << document << ": " << path;
      }
}

// ---- series.csv -------------------------------------------------------------------------------------

TEST(SeriesDocument, explains_the_columns_in_their_order_and_no_others) {
  std::vector<std::string> explained;
  for (const std::string& line : lines_of("studies/docs/series.md"))
    if (line.starts_with("| `")) explained.push_back(line.substr(3, line.find('`', 3) - 3));
  EXPECT_EQ(explained, split_csv(header_of(series_columns())));
}

}  // namespace
}  // namespace sbeh::studies
