// A long 3D run needs no more memory than a short one. tests/bench/memory goes on to 10 000 steps.
#include "tests/tools/workplace.h"

#include <algorithm>

namespace sbeh::tools::test {
namespace {

using Memory = Workplace;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool keeps_what_is_freed = true;
#else
constexpr bool keeps_what_is_freed = false;
#endif

// A row every ten steps, a frame every hundred, checkpoints every 30 ms.
std::string equal_steps(int steps, const std::string& factorisation) {
  const std::string end = std::to_string(steps) + "e-6";
  return "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.97\ntriangles = "
         "20\n"
         "[numerics]\nfirst_step = 1e-6\nlargest_step = 1e-6\ntolerance = 0.1\nfactorisation = \""
       + factorisation + "\"\n[time]\nstop_at_rest = false\ncheckpoint_minutes = 0.0005\nend = "
       + end + "\noutput = {from = 1e-5, to = " + end + ", count = " + std::to_string(steps / 10)
       + "}\nframes = {from = 1e-4, to = " + end + ", count = " + std::to_string(steps / 100)
       + "}\n";
}

TEST_F(Memory, of_a_run_does_not_grow) {
  if (keeps_what_is_freed) GTEST_SKIP() << "the address sanitizer keeps what is freed";
  constexpr int rows = 80, settled = 20;  // of the history, for 800 and 200 steps
  for (const std::string factorisation : {"lagged", "every-step"}) {
    write("in.toml", equal_steps(10 * rows, factorisation));
    Program program(here(), into(factorisation, "run"));
    const std::string series = factorisation + "/series.csv";
    const auto kilobytes_at = [&](int row) {
      EXPECT_TRUE(wait_until([&] { return lines(series) > row || !program.is_running(); }));
      return program.resident_kilobytes();
    };
    const long before = kilobytes_at(settled), between = kilobytes_at((settled + rows) / 2),
               after = kilobytes_at(rows - 1);
    EXPECT_GT(before, 0);
    EXPECT_GT(after, 0);
    // What is lost in each step is lost in both halves; the allocator's own growth comes once.
    EXPECT_LT(std::min(between - before, after - between), 250)
        << "kB, after " << before;  // a page or two for each frame's name
    EXPECT_EQ(program.wait().exit_code, 0);
    std::printf("%s: %ld kB, %+ld kB, %+ld kB\n", factorisation.c_str(), before, between - before,
                after - between);
  }
}

}  // namespace
}  // namespace sbeh::tools::test
