// 3D runs in a folder of their own.
#pragma once

#include "tests/tools/workplace.h"

#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

namespace sbeh::tools::test {

inline const std::string ellipsoid =
    "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\ntriangles = 80\n";

class Run3d : public Workplace {
 protected:
  static std::vector<std::string> resumed(const std::string& results) {
    auto arguments = into(results, "run");
    arguments.emplace_back("--resume");
    return arguments;
  }
  /// Starts, and sends the signal when there are so many complete lines in frames.csv.
  void stop_with_frames(const std::string& results, int lines_of_frames, int signal) const {
    Program program(here(), into(results, "run"));
    ASSERT_TRUE(wait_until([&] {
      return lines(results + "/frames.csv") >= lines_of_frames || !program.is_running();
    }));
    ASSERT_TRUE(program.is_running()) << "ended before it could be stopped";
    program.send(signal);
    const Ended ended = program.wait();
    if (signal == SIGKILL) {
      EXPECT_EQ(ended.signal, SIGKILL);
    } else {
      EXPECT_EQ(ended.exit_code, 128 + signal) << ended.err;
      EXPECT_TRUE(ended.err.ends_with(
          "sbeh: interrupted; the same command with --resume goes on from here\n"));
      EXPECT_TRUE(std::filesystem::exists(path(results + "/checkpoint.vtu")));
    }
  }
};

}  // namespace sbeh::tools::test
