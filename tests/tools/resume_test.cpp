// kill -9 in the middle of a scan, and what may lie about afterwards: resumed to the same results.
#include "tests/tools/workplace.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <random>
#include <thread>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string map =
    "[scan]\nreduced_volume = {from = 0.6, to = 0.95, count = 20}\n"
    "L = {from = 0.005, to = 0.08, count = 10}\n[numerics]\nelements = 16\n";
const std::string small_map =
    "[scan]\nreduced_volume = {from = 0.6, to = 0.9, count = 7}\nL = [0.02, 0.04, 0.06, 0.08]\n"
    "branches = [\"oblate\", \"prolate\"]\n[numerics]\nelements = 16\n";
const std::string by_flow =
    "[scan]\nreduced_volume = [0.7, 0.75, 0.8, 1]\nL = [0.05, 0.06]\nmethod = \"flow\"\n"
    "[numerics]\nelements = 16\n";

class Resume : public Workplace {
 protected:
  /// A point that was finished: its row, but for the fold's L and its error that it gets at the end, and when its files were written.
  struct Point {
    std::vector<std::string> row;
    std::map<std::string, fs::file_time_type> written;
    bool operator==(const Point&) const = default;
  };

  std::map<std::string, Point> finished_points() const {
    std::map<std::string, Point> points;
    const std::string text = read("out/scan.csv");
    write("rows.csv", text.substr(0, text.rfind('\n') + 1));  // without a row that was cut
    const Table scan = table("rows.csv");
    for (std::size_t row = 0; row < scan.rows.size(); ++row) {
      std::string stem = scan.text(row, "model");
      stem.append("_").append(scan.text(row, "branch"));
      stem.append("_v").append(scan.text(row, "reduced_volume"));
      stem.append("_L").append(scan.text(row, "L"));
      Point& point = points[stem];
      point.row = scan.rows[row];
      for (const std::string column : {"fold_L", "fold_L_error"})
        point.row[std::size_t(std::ranges::find(scan.columns, column) - scan.columns.begin())]
            .clear();
      for (const std::string ending : {".csv", ".series.csv"}) {
        const fs::path file = path("out/points") / (stem + ending);
        if (exists(file)) point.written[ending] = last_write_time(file);
      }
    }
    return points;
  }

  /// Runs until there are so many rows, a moment longer, then kills.
  void kill_with_rows(int rows) {
    Program program(here(), {"scan", "in.toml", "-o", "out", "--no-pictures", "--threads", "2"});
    ASSERT_TRUE(wait_until([&] { return lines("out/scan.csv") > rows || !program.is_running(); }));
    std::this_thread::sleep_for(std::chrono::microseconds(random_() % 8000));
    program.send(SIGKILL);
    ASSERT_EQ(program.wait().signal, SIGKILL);
  }

  /// Lets it finish; nothing that was there may be computed again, all must be as in "whole".
  void finish_and_compare(const std::map<std::string, Point>& before) {
    must(into("out", "scan"));
    const auto after = finished_points();
    for (const auto& [stem, point] : before) EXPECT_TRUE(after.at(stem) == point) << stem;
    expect_same_as_whole();
  }

  void expect_same_as_whole() const {
    EXPECT_EQ(table("out/scan.csv").without("wall_seconds"),
              table("whole/scan.csv").without("wall_seconds"));
    Contents out = contents("out"), whole = contents("whole");
    out.erase("scan.csv"), whole.erase("scan.csv");
    EXPECT_TRUE(out == whole);  // and nothing else lies about
  }

  std::mt19937 random_{1};
};

TEST_F(Resume, after_kills_at_random_moments_repeats_nothing_and_ends_with_the_same_bytes) {
  write("in.toml", map);
  must(into("whole", "scan"));
  std::map<std::string, Point> before;
  for (const int rows : {0, 1, 40, 90, 170, 260}) {
    kill_with_rows(rows);
    const auto now = finished_points();
    for (const auto& [stem, point] : before) EXPECT_TRUE(now.at(stem) == point) << stem;
    before.insert(now.begin(), now.end());
  }
  EXPECT_GE(before.size(), 260u);
  EXPECT_LT(before.size(), 400u);
  finish_and_compare(before);
}

TEST_F(Resume, of_a_scan_by_the_flow_repeats_nothing_and_ends_with_the_same_bytes) {
  write("in.toml", by_flow);
  must(into("whole", "scan"));
  std::map<std::string, Point> before;
  for (const int rows : {2, 5, 9}) {
    kill_with_rows(rows);
    before = finished_points();
    EXPECT_GE(int(before.size()), rows);
  }
  EXPECT_LT(before.size(), 16u);
  finish_and_compare(before);
}

TEST_F(Resume, computes_only_the_row_that_was_cut_in_the_middle) {
  write("in.toml", small_map);
  must(into("whole", "scan"));
  for (const int bytes : {1, 7, 300}) {
    fs::remove_all(path("out"));
    kill_with_rows(30);
    fs::resize_file(path("out/scan.csv"),
                    read("out/scan.csv").rfind('\n') + 1 - std::size_t(bytes));
    finish_and_compare(finished_points());
  }
}

TEST_F(Resume, takes_no_notice_of_files_that_were_left_half_written) {
  write("in.toml", small_map);
  must(into("whole", "scan"));
  kill_with_rows(10);
  const auto before = finished_points();
  for (const char* stem : {"SBEH_prolate_v0.6_L0.06", "SBEH_prolate_v0.6_L0.08"})
    ASSERT_FALSE(before.contains(stem));
  write("out/scan.csv.part", "model,redu");
  write("out/points/SBEH_prolate_v0.6_L0.06.csv.part", "arc_le");
  write("out/points/SBEH_prolate_v0.6_L0.08.csv", "half a profile, without a row");
  finish_and_compare(before);
}

TEST_F(Resume, refuses_a_damaged_row_with_its_line_and_changes_nothing) {
  write("in.toml", small_map);
  kill_with_rows(20);
  std::string text = read("out/scan.csv");
  std::size_t line_3 = text.find('\n', text.find('\n') + 1) + 1;
  write("out/scan.csv", text.replace(line_3, 60, "???"));
  const Contents before = contents("out");
  must_refuse(into("out", "scan"), "out/scan.csv:3: is damaged; delete that line");
  EXPECT_EQ(contents("out"), before);
}

TEST_F(Resume, refuses_a_damaged_profile_and_computes_it_again_when_it_is_deleted) {
  write("in.toml",
        "[scan]\nreduced_volume = [0.7, 0.8]\nL = [0.04, 0.05]\n[numerics]\nelements = 16\n");
  must(into("whole", "scan"));
  fs::copy(path("whole"), path("out"), fs::copy_options::recursive);
  write("out/points/SBEH_oblate_v0.7_L0.04.csv", "arc_length,r,z,order,mean_curvature\n0,0,1\n");
  const Ended refused = sbeh(into("out", "scan"));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("sbeh: out/points/SBEH_oblate_v0.7_L0.04.csv: line 2 is damaged: "
                             "delete it to have it computed again\n"),
            std::string::npos)
      << refused.err;
  fs::remove(path("out/points/SBEH_oblate_v0.7_L0.04.csv"));
  const Ended mended = sbeh(into("out", "scan"));
  EXPECT_NE(mended.out.find("; 1 computed"), std::string::npos) << mended.out << mended.err;
  expect_same_as_whole();
}

}  // namespace
}  // namespace sbeh::tools::test
