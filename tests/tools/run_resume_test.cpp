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
  for (const int milliseconds : {5, 10, 20, 30, 40, 55, 70, 90, 120, 160, 210, 270, 340, 420}) {
    Program program(here(), resumed("out"));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    program.send(SIGKILL);
    const Ended ended = program.wait();
    EXPECT_TRUE(ended.signal == SIGKILL || ended.exit_code == 0) << ended.err;
    EXPECT_EQ(ended.err, "");
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
  must_end_as_the_whole();
}

}  // namespace
}  // namespace sbeh::tools::test
