// 3D runs that are killed at any moment, and full disks: nothing is lost that was written, and a resumed
// run leaves the same bits.
#include "tests/tools/workplace.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <thread>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;

// Small steps on a small mesh: most of the time goes into files.
const std::string start =
    "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.97\ntriangles = 20\n"
    "[numerics]\ntolerance = 0.01\n[time]\nend = 0.08\n";
const std::string many_rows = "output = {from = 0.0005, to = 0.08, count = 160}\n";
const std::string many_frames = "frames = {from = 0.004, to = 0.08, count = 20}\n";
const std::string checkpoint_each_step = "checkpoint_minutes = 1e-9\n";

class ResumeRun : public Workplace {
 protected:
  /// Runs the same without a disturbance into "whole".
  void input(const std::string& text) const {
    write("in.toml", text);
    must(into("whole", "run"));
  }
  static std::vector<std::string> resumed(const std::string& results) {
    auto arguments = into(results, "run");
    arguments.emplace_back("--resume");
    return arguments;
  }
  void must_end_as_the_whole() const {
    must(resumed("out"));
    EXPECT_EQ(contents("out"), contents("whole"));
  }
  /// Kills it when `due`.
  void kill_when(const std::vector<std::string>& arguments,
                 const std::function<bool()>& due) const {
    Program program(here(), arguments);
    ASSERT_TRUE(wait_until([&] { return due() || !program.is_running(); }));
    program.send(SIGKILL);
    EXPECT_EQ(program.wait().signal, SIGKILL) << "ended before it could be killed";
  }
  void kill_while_writing(const std::string& file) const;
};

