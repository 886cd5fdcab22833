// Ctrl-C and SIGTERM in the middle of the work.
#include "tests/tools/workplace.h"

#include <algorithm>
#include <csignal>
#include <thread>

namespace sbeh::tools::test {
namespace {

class Interrupt : public Workplace {
 protected:
  /// Sends the signal when `begun` holds; checks that the work ends by it, long before it is done.
  Ended interrupt(const std::vector<std::string>& arguments, int signal,
                  const std::function<bool()>& begun) {
    Program program(here(), arguments);
    EXPECT_TRUE(wait_until([&] { return begun() || !program.is_running(); }));
    EXPECT_TRUE(program.is_running()) << "ended before it could be interrupted";
    program.send(signal);
    const Ended ended = program.wait();
    EXPECT_EQ(ended.exit_code, 128 + signal) << ended.err;
    return ended;
  }
};

const std::string map =
    "[scan]\nreduced_volume = {from = 0.6, to = 0.95, count = 40}\n"
    "L = {from = 0.005, to = 0.06, count = 20}\n[numerics]\nelements = 32\n";

// Steps so small that it would take minutes.
const std::string long_evolution =
    "model = \"SBEH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.7\n"
    "[time]\nend = 100\nstop_at_rest = false\noutput = {from = 0.0001, to = 100, count = 100000}\n"
    "[numerics]\nelements = 16\nlargest_step = 0.0001\n";

TEST_F(Interrupt, of_a_scan_keeps_the_finished_rows_and_says_how_to_go_on) {
  write("in.toml", map);
  for (const int signal : {SIGINT, SIGTERM}) {
    const int before = std::max(1, lines("out/scan.csv"));
    const Ended ended =
        interrupt(into("out", "scan"), signal, [&] { return lines("out/scan.csv") > before + 10; });
    EXPECT_TRUE(ended.err.ends_with("sbeh: interrupted; the same command goes on from here\n"))
        << ended.err;
    const Table scan = table("out/scan.csv");
    EXPECT_GT(int(scan.rows.size()), before + 9);
    for (std::size_t row = 0; row < scan.rows.size(); ++row)
      EXPECT_TRUE(
          exists(path("out/points/" + scan.text(row, "model") + "_oblate_v"
                      + scan.text(row, "reduced_volume") + "_L" + scan.text(row, "L") + ".csv")));
  }
}

TEST_F(Interrupt, of_a_scan_by_the_flow_does_not_wait_for_the_points_at_hand) {
  write("in.toml",
        "[scan]\nreduced_volume = [0.7, 0.8]\nL = [0.05, 0.06]\nmethod = \"flow\"\n"
        "[numerics]\nelements = 16\nlargest_step = 1e-5\nrest_speed = 1e-14\n");
  const Ended ended = interrupt(into("out", "scan"), SIGTERM, [&] {
    if (lines("out/scan.csv") == 0) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return true;
  });
  EXPECT_TRUE(ended.err.ends_with("sbeh: interrupted; the same command goes on from here\n"));
  EXPECT_EQ(lines("out/scan.csv"), 1);
  EXPECT_TRUE(contents("out/points").empty());
}

TEST_F(Interrupt, of_an_evolution_keeps_its_history_and_the_last_state) {
  write("in.toml", long_evolution);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::string out = "out" + std::to_string(signal);
    const Ended ended =
        interrupt(into(out, "relax"), signal, [&] { return lines(out + "/series.csv") > 20; });
    EXPECT_NE(ended.out.find("interrupted at t = "), std::string::npos) << ended.out;
    EXPECT_TRUE(ended.err.ends_with("choose another folder with -o\n")) << ended.err;
    EXPECT_TRUE(ended.err.starts_with("sbeh: interrupted; what is in " + out)) << ended.err;
    const std::vector<double> times = table(out + "/series.csv").numbers("time");
    EXPECT_GT(times.size(), 19u);
    EXPECT_EQ(table(out + "/profiles.csv").numbers("time").back(), times.back());
  }
}

}  // namespace
}  // namespace sbeh::tools::test
