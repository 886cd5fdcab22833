// What a finished scan leaves: its columns, what holds between them, and points that have no state.
#include "tests/tools/workplace.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace sbeh::tools::test {
namespace {

namespace fs = std::filesystem;
using std::numbers::pi;
using Scan = Workplace;

const std::string columns =
    "model,reduced_volume,L,branch,status,energy,energy_distortion,energy_bending,"
    "energy_thermotropic,energy_area_difference,order_min,order_max,order_mean,order_std,order_"
    "variance,H_pole,H_rim,"
    "H_abs_max,radius_equator,thickness_pole,W2,area,volume,residual,steps,wall_seconds,"
    "stop_reason,class,negative_directions,self_contact,fold_side,fold_L,"
    "energy_error,W2_error,H_pole_error,fold_L_error,interfaces,fold_reduced_volume,"
    "fold_reduced_volume_error,negative_directions_3d,unstable_modes,rigid_"
    "residual,"
    "eigenvalue_m0,eigenvalue_m1,eigenvalue_m2,eigenvalue_m3,eigenvalue_m4,eigenvalue_m5,"
    "eigenvalue_m6,rate_m0,rate_m1,rate_m2,rate_m3,rate_m4,rate_m5,rate_m6";

// Around the fold of SBEH's oblate branch at V_r = 0.6, which lies at L = 0.0706.
const std::string across_the_fold =
    "[scan]\nreduced_volume = [0.6, 0.7, 1]\nL = [0.05, 0.08, 0.09]\n[numerics]\nelements = 24\n";

// The number after "L = " in a reason.
double L_of(const std::string& reason) {
  return std::atof(reason.substr(reason.find("L = ") + 4).c_str());
}

// Each its own mirror image: of either model, by either method.
TEST_F(Scan, of_shapes_that_are_symmetric_has_profiles_with_their_middle_at_0) {
  const std::string grid = "[scan]\nreduced_volume = [0.6, 0.8]\nL = [0.03, 0.06]\n";
  write("newton.toml", grid + "branches = [\"oblate\", \"prolate\"]\n[numerics]\nelements = 16\n");
  write("flow.toml", grid + "method = \"flow\"\n[numerics]\nelements = 16\n");
  for (const std::string method : {"newton", "flow"}) {
    must(into(method, "scan", method + ".toml"));
    int profiles = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path(method + "/points"))) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(".series.csv")) continue;
      const std::vector<double> z =
          table(std::string(method).append("/points/").append(name)).numbers("z");
      const auto [low, high] = std::ranges::minmax(z);
      EXPECT_NEAR(low + high, 0, 1e-15) << name;
      EXPECT_NEAR(z.front() + z.back(), 0, 1e-6) << name;  // the poles lie as far on either side
      ++profiles;
    }
    EXPECT_GE(profiles, 8) << method;
  }
}

