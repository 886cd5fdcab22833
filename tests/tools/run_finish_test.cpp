// 3D runs that end by Newton's method: finish = "newton" in [time].
#include "tests/tools/run_fixture.h"

namespace sbeh::tools::test {
namespace {

class RunFinish : public Run3d {
 protected:
  // A prolate of SSH on its way to rest.
  static std::string prolate(const std::string& time) {
    return "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.9\nkind = "
           "\"prolate\"\ntriangles = 180\n[numerics]\ntolerance = 1e-3\n[time]\nend = 100\noutput "
           "= "
           "[0.1, 1]\nframes = [0, 0.1]\n"
         + time;
  }
};

TEST_F(RunFinish, by_newton_is_at_rest_earlier_and_says_what_it_has_found) {
  write("in.toml", prolate(""));
  must(into("flow", "run"));
  write("in.toml", prolate("finish = \"newton\"\n"));
  const Ended ended = sbeh(into("newton", "run"));
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_NE(ended.out.find("near rest at t = "), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("at rest by Newton's method: energy "), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find(", a minimum; in newton/rest/states.csv"), std::string::npos)
      << ended.out;

  const Table flow = table("flow/series.csv"), newton = table("newton/series.csv"),
              rest = table("newton/rest/states.csv");
  EXPECT_LT(newton.number(newton.rows.size() - 1, "time"),
            flow.number(flow.rows.size() - 1, "time") / 2);
  ASSERT_EQ(rest.rows.size(), 1u);
  EXPECT_EQ(rest.text(0, "status"), "stationary");
  EXPECT_EQ(rest.number(0, "negative_directions"), 0);
  EXPECT_NEAR(rest.number(0, "energy"), flow.number(flow.rows.size() - 1, "energy"),
              rest.number(0, "energy_error"));
  EXPECT_LT(rest.number(0, "energy"), newton.number(newton.rows.size() - 1, "energy"));
}

TEST_F(RunFinish, near_a_saddle_is_left_to_the_flow) {
  write("in.toml",
        "model = \"SSH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\ntriangles = "
        "180\n[numerics]\ntolerance = 1e-3\nrest_speed = 1e-4\n[time]\nend = 30\nfinish = "
        "\"newton\"\n");
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_TRUE(ended.out.starts_with("at rest at t = ")) << ended.out << ended.err;
  EXPECT_NE(ended.out.find(", a saddle: it falls in 2 directions; "), std::string::npos)
      << ended.out;
}

TEST_F(RunFinish, that_was_killed_is_resumed_to_the_same_bits) {
  write("in.toml", prolate("finish = \"newton\"\n"));
  must(into("whole", "run"));
  stop_with_frames("out", 3, SIGKILL);
  must(resumed("out"));
  EXPECT_EQ(contents("out"), contents("whole"));
  must(resumed("out"));
  EXPECT_EQ(contents("out"), contents("whole"));
  std::filesystem::remove_all(path("out/rest"));
  must(resumed("out"));
  EXPECT_EQ(contents("out"), contents("whole"));
}

TEST_F(RunFinish, that_was_stopped_while_newtons_method_was_at_work_is_resumed_to_the_same_bits) {
  write("in.toml", prolate("finish = \"newton\"\n"));
  must(into("whole", "run"));
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const std::string out = "out" + std::to_string(signal);
    Program program(here(), into(out, "run"));
    ASSERT_TRUE(
        wait_until([&] { return exists(path(out + "/rest/run.toml")) || !program.is_running(); }));
    program.send(signal);
    const Ended ended = program.wait();
    EXPECT_FALSE(exists(path(out + "/rest/states.csv")) && lines(out + "/rest/states.csv") > 1)
        << "it was over already";
    if (signal == SIGKILL) {
      EXPECT_EQ(ended.signal, SIGKILL);
    } else {
      EXPECT_EQ(ended.exit_code, 128 + signal) << ended.err;
      EXPECT_TRUE(ended.err.ends_with(
          "sbeh: interrupted; the same command with --resume goes on from here\n"))
          << ended.err;
    }
    must(resumed(out));
    EXPECT_EQ(contents(out), contents("whole")) << signal;
  }
}

TEST_F(RunFinish, of_a_sphere_is_that_of_its_flow) {
  write("in.toml",
        "model = \"SBEH\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 1\ntriangles = 20\n"
        "order = 0.6\n[time]\nend = 100\noutput = [1]\nframes = [0]\nfinish = \"newton\"\n");
  const Ended ended = sbeh(into("out", "run"));
  EXPECT_TRUE(ended.out.starts_with("at rest at t = ")) << ended.out << ended.err;
  EXPECT_FALSE(exists(path("out/rest")));
}

TEST_F(RunFinish, belongs_to_what_newtons_method_knows) {
  const auto refusal = [&](const std::string& text) {
    write("in.toml", text);
    const Ended ended = sbeh({"check", "in.toml"});
    EXPECT_EQ(ended.exit_code, 2);
    return ended.err;
  };
  const std::string start = "[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n";
  const std::string time = "[time]\nend = 1\nfinish = \"newton\"\n";
  EXPECT_EQ(refusal("model = \"Helfrich-local\"\n" + start + time),
            "sbeh: in.toml:7: [time] finish = \"newton\": belongs to SBEH and SSH, not to "
            "Helfrich-local\n");
  EXPECT_EQ(refusal("model = \"SBEH\"\n" + start + time + "[material]\nL1 = 0\nL2 = 0.1\nL3 = 0\n"),
            "sbeh: in.toml:7: [time] finish = \"newton\": needs L1 > 0\n");
  EXPECT_EQ(refusal("model = \"SBEH\"\n" + start + time + "stop_at_rest = false\n"),
            "sbeh: in.toml:7: [time] finish = \"newton\": belongs to runs that end at rest: "
            "stop_at_rest = true\n");
}

// Of the other integrator nothing but the moment is remembered.
TEST_F(RunFinish, of_variational_steps_is_resumed_to_the_same_bits) {
  write("in.toml", ellipsoid
                     + "[numerics]\nintegrator = \"variational\"\ntolerance = 0.01\n[time]\nend = "
                       "0.1\noutput = [0.1]\nframes = [0, 0.02, 0.1]\n");
  must(into("whole", "run"));
  stop_with_frames("out", 3, SIGTERM);
  must(resumed("out"));
  EXPECT_EQ(contents("out"), contents("whole"));
}

TEST_F(RunFinish, variational_steps_belong_to_a_local_area) {
  write("in.toml",
        "model = \"Helfrich-global\"\n[surface]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n"
        "[numerics]\nintegrator = \"variational\"\n[time]\nend = 1\n");
  EXPECT_EQ(
      sbeh({"check", "in.toml"}).err,
      "sbeh: in.toml:6: [numerics] integrator = \"variational\": belongs to models whose area "
      "is kept at each point\n");
}

}  // namespace
}  // namespace sbeh::tools::test
