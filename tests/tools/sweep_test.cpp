// Sweeps as their user sees them: folders, tables, what goes on, what fails, refusals.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <filesystem>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

const std::string small_case =
    "model = \"SSH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.9\n"
    "[numerics]\nelements = 16\n[time]\nend = 0.05\n";

// Four small evolutions.
const std::string four = small_case
                       + "[sweep.grid]\n\"material.viscosity\" = [1, 2]\n"
                         "\"start.reduced_volume\" = [0.85, 0.9]\n";

class Sweep : public Workplace {
 protected:
  void make(const std::string& text, const std::string& folder = "out") const {
    write("in.toml", text);
    must({"sweep", "in.toml", "-o", folder});
  }
  // The results, without what locks them.
  Contents results(const std::string& folder) const {
    Contents all = contents(folder);
    std::erase_if(all, [](const auto& one) { return one.first.ends_with(".lock"); });
    return all;
  }
};

TEST_F(Sweep, makes_a_folder_of_cases_each_of_which_is_an_input) {
  make(four);
  for (const char* number : {"0001", "0002", "0003", "0004"})
    must({"check", path(fmt::format("out/cases/{}/run.toml", number)).string()});
  const Table plan = table("out/plan.csv");
  ASSERT_EQ(plan.rows.size(), 4u);
  EXPECT_EQ(plan.text(2, "material.viscosity"), "2");
  EXPECT_EQ(plan.text(2, "start.reduced_volume"), "0.85");
  const Ended again = sbeh({"sweep", "in.toml", "-o", "out"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(again.out.starts_with("4 cases of sbeh relax already there in out, about "))
      << again.out;
}

TEST_F(Sweep, is_worked_through_and_its_table_has_inputs_and_results) {
  make(four);
  const Ended ended = sbeh({"sweep", "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "4 cases in out: 4 done; all in out/sweep.csv\n");
  const Table sweep = table("out/sweep.csv");
  ASSERT_EQ(sweep.rows.size(), 4u);
  for (std::size_t row = 0; row < 4; ++row) {
    const Table series = table(fmt::format("out/cases/000{}/series.csv", row + 1));
    EXPECT_EQ(sweep.text(row, "case"), std::to_string(row + 1));
    EXPECT_EQ(sweep.text(row, "status"), "done");
    EXPECT_EQ(sweep.text(row, "material.viscosity"), row < 2 ? "1" : "2");
    for (const char* column : {"time", "energy", "reduced_volume"})
      EXPECT_EQ(sweep.text(row, column), series.text(series.rows.size() - 1, column));
    EXPECT_EQ(sweep.text(row, "class"), "oblate");
    EXPECT_EQ(sweep.text(row, "stop_reason"), "end time reached");
  }
}

TEST_F(Sweep, leaves_of_each_case_what_its_command_leaves) {
  make(four);
  must({"sweep", "out"});
  must(into("alone", "relax", "out/cases/0003/run.toml"));
  EXPECT_TRUE(results("alone") == results("out/cases/0003"));
}

TEST_F(Sweep, that_is_done_is_not_repeated) {
  make(four);
  must({"sweep", "out"});
  const Contents before = contents("out");
  const auto written_at = fs::last_write_time(path("out/cases/0001/series.csv"));
  must({"sweep", "out"});
  EXPECT_TRUE(contents("out") == before);
  EXPECT_EQ(fs::last_write_time(path("out/cases/0001/series.csv")), written_at);
}

TEST_F(Sweep, in_parts_or_by_two_at_once_is_the_same) {
  make(four, "whole");
  must({"sweep", "whole", "--jobs", "1"});
  make(four, "parts");
  for (const char* part : {"2/3", "1/3", "3/3"}) must({"sweep", "parts", "--part", part});
  EXPECT_FALSE(exists(path("parts/sweep.csv")));
  must({"sweep", "parts", "--table"});
  make(four, "both");
  Program first(here(), {"sweep", "both", "--jobs", "2"});
  Program second(here(), {"sweep", "both", "--jobs", "2"});
  const Ended ends[] = {first.wait(), second.wait()};
  for (const Ended& end : ends) EXPECT_EQ(end.exit_code, 0) << end.err;
  must({"sweep", "both", "--table"});
  for (const std::string other : {"parts", "both"}) {
    EXPECT_EQ(read(other + "/sweep.csv"), read("whole/sweep.csv"));
    EXPECT_TRUE(results(other + "/cases") == results("whole/cases"));
  }
  for (int number = 1; number <= 4; ++number)  // each was run once
    EXPECT_EQ(lines(fmt::format("both/logs/000{}.txt", number)),
              lines(fmt::format("whole/logs/000{}.txt", number)));
}

// The second case takes long enough to be in the middle of it.
const std::string long_second =
    small_case + "[sweep.grid]\n\"numerics.largest_step\" = [0.05, 2e-5]\n";

TEST_F(Sweep, that_is_interrupted_or_killed_goes_on_from_there) {
  make(long_second, "whole");
  must({"sweep", "whole", "--jobs", "1"});
  make(long_second, "out");
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const int before = lines("out/logs/0002.txt");
    fs::remove(path("out/cases/0002/series.csv"));
    Program program(here(), {"sweep", "out", "--jobs", "1"});
    ASSERT_TRUE(wait_until(
        [&] { return lines("out/cases/0002/series.csv") > 20 || !program.is_running(); }));
    EXPECT_TRUE(program.is_running()) << "ended before it could be interrupted";
    program.send(signal);
    const Ended ended = program.wait();
    if (signal != SIGKILL) {
      EXPECT_EQ(ended.exit_code, 128 + signal) << ended.err;
      EXPECT_TRUE(ended.err.ends_with("sbeh: interrupted; the same command goes on from here\n"))
          << ended.err;
    }
    ASSERT_TRUE(wait_until([&] { return lines("out/logs/0002.txt") > before; }));  // the case too
    EXPECT_EQ(
        sbeh({"sweep", "out", "--status"}).out.find("2 cases of sbeh relax in out: 1 done, 1 "),
        0u);
  }
  must({"sweep", "out", "--part", "2/2"});  // waits for what is left of the killed one
  must({"sweep", "out"});
  EXPECT_EQ(read("out/sweep.csv"), read("whole/sweep.csv"));
  EXPECT_TRUE(results("out/cases") == results("whole/cases"));
}

TEST_F(Sweep, tells_which_case_failed_and_why_and_tries_it_again_when_asked) {
  std::string base = small_case;
  base.insert(base.find("elements"), "first_step = 1e-3\nsmallest_step = 1e-3\n");
  write("base.toml", base);
  make("[sweep]\nbase = \"base.toml\"\n[sweep.grid]\n\"numerics.tolerance\" = [1e-4, 1e-12]\n");
  const Ended ended = sbeh({"sweep", "out"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_EQ(ended.out, "2 cases in out: 1 done, 1 failed; all in out/sweep.csv\n");
  EXPECT_NE(ended.err.find("case 2: "), std::string::npos) << ended.err;
  const Table sweep = table("out/sweep.csv");
  EXPECT_EQ(sweep.text(1, "status"), "failed");
  EXPECT_NE(sweep.text(1, "reason"), "");
  EXPECT_EQ(sweep.text(1, "stop_reason"), "");
  const Ended status = sbeh({"sweep", "out", "--status"});
  EXPECT_EQ(status.exit_code, 0);
  EXPECT_EQ(status.out,
            fmt::format("2 cases of sbeh relax in out: 1 done, 1 failed\ncase 2: {} (see "
                        "out/logs/0002.txt)\n",
                        sweep.text(1, "reason")));
  const int before = lines("out/logs/0002.txt");
  EXPECT_EQ(sbeh({"sweep", "out"}).exit_code, 1);
  EXPECT_EQ(lines("out/logs/0002.txt"), before);  // not by itself
  EXPECT_EQ(sbeh({"sweep", "out", "--retry"}).exit_code, 1);
  EXPECT_GT(lines("out/logs/0002.txt"), before);
}

TEST_F(Sweep, does_not_run_a_case_that_was_edited) {
  make(four);
  const std::string input = read("out/cases/0002/run.toml");
  write("out/cases/0002/run.toml", input + "# a remark changes nothing\n");
  std::string edited = read("out/cases/0003/run.toml");
  edited.replace(edited.find("viscosity = 2"), 13, "viscosity = 3");
  write("out/cases/0003/run.toml", edited);
  const Ended ended = sbeh({"sweep", "out"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_EQ(ended.out, "4 cases in out: 3 done, 1 edited; all in out/sweep.csv\n");
  EXPECT_NE(
      ended.err.find("sbeh: case 3: out/cases/0003/run.toml is not what the sweep made it, and "
                     "is not run: put it back, or run it in a folder of its own\n"),
      std::string::npos)
      << ended.err;
  EXPECT_FALSE(exists(path("out/cases/0003/series.csv")));
}

TEST_F(Sweep, in_the_folder_of_another_is_refused) {
  make(four);
  write("in.toml", small_case + "[sweep.grid]\n\"material.viscosity\" = [1, 3]\n");
  const Contents before = contents("out");
  must_refuse(
      {"sweep", "in.toml", "-o", "out"},
      "out: holds another sweep (see its plan.csv), which is not overwritten; choose another "
      "folder with -o");
  write("relaxed/series.csv", "time\n");
  must_refuse({"sweep", "in.toml", "-o", "relaxed"}, "relaxed: already holds results");
  EXPECT_TRUE(contents("out") == before);
}

TEST_F(Sweep, that_is_wrong_is_refused_before_anything_is_written) {
  write("in.toml", small_case + "[sweep.grid]\n\"material.viscosity\" = [1, -1]\n");
  must_refuse({"sweep", "in.toml", "-o", "out"},
              "in.toml: case 2 (material.viscosity = -1): in.toml: ");
  must_refuse({"check", "in.toml"}, "in.toml: case 2 (material.viscosity = -1): in.toml: ");
  must_refuse({"relax", "in.toml"}, "in.toml: is an input: for sbeh sweep in.toml or sbeh check");
  write("in.toml", small_case);
  must_refuse({"sweep", "in.toml"}, "in.toml: is an input: for sbeh relax in.toml or sbeh check");
  must_refuse({"sweep", "in.toml", "--status"}, "in.toml: is an input: ");
  fs::create_directory(path("empty"));
  must_refuse({"sweep", "empty"}, "empty: holds no sweep: it has no plan.csv (make it by: ");
  fs::remove(path("empty"));
  EXPECT_EQ(contents("").size(), 1u);
  make(four);
  must_refuse({"sweep", "out", "--part", "4/3"}, "--part 4/3: must be such as 3/16");
  must_refuse({"sweep", "out", "--status", "--retry"}, "--status excludes --retry");
  must_refuse({"sweep", "in.toml", "--jobs", "2"},
              "in.toml: is an input: sbeh sweep in.toml makes");
  must_refuse({"sweep", "out", "-o", "more"}, "-o more: belongs to an input; out is a folder");
}

TEST_F(Sweep, on_a_full_disk_says_so_and_is_gone_on_with) {
  write("in.toml", four);
  Surroundings full = here();
  full.largest_file = 100;
  const Ended refused = run(full, {"sweep", "in.toml", "-o", "out"});
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_NE(refused.err.find("cannot be written: "), std::string::npos) << refused.err;
  must({"sweep", "in.toml", "-o", "out"});
  full.largest_file = 5000;  // enough for what ends a case, not for its results
  EXPECT_EQ(run(full, {"sweep", "out"}).exit_code, 1);
  EXPECT_NE(read("out/sweep.csv").find("cannot be written"), std::string::npos);
  must({"sweep", "out", "--retry"});
  make(four, "whole");
  must({"sweep", "whole"});
  EXPECT_EQ(read("out/sweep.csv"), read("whole/sweep.csv"));
}

TEST_F(Sweep, is_submitted_by_scripts_and_without_sbatch_says_so) {
  make(four);
  const Ended dry = sbeh({"sweep", "out", "--slurm", "--dry-run", "--jobs", "3"});
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_EQ(dry.out, "4 cases as 4 tasks: out/sweep.sbatch, and after them out/table.sbatch\n");
  const std::string script = read("out/sweep.sbatch");
  for (const char* line : {"#SBATCH --array=1-4%3\n", "#SBATCH --requeue\n", "#SBATCH --time=10\n",
                           "#SBATCH --mem=200M\n", "#SBATCH --cpus-per-task=1\n",
                           " sweep 'out' --part \"$SLURM_ARRAY_TASK_ID/4\" --threads 1\n"})
    EXPECT_NE(script.find(line), std::string::npos) << line << script;
  must({"sweep", "out", "--part", "2/4"});
  must({"sweep", "out", "--slurm", "--dry-run"});
  EXPECT_NE(read("out/sweep.sbatch").find("#SBATCH --array=1,3-4\n"), std::string::npos);
  Surroundings bare = here();
  bare.environment = {"PATH=/nonexistent"};
  const Ended ended = run(bare, {"sweep", "out", "--slurm"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_EQ(ended.err,
            "sbeh: sbatch is not there: is this a machine from which jobs of Slurm are "
            "submitted? There: sbatch out/sweep.sbatch\n");
}

TEST_F(Sweep, has_a_report_with_a_chart_of_each_case) {
  make(four);
  must({"sweep", "out"});
  const Ended ended = sbeh({"report", "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_EQ(ended.out, "wrote out/report.html\n");
  const std::string page = read("out/report.html");
  std::size_t charts = 0;
  for (std::size_t at = 0; (at = page.find("<figure", at)) != std::string::npos; ++at) ++charts;
  EXPECT_EQ(charts, 4u);
  for (const char* words : {"<h1>Sweep: 4 cases of sbeh relax</h1>",
                            "4: viscosity = 2, reduced_volume = 0.9", "material.viscosity"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_EQ(sbeh({"report", "out"}).out, "replaced the earlier report out/report.html\n");
  must_refuse({"report", "out", "--units"}, "out: is a sweep, whose report has no units");
}

TEST_F(Sweep, says_of_its_evolutions_that_came_to_rest_that_they_did) {
  make(
      "model = \"SSH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.9\nkind = \"prolate\"\n"
      "[numerics]\nelements = 16\nrest_speed = 1e-2\n[time]\nend = 50\n"
      "[sweep.grid]\n\"material.viscosity\" = [1]\n");
  must({"sweep", "out"});
  const Table sweep = table("out/sweep.csv");
  EXPECT_EQ(sweep.text(0, "class"), "prolate");
  EXPECT_EQ(sweep.text(0, "stop_reason"), "at rest");
  EXPECT_LT(sweep.number(0, "time"), 50);
}

TEST_F(Sweep, of_scans_of_states_and_of_runs_has_the_lowest_energies) {
  write("scan.toml",
        "[scan]\nreduced_volume = [0.8, 0.9]\nL = 0.05\nmodels = [\"SSH\"]\nmodes = 0\n"
        "[numerics]\nelements = 16\n[sweep.grid]\n\"material.residual_stiffness\" = [0, 0.1]\n");
  write("states.toml",
        "[states]\nmodel = \"SSH\"\nreduced_volume = 0.8\nL = 0.05\neigenpairs = 0\n"
        "[sweep.grid]\n\"states.reduced_volume\" = [[0.8, 0.9], [0.85]]\n");
  write("run.toml",
        "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.9\ntriangles = 80\n"
        "[time]\nend = 1e-4\n[sweep.grid]\n\"surface.reduced_volume\" = [0.85, 0.9]\n");
  for (const std::string kind : {"scan", "states", "run"}) {
    must({"sweep", kind + ".toml", "-o", kind});
    must({"sweep", kind});
    const Table sweep = table(kind + "/sweep.csv");
    ASSERT_EQ(sweep.rows.size(), 2u);
    EXPECT_EQ(sweep.text(0, "stop_reason"), kind == "run" ? "end time reached" : "stationary");
    if (kind == "run") {
      EXPECT_EQ(sweep.text(0, "class"), "Dooh");
      continue;
    }
    EXPECT_EQ(sweep.text(0, "lowest_class"), kind == "scan" ? "oblate" : "Dooh");
    EXPECT_EQ(sweep.text(0, "states"), "2");
    EXPECT_EQ(sweep.text(0, "stationary"), "2");
    const Table of_case = table(fmt::format("{0}/cases/0001/{0}.csv", kind));
    const std::vector<double> energies = of_case.numbers("energy");
    EXPECT_EQ(sweep.number(0, "lowest_energy"), *std::ranges::min_element(energies));
    EXPECT_EQ(sweep.text(0, "lowest_model"), "SSH");
  }
}

}  // namespace
}  // namespace sbeh::tools::test