// But for the time that each point took.
TEST_F(Scan, in_parts_is_the_same_to_the_bit) {
  write("newton.toml",
        "[scan]\nreduced_volume = [0.6, 0.65, 0.7, 0.8, 1]\nL = [0.03, 0.06, 0.08]\n"
        "branches = [\"oblate\", \"prolate\"]\n[numerics]\nelements = 16\n");
  write("flow.toml",
        "[scan]\nreduced_volume = [0.8, 0.9]\nL = [0.05]\nmethod = \"flow\"\n"
        "[numerics]\nelements = 16\n");
  for (const std::string method : {"newton", "flow"}) {
    const std::string file = method + ".toml", whole = method + "_whole", parts = method + "_parts";
    must(into(whole, "scan", file));
    for (const char* part : {"2/3", "3/3", "1/3"}) {
      std::vector<std::string> arguments = into(parts, "scan", file);
      arguments.insert(arguments.end(), {"--part", part});
      must(arguments);
    }
    EXPECT_FALSE(exists(path(parts + "/scan.csv")));
    const Ended together = sbeh(into(parts, "scan", file));
    EXPECT_EQ(together.exit_code, 0) << together.err;
    EXPECT_NE(together.out.find("; 0 computed in "), std::string::npos) << together.out;
    EXPECT_EQ(table(parts + "/scan.csv").without("wall_seconds"),
              table(whole + "/scan.csv").without("wall_seconds"));
    Contents a = contents(whole), b = contents(parts);
    std::erase_if(b, [](const auto& one) { return one.first.starts_with("parts/"); });
    a.erase("scan.csv");
    b.erase("scan.csv");
    EXPECT_TRUE(a == b) << method;
  }
  write("flow.toml", "[scan]\nreduced_volume = 0.8\nL = 0.05\n");
  fs::remove_all(path("flow_parts/points"));
  for (const char* file : {"run.toml", "scan.csv"}) fs::remove(path("flow_parts") / file);
  const Ended other = sbeh(into("flow_parts", "scan", "flow.toml"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("holds a part of a scan with other parameters: "), std::string::npos)
      << other.err;
  std::vector<std::string> arguments = into("out", "scan", "newton.toml");
  arguments.insert(arguments.end(), {"--part", "4/3"});
  must_refuse(arguments, "--part 4/3: must be such as 3/16, the third of sixteen");
}

TEST_F(Scan, leaves_a_row_with_every_column_for_every_point_in_the_order_of_the_grid) {
  write("in.toml", across_the_fold);
  must(into("out", "scan"));
  EXPECT_EQ(read("out/scan.csv").substr(0, columns.size() + 1), columns + "\n");
  const Table scan = table("out/scan.csv");
  std::vector<std::string> keys;
  for (std::size_t row = 0; row < scan.rows.size(); ++row) {
    keys.push_back(scan.text(row, "reduced_volume") + " " + scan.text(row, "L") + " "
                   + scan.text(row, "model") + " " + scan.text(row, "branch"));
    EXPECT_TRUE((std::set<std::string>{"stationary", "unresolved", "failed"})
                    .contains(scan.text(row, "status")));
    EXPECT_NE(scan.text(row, "stop_reason"), "");
  }
  EXPECT_EQ(keys.size(), 18u);
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST_F(Scan, has_rows_in_which_energies_and_geometry_agree) {
  write("in.toml", across_the_fold);
  must(into("out", "scan"));
  const Table scan = table("out/scan.csv");
  for (std::size_t row = 0; row < scan.rows.size(); ++row) {
    const auto at = [&](const char* column) { return scan.number(row, column); };
    const std::string point = testing::PrintToString(scan.rows[row]);
    const double energy = at("energy");
    EXPECT_NEAR(energy, at("energy_distortion") + at("energy_bending") + at("energy_thermotropic"),
                1e-12 * std::abs(energy))
        << point;
    EXPECT_NEAR(at("area"), 4 * pi, 1e-10) << point;
    // No cubic is a circle: the sphere of 24 elements has less volume than a sphere of its area.
    EXPECT_NEAR(at("volume"), at("reduced_volume") * 4 * pi / 3,
                at("reduced_volume") < 1 ? 1e-10 : 1e-9)
        << point;
    EXPECT_NEAR(at("order_variance"), std::pow(at("order_std"), 2), 1e-14) << point;
    EXPECT_LE(at("order_min"), at("order_mean") + 1e-12) << point;
    EXPECT_LE(at("order_mean"), at("order_max") + 1e-12) << point;
    if (scan.text(row, "model") == "SSH") {
      EXPECT_NEAR(at("order_max"), 2. / 3, 1e-12) << point;
    }
  }
}

TEST_F(Scan, reports_points_beyond_the_fold_as_unresolved_and_goes_on) {
  write("in.toml", across_the_fold);
  must(into("out", "scan"));
  const Table scan = table("out/scan.csv");
  for (const char* L : {"0.08", "0.09"}) {
    const std::size_t beyond = scan.find("SBEH", "0.6", L);
    const std::string reason = scan.text(beyond, "stop_reason");
    EXPECT_EQ(scan.text(beyond, "status"), "unresolved");
    EXPECT_NE(reason.find("fold"), std::string::npos) << reason;
    EXPECT_NEAR(L_of(reason), 0.0706, 5e-4) << reason;
  }
  for (std::size_t row = 0; row < scan.rows.size(); ++row)
    if (scan.text(row, "model") == "SSH" || scan.text(row, "reduced_volume") != "0.6") {
      EXPECT_EQ(scan.text(row, "status"), "stationary") << row;
    }
  EXPECT_EQ(scan.text(scan.find("SBEH", "0.6", "0.05"), "status"), "stationary");
}

TEST_F(Scan, by_the_flow_ends_beyond_the_fold_with_a_reason_and_goes_on) {
  write("in.toml",
        "[scan]\nreduced_volume = [0.6, 0.8]\nL = [0.08]\nmethod = \"flow\"\nend_time = 3\n"
        "[numerics]\nelements = 24\n");
  must(into("out", "scan"));
  const Table scan = table("out/scan.csv");
  const std::size_t beyond = scan.find("SBEH", "0.6", "0.08");
  EXPECT_NE(scan.text(beyond, "status"), "stationary");
  EXPECT_NE(scan.text(beyond, "stop_reason").find(" at t = "), std::string::npos);
  EXPECT_EQ(scan.rows.size(), 4u);
  for (const char* v : {"0.6", "0.8"})
    EXPECT_GT(table("out/points/SSH_oblate_v" + std::string(v) + "_L0.08.series.csv").rows.size(),
              9u);
}

TEST_F(Scan, by_the_flow_that_is_cut_short_by_its_end_time_is_unresolved) {
  write("in.toml",
        "[scan]\nreduced_volume = 0.8\nL = 0.05\nmodels = [\"SSH\"]\nmethod = \"flow\"\n"
        "end_time = 1e-4\n[numerics]\nelements = 16\n");
  must(into("out", "scan"));
  const Table scan = table("out/scan.csv");
  EXPECT_EQ(scan.text(0, "status"), "unresolved");
  EXPECT_EQ(scan.text(0, "stop_reason"), "end time reached at t = 0.0001");
}

TEST_F(Scan, does_not_depend_on_the_number_of_threads) {
  for (const std::string method : {"newton", "flow"}) {
    write("in.toml", "[scan]\nreduced_volume = [0.75, 0.8]\nL = [0.05, 0.06]\nmethod = \"" + method
                         + "\"\n[numerics]\nelements = 16\n");
    for (const std::string threads : {"1", "2"})
      must({"scan", "in.toml", "--no-pictures", "-o", method + threads, "--threads", threads});
    EXPECT_EQ(table(method + "1/scan.csv").without("wall_seconds"),
              table(method + "2/scan.csv").without("wall_seconds"));
    auto one = contents(method + "1"), two = contents(method + "2");
    one.erase("scan.csv"), two.erase("scan.csv");
    EXPECT_TRUE(one == two) << method;
  }
}

TEST_F(Scan, can_be_run_again_from_the_run_toml_it_leaves) {
  write("in.toml", across_the_fold);
  must(into("out", "scan"));
  must(into("again", "scan", "out/run.toml"));
  EXPECT_EQ(table("again/scan.csv").without("wall_seconds"),
            table("out/scan.csv").without("wall_seconds"));
  EXPECT_EQ(read("again/run.toml"), read("out/run.toml"));
}

TEST_F(Scan, that_is_finished_computes_nothing_when_it_is_run_again) {
  write("in.toml", across_the_fold);
  must(into("out", "scan"));
  const Contents before = contents("out");
  const Ended again = sbeh(into("out", "scan"));
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_NE(again.out.find(" 0 computed"), std::string::npos) << again.out;
  EXPECT_EQ(contents("out"), before);
}

}  // namespace
}  // namespace sbeh::tools::test