// Puts a pipe of one page in the place of the temporary file, kills the program when the pipe is full,
// and leaves of the file what went through.
void ResumeRun::kill_while_writing(const std::string& file) const {
  const fs::path part = path("out/" + file + ".part");
  fs::create_directories(part.parent_path());
  ASSERT_EQ(mkfifo(part.c_str(), 0666), 0);
  const int reader = open(part.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(fcntl(reader, F_SETPIPE_SZ, 4096), 4096);
  std::array<char, 1024> begun{};
  ssize_t got = 0;
  kill_when(into("out", "run"),
            [&] { return (got = ::read(reader, begun.data(), begun.size())) > 0; });
  close(reader);
  fs::remove(part);
  ASSERT_GT(got, 0);
  write("out/" + file + ".part", std::string(begun.data(), std::size_t(got)));
}

TEST_F(ResumeRun, after_kills_at_many_moments_ends_with_the_same_bits) {
  input(start + many_rows + many_frames + checkpoint_each_step);
  int killed = 0;
  kill_when(into("out", "run"), [&] { return exists(path("out/run.toml")); });
  for (const int milliseconds : {5, 10, 20, 30, 40, 55, 70, 90, 120, 160, 210, 270, 340, 420}) {
    Program program(here(), resumed("out"));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.send(SIGKILL);
    const Ended ended = program.wait();
    EXPECT_TRUE(ended.signal == SIGKILL || ended.exit_code == 0) << ended.err;
    // Early ones leave no state yet.
    if (ended.err != "sbeh: out: no state is there yet: the run begins\n") {
      EXPECT_EQ(ended.err, "");
    }
    killed += ended.signal == SIGKILL;
  }
  EXPECT_GT(killed, 4);
  must_end_as_the_whole();
}

TEST_F(ResumeRun, takes_no_notice_of_what_was_being_written) {
  input(start + many_rows + many_frames + checkpoint_each_step);
  for (const char* file : {"frames/0000.vtu", "checkpoint.vtu", "frames/0007.vtu"}) {
    fs::remove_all(path("out"));
    kill_while_writing(file);
    must_end_as_the_whole();
  }
}

TEST_F(ResumeRun, takes_no_notice_of_rows_that_were_cut) {
  for (const std::string& rows : {many_rows, std::string("output = 0\nevery_step = true\n")}) {
    std::string text = start;
    input(text.append(rows).append(many_frames));
    for (const std::string table : {"out/series.csv", "out/frames.csv"}) {
      fs::remove_all(path("out"));
      kill_when(into("out", "run"), [&] { return lines(table) > 6; });
      fs::resize_file(path(table), read(table).rfind('\n') - 4);
      must_end_as_the_whole();
    }
    fs::remove_all(path("whole"));
    fs::remove_all(path("out"));
  }
}

TEST_F(ResumeRun, goes_on_from_the_newest_of_frames_and_checkpoint) {
  input(start + many_rows + "frames = [0]\n" + checkpoint_each_step);
  kill_when(into("out", "run"), [&] { return lines("out/series.csv") > 20; });
  ASSERT_TRUE(exists(path("out/checkpoint.vtu")));
  // It may have been killed between a row and the checkpoint of the same step.
  const double before = table("out/series.csv").numbers("time").at(18);
  fs::copy(path("out"), path("damaged"), fs::copy_options::recursive);
  const Ended ended = sbeh(resumed("out"));
  const std::string from = "resumed from t = ";
  ASSERT_NE(ended.out.find(from), std::string::npos) << ended.out;
  EXPECT_GT(std::stod(ended.out.substr(ended.out.find(from) + from.size())), 0.99 * before);
  EXPECT_EQ(contents("out"), contents("whole"));

  fs::resize_file(path("damaged/checkpoint.vtu"), 1000);
  const Ended again = sbeh(resumed("damaged"));
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_TRUE(again.err.starts_with("sbeh: damaged/checkpoint.vtu: ")) << again.err;
  EXPECT_TRUE(again.err.ends_with("; going back to the state before it\n")) << again.err;
  EXPECT_EQ(contents("damaged"), contents("whole"));
}

TEST_F(ResumeRun, without_a_frame_that_can_be_read_is_refused_and_changes_nothing) {
  input(start + many_rows + "frames = [0, 0.001]\n");
  kill_when(into("out", "run"), [&] { return lines("out/frames.csv") > 2; });
  for (const char* frame : {"out/frames/0000.vtu", "out/frames/0001.vtu"})
    fs::resize_file(path(frame), 1000);
  const Contents before = contents("out");
  const Ended ended = sbeh(resumed("out"));
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_TRUE(ended.err.ends_with(
      "sbeh: out: none of its frames can be read; choose another folder with -o, or delete its "
      "run.toml and series.csv to start anew\n"))
      << ended.err;
  EXPECT_EQ(contents("out"), before);
  for (const char* file : {"out/run.toml", "out/series.csv"}) fs::remove(path(file));
  must(into("out", "run"));
  EXPECT_EQ(contents("out"), contents("whole"));
}

TEST_F(ResumeRun, needs_its_start_no_more) {
  must({"mesh", "ellipsoid", "--reduced-volume", "0.97", "--triangles", "20", "-o", "mesh.vtu"});
  input(
      "model = \"SBEH\"\n[surface]\nshape = \"mesh\"\nfile = \"mesh.vtu\"\n[time]\nend = 0.01\n"
      "frames = [0, 0.001]\noutput = [0.01]\n");
  kill_when(into("out", "run"), [&] { return lines("out/frames.csv") > 2; });
  fs::remove(path("mesh.vtu"));
  must_end_as_the_whole();
}

TEST_F(ResumeRun, may_keep_other_checkpoints) {
  input(start + many_rows + "frames = [0]\n");
  kill_when(into("out", "run"), [&] { return lines("out/series.csv") > 3; });
  write("in.toml", start + many_rows + "frames = [0]\ncheckpoint_minutes = 0.5\n");
  must(resumed("out"));
  Contents out = contents("out"), whole = contents("whole");
  EXPECT_NE(out["run.toml"].find("checkpoint_minutes = 0.5"), std::string::npos);
  out.erase("run.toml"), whole.erase("run.toml");
  EXPECT_EQ(out, whole);
}

TEST_F(ResumeRun, of_a_run_that_has_ended_changes_nothing) {
  const std::string sphere =
      "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 1\ntriangles = 20\n"
      "[numerics]\nrest_speed = 1\n[time]\nend = 100\noutput = [0]\nframes = [0]\n";
  for (const std::string& text : {start + "output = [0]\nframes = [0]\n", sphere}) {
    write("in.toml", text);
    must(into("out", "run"));
    const Contents before = contents("out");
    must(resumed("out"));
    EXPECT_EQ(contents("out"), before);
    fs::remove_all(path("out"));
  }
}

TEST_F(ResumeRun, needs_no_frame_from_which_it_started) {
  write("in.toml", start + "output = [0]\nframes = [0]\n[material]\nL = 0.08\n");
  must(into("first", "run"));
  input(
      "[surface]\nshape = \"frame\"\nfile = \"first/frames/0000.vtu\"\n[material]\nviscosity = 2\n"
      "[numerics]\ntolerance = 0.01\n[time]\nend = 0.08\n"
      + many_rows + many_frames);
  kill_when(into("out", "run"), [&] { return lines("out/frames.csv") > 2; });
  fs::remove_all(path("first"));
  must_end_as_the_whole();
}

// ---- longer runs --------------------------------------------------------------------------------

std::string until(double end, const std::string& rest) {
  std::string text = start;
  return text.replace(text.find("0.08"), 4, std::to_string(end)) + rest;
}

TEST_F(ResumeRun, may_go_on_beyond_its_end_to_the_same_bits_as_one_that_was_asked_for_all) {
  struct Times {
    std::string first, all;
  };
  const std::vector<Times> cases{
      {"output = [0, 0.01]\nframes = [0, 0.01]\n", "output = [0, 0.01]\nframes = [0, 0.01]\n"},
      {"output = [0, 0.01]\nframes = [0, 0.01]\n",
       "output = [0, 0.01, 0.015]\nframes = [0, 0.01, 0.02]\n"},
      {"output = [0.003, 0.01]\nframes = [0.01]\n",
       "output = [0.003, 0.01, 0.012, 0.02]\nframes = [0.01, 0.013, 0.017]\n"},
      {"output = [0, 0.01]\nframes = [0, 0.01]\nevery_step = true\n",
       "output = [0, 0.01]\nframes = [0, 0.01, 0.02]\nevery_step = true\n"},
      {"output = [0.01]\nframes = [0.01]\nstop_at_rest = false\n",
       "output = [0.01, 0.02]\nframes = [0.01]\nstop_at_rest = false\ncheckpoint_minutes = 3\n"},
  };
  for (const auto& [first, all] : cases)
    for (const std::string numerics : {"", "integrator = \"step-doubling\"\n"}) {
      const auto with = [&](std::string text) {
        return text.replace(text.find("[time]"), 0, numerics);
      };
      write("in.toml", with(until(0.02, all)));
      must(into("whole", "run"));
      write("in.toml", with(until(0.01, first)));
      must(into("out", "run"));
      write("in.toml", with(until(0.02, all)));
      const Ended ended = sbeh(resumed("out"));
      EXPECT_EQ(ended.exit_code, 0);
      EXPECT_EQ(ended.err, "sbeh: out: its end was t = 0.01, it goes on to 0.02\n");
      EXPECT_EQ(contents("out"), contents("whole")) << all << numerics;
      must_end_as_the_whole();  // nothing is left to do
      for (const char* folder : {"whole", "out"}) fs::remove_all(path(folder));
    }
}

TEST_F(ResumeRun, that_goes_on_beyond_its_end_leaves_what_its_run_toml_leaves) {
  const std::string rows = "output = [0, 0.01]\n";
  struct Times {
    std::string first, all, said;
  };
  const std::string missed = "sbeh: out: has gone to t = 0.01 without ";
  const std::vector<Times> cases{
      // Its end was a time of neither.
      {"output = [0, 0.003]\nframes = [0]\n", "output = [0, 0.003, 0.02]\nframes = [0, 0.02]\n",
       ""},
      {"output = [0, 0.003]\nframes = [0]\n", "output = [0, 0.003]\nframes = [0]\n", ""},
      {rows + "frames = [0]\n", rows + "frames = [0, 0.015]\n", ""},
      // Asked for too late, or no more.
      {rows + "frames = [0, 0.01]\n",
       "output = [0, 0.005, 0.01]\nframes = [0, 0.002, 0.004, 0.01]\n",
       missed + "1 of the times that output asks for now, and 2 of frames\n"},
      {"output = [0, 0.005, 0.01]\nframes = [0, 0.005]\n", "output = [0, 0.02]\nframes = [0.02]\n",
       ""},
      {"", "", missed},
  };
  for (const auto& [first, all, said] : cases) {
    write("in.toml", until(0.01, first));
    must(into("out", "run"));
    const Contents before = contents("out");
    write("in.toml", until(0.02, all));
    const Ended ended = sbeh(resumed("out"));
    EXPECT_EQ(ended.exit_code, 0);
    EXPECT_EQ(ended.err.find(missed) != std::string::npos, !said.empty()) << ended.err;
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
    EXPECT_EQ(table("out/series.csv").numbers("time").back(), 0.02);
    // What was there is there.
    Contents after = contents("out");
    EXPECT_TRUE(after["series.csv"].starts_with(before.at("series.csv"))) << all;
    EXPECT_TRUE(after["frames.csv"].starts_with(before.at("frames.csv"))) << all;
    must(into("whole", "run", "out/run.toml"));
    EXPECT_EQ(contents("out"), contents("whole")) << all;
    must_end_as_the_whole();
    for (const char* folder : {"whole", "out"}) fs::remove_all(path(folder));
  }
}

TEST_F(ResumeRun, that_goes_on_beyond_its_end_may_be_killed_and_goes_on_again) {
  write("in.toml", until(0.02, "output = [0, 0.01]\nframes = [0, 0.01]\n"));
  must(into("out", "run"));
  write("in.toml", start + many_rows + many_frames + checkpoint_each_step);
  kill_when(resumed("out"), [&] { return lines("out/series.csv") > 20; });
  must(resumed("out"));
  must(into("whole", "run", "out/run.toml"));
  EXPECT_EQ(contents("out"), contents("whole"));
  EXPECT_EQ(table("out/series.csv").numbers("time").back(), 0.08);
  must_end_as_the_whole();
}

TEST_F(ResumeRun, is_not_lengthened_before_its_end) {
  write("in.toml", start + many_rows + many_frames);
  kill_when(into("out", "run"), [&] { return lines("out/frames.csv") > 4; });
  const Contents before = contents("out");
  for (const std::string& changed :
       {until(0.1, many_rows + many_frames), start + many_rows + "frames = [0.08]\n"}) {
    write("in.toml", changed);
    const Ended ended = sbeh(resumed("out"));
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_NE(
        ended.err.find("holds a run with other times (end, output or frames in [time]) that is at "
                       "t = 0.0"),
        std::string::npos)
        << ended.err;
    EXPECT_TRUE(
        ended.err.ends_with("and not at its end, 0.08; let it get there (sbeh run out/run.toml -o "
                            "out --resume), then lengthen it\n"))
        << ended.err;
    EXPECT_EQ(contents("out"), before);
  }
  must({"run", "out/run.toml", "-o", "out", "--resume", "--no-pictures"});
}

TEST_F(ResumeRun, that_came_to_rest_is_not_lengthened) {
  const std::string sphere =
      "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 1\ntriangles = 20\n"
      "[numerics]\nrest_speed = 1\n[time]\noutput = [0]\nframes = [0]\n";
  write("in.toml", sphere + "end = 100\n");
  must(into("out", "run"));
  const Contents before = contents("out");
  write("in.toml", sphere + "end = 200\n");
  const Ended ended = sbeh(resumed("out"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_TRUE(ended.err.starts_with("sbeh: out: at rest at t = ")) << ended.err;
  EXPECT_TRUE(ended.err.ends_with(", before its end: later times change nothing\n")) << ended.err;
  EXPECT_EQ(contents("out"), before);
}

// ---- full disks ---------------------------------------------------------------------------------

// A file that the next write of `file` goes to, in place of its own: there is never room in it.
void fill_disk_for(const fs::path& file) {
  fs::create_directories(file.parent_path());
  fs::create_symlink("/dev/full", file.string() + ".part");
}
const std::string advice =
    "; once that is mended, the same command goes on from the newest frame (sbeh run with "
    "--resume)\n";

TEST_F(ResumeRun, after_a_frame_had_no_room_finds_the_older_ones_intact) {
  input(start + many_rows + many_frames);
  fill_disk_for(path("out/frames/0005.vtu"));
  const Ended full = sbeh(into("out", "run"));
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(full.err,
            "sbeh: out/frames/0005.vtu: cannot be written: No space left on device" + advice);
  Contents frames = contents("whole/frames");
  for (int later = 5; later < 20; ++later)
    frames.erase((later < 10 ? "000" : "00") + std::to_string(later) + ".vtu");
  EXPECT_EQ(contents("out/frames"), frames);
  must_end_as_the_whole();
}

TEST_F(ResumeRun, after_the_history_had_no_room_goes_on_with_it) {
  input(start + "output = {from = 0.0001, to = 0.02, count = 200}\nframes = [0, 0.01]\n");
  Surroundings full = here();
  full.largest_file = 50000;  // more than a frame, less than the history
  for (const auto& arguments : {into("out", "run"), resumed("out")}) {
    const Ended ended = run(full, arguments);
    EXPECT_EQ(ended.exit_code, 2) << ended.signal;
    EXPECT_EQ(ended.err,
              "sbeh: out/series.csv: cannot be written any further: File too large" + advice);
    EXPECT_TRUE(read("whole/series.csv").starts_with(read("out/series.csv")));
    EXPECT_GT(lines("out/series.csv"), 20);
  }
  must_end_as_the_whole();
}

TEST_F(ResumeRun, is_not_needed_when_a_checkpoint_had_no_room) {
  input(start + many_rows + many_frames + checkpoint_each_step);
  fill_disk_for(path("out/checkpoint.vtu"));
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(ended.err,
            "sbeh: out/checkpoint.vtu: cannot be written: No space left on device; the run goes on "
            "without this checkpoint\n");
  EXPECT_EQ(contents("out"), contents("whole"));
}

TEST_F(ResumeRun, starts_a_run_that_had_no_room_at_all) {
  input(start + many_rows + many_frames);
  Surroundings full = here();
  full.largest_file = 10;
  const Ended ended = run(full, into("out", "run"));
  EXPECT_EQ(ended.exit_code, 2) << ended.signal;
  EXPECT_NE(ended.err, "");  // as much of it as the limit lets through
  must(into("out", "run"));
  EXPECT_EQ(contents("out"), contents("whole"));
}

}  // namespace
}  // namespace sbeh::tools::test
