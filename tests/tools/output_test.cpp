// Folders of results: which are refused, who may write there, and full disks.
#include "tests/tools/workplace.h"

#include <unistd.h>

#include <csignal>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;
using Output = Workplace;

const std::string small =
    "[scan]\nreduced_volume = [0.7, 0.8]\nL = [0.04, 0.05]\n[numerics]\nelements = 16\n";
const std::string map =
    "[scan]\nreduced_volume = {from = 0.65, to = 0.95, count = 15}\n"
    "L = {from = 0.005, to = 0.06, count = 5}\n[numerics]\nelements = 16\n";
const std::string without_times =
    "model = \"SSH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n"
    "[numerics]\nelements = 16\n";
const std::string evolution = without_times + "[time]\nend = 0.01\n";

TEST_F(Output, into_what_is_no_folder_is_refused) {
  write("scan.toml", small);
  write("relax.toml", evolution);
  write("file", "precious");
  const Contents before = contents("");
  const std::string cannot = ": cannot be made a folder for results: ";
  for (const std::string command : {"scan", "relax"}) {
    const std::string file = command + ".toml";
    must_refuse(into("file", command, file), "file" + cannot + "there is a file of that name");
    must_refuse(into("file/sub", command, file), "file/sub" + cannot + "Not a directory");
    must_refuse(into("/dev/null", command, file), "/dev/null" + cannot);
    must_refuse(into("/proc/sbeh", command, file), "/proc/sbeh" + cannot);
  }
  EXPECT_EQ(contents(""), before);
}

TEST_F(Output, into_the_folder_of_another_run_is_refused_and_changes_nothing) {
  write("in.toml", small);
  write("other.toml", "[scan]\nreduced_volume = [0.7, 0.8]\nL = [0.04, 0.06]\n");
  write("relax.toml", evolution);
  must(into("scan", "scan"));
  must(into("relax", "relax", "relax.toml"));
  const Contents scan = contents("scan"), relax = contents("relax");
  must_refuse(into("scan", "scan", "other.toml"),
              "scan: holds a scan with other parameters: scan.L: [0.04, 0.05] there, [0.04, 0.06] "
              "here; numerics.elements: 16 there, 48 here; choose");
  must_refuse(into("scan", "relax", "relax.toml"), "scan: already holds results");
  must_refuse(into("relax", "relax", "relax.toml"), "relax: already holds results");
  must_refuse(into("relax", "scan"), "relax: holds other results than a scan (see its run.toml)");
  EXPECT_EQ(contents("scan"), scan);
  EXPECT_EQ(contents("relax"), relax);
}

TEST_F(Output, into_a_folder_that_lost_its_run_toml_is_refused_and_changes_nothing) {
  write("in.toml", small);
  write("relax.toml", evolution);
  must(into("scan", "scan"));
  must(into("relax", "relax", "relax.toml"));
  fs::remove(path("scan/run.toml"));
  fs::remove(path("relax/run.toml"));
  const Contents before = contents("");
  must_refuse(into("scan", "scan"), "scan: holds a table without its run.toml");
  must_refuse(into("relax", "relax", "relax.toml"), "relax: already holds results");
  EXPECT_EQ(contents(""), before);
}

TEST_F(Output, of_two_scans_at_once_into_one_folder_is_refused_until_the_first_has_died) {
  write("in.toml", map);
  Program first(here(), into("out", "scan"));
  ASSERT_TRUE(wait_until([&] { return lines("out/scan.csv") > 3; }));
  first.pause();
  const Contents before = contents("out");
  must_refuse(into("out", "scan"), "out: another run is writing there");
  EXPECT_EQ(contents("out"), before);
  first.send(SIGKILL);
  EXPECT_EQ(first.wait().signal, SIGKILL);
  must(into("out", "scan"));
  EXPECT_EQ(table("out/scan.csv").rows.size(), 150u);
}

// A file that the next write of `part` goes to, in place of its own: there is never room in it.
void fill_disk_for(const fs::path& part) {
  fs::create_directories(part.parent_path());
  fs::create_symlink("/dev/full", part);
}

TEST_F(Output, of_a_point_on_a_full_disk_ends_with_a_sentence_and_resumes_when_there_is_room) {
  write("in.toml", small);
  must(into("whole", "scan"));
  const std::string point = "out/points/SBEH_oblate_v0.7_L0.05.csv";
  fill_disk_for(path(point + ".part"));
  const Ended full = sbeh(into("out", "scan"));
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_NE(full.err.find("sbeh: " + point + ": cannot be written: No space left on device\n"),
            std::string::npos)
      << full.err;
  must(into("out", "scan"));
  EXPECT_EQ(table("out/scan.csv").without("wall_seconds"),
            table("whole/scan.csv").without("wall_seconds"));
  EXPECT_EQ(contents("out/points"), contents("whole/points"));
}

TEST_F(Output, of_a_table_on_a_full_disk_keeps_its_rows_and_resumes_when_there_is_room) {
  write("in.toml", map);
  must(into("whole", "scan"));
  Surroundings full = here();
  full.largest_file = 20000;  // some forty rows
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Ended ended = run(full, into("out", "scan"));
    EXPECT_EQ(ended.exit_code, 2) << ended.signal;
    EXPECT_NE(ended.err.find("sbeh: out/scan.csv: cannot be written any further: File too large\n"),
              std::string::npos)
        << ended.err;
    EXPECT_GT(lines("out/scan.csv"), 20);
  }
  must(into("out", "scan"));
  EXPECT_EQ(table("out/scan.csv").without("wall_seconds"),
            table("whole/scan.csv").without("wall_seconds"));
  EXPECT_EQ(contents("out/points"), contents("whole/points"));
}

TEST_F(Output, on_a_disk_without_any_room_ends_with_a_sentence_and_starts_when_there_is_room) {
  write("scan.toml", small);
  write("relax.toml", evolution);
  Surroundings full = here();
  full.largest_file = 10;
  for (const std::string command : {"scan", "relax"}) {
    const Ended ended = run(full, into(command, command, command + ".toml"));
    EXPECT_EQ(ended.exit_code, 2) << ended.signal;
    EXPECT_NE(ended.err, "");  // as much of it as the limit lets through
    must(into(command, command, command + ".toml"));
  }
}

TEST_F(Output, of_an_evolution_on_a_full_disk_keeps_what_is_written) {
  write("in.toml", without_times
                       + "[time]\nend = 0.01\n"
                         "output = { from = 1e-5, to = 0.01, count = 200, spacing = \"log\" }\n");
  must(into("whole", "relax"));
  Surroundings full = here();
  full.largest_file = 30000;
  const Ended ended = run(full, into("out", "relax"));
  EXPECT_EQ(ended.exit_code, 2) << ended.signal;
  EXPECT_EQ(ended.err, "sbeh: out/series.csv: cannot be written any further: File too large\n");
  const std::string series = read("out/series.csv");
  EXPECT_TRUE(read("whole/series.csv").starts_with(series));
  EXPECT_GT(lines("out/series.csv"), 20);
  const Contents before = contents("out");
  must_refuse(into("out", "relax"), "out: already holds results");
  EXPECT_EQ(contents("out"), before);
}

}  // namespace
}  // namespace sbeh::tools::test
