// Physical units as their user meets them: `sbeh units`, pictures, reports, inputs that are gone on with.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

namespace sbeh::tools::test {
namespace {

using PhysicalUnits = Workplace;

const std::string vesicle =
    "[units]\nradius_um = 10\nbending_rigidity_kT = 20\nsurface_viscosity = 5e-10\n";
const std::string relaxation =
    "model = \"SSH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.9\n[material]\nL = 0.05\n"
    "[numerics]\nelements = 8\n";
constexpr double kT = 1.380649e-23 * 300, E = 20 / 0.1, T = 5e-10 * 1e-10 / (E * kT);

TEST_F(PhysicalUnits, are_told_of_an_input_and_of_results_and_written_into_tables) {
  write("in.toml", relaxation + "[time]\nend = \"20 ms\"\nstop_at_rest = false\n" + vesicle);
  const Ended told = sbeh({"units", "in.toml"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(told.out.starts_with("length: R = 10 µm")) << told.out;
  EXPECT_NE(told.out.find("= 200 k_BT with κ = "), std::string::npos) << told.out;
  must(into("out", "relax"));
  EXPECT_EQ(sbeh({"units", "out"}).out, told.out);
  must({"units", "out", "-o", "physical"});
  const Table numbers = table("out/series.csv"), converted = table("physical/series.csv");
  ASSERT_EQ(numbers.rows.size(), converted.rows.size());
  const std::size_t last = numbers.rows.size() - 1;
  EXPECT_NEAR(converted.number(last, "time_s"), 0.02, 1e-14);
  EXPECT_NEAR(numbers.number(last, "time") * T, 0.02, 1e-14);
  EXPECT_NEAR(converted.number(last, "energy_kT"), E * numbers.number(last, "energy"), 1e-9);
  EXPECT_EQ(converted.text(last, "reduced_volume"), numbers.text(last, "reduced_volume"));
  EXPECT_NE(read("out/run.toml").find("\n## H is the trace of the shape operator"),
            std::string::npos);
  must_refuse({"units", "out", "-o", "physical"},
              "physical/units.toml: is there already: choose another folder, or give "
              "--overwrite");
  must({"units", "out", "-o", "physical", "--overwrite"});
}

TEST_F(PhysicalUnits, of_results_without_them_come_from_a_file) {
  write("in.toml", relaxation + "[time]\nend = 0.01\n");
  write("units.toml", vesicle);
  must(into("out", "relax"));
  must_refuse({"units", "out"},
              "out: has no [units] in its run.toml: name a file that has "
              "them with --units-from\n");
  must_refuse({"units", "out", "--units-from", "in.toml"}, "in.toml: has no table [units]\n");
  must_refuse({"units", "in.toml", "-o", "x"},
              "in.toml: is an input, which has no tables to be written with -o\n");
  must_refuse({"report", "out", "--units"}, "out: has no [units] in its run.toml");
  must({"units", "out", "--units-from", "units.toml", "-o", "physical"});
  EXPECT_TRUE(exists(path("physical/series.csv")));
}

// They change no number, so that an interrupted study is gone on with under others.
TEST_F(PhysicalUnits, may_change_in_a_scan_that_is_gone_on_with) {
  const std::string grid =
      "[scan]\nreduced_volume = 0.9\nL = 0.05\nmodels = [\"SSH\"]\nmodes = 0\n";
  write("in.toml", grid);
  must(into("out", "scan"));
  const std::string table_before = read("out/scan.csv");
  write("in.toml", grid + vesicle);
  must(into("out", "scan"));
  EXPECT_EQ(read("out/scan.csv"), table_before);
  EXPECT_NE(read("out/run.toml").find("radius_um = 10\n"), std::string::npos);
  write("in.toml", grid + vesicle + "[material]\nspontaneous_curvature = \"-0.1 1/um\"\n");
  must_refuse(into("out", "scan"),
              "out: holds a scan with other parameters: "
              "material.spontaneous_curvature: 0 there, -1 here");
}

TEST_F(PhysicalUnits, of_a_report_are_those_of_all_its_numbers) {
  write("in.toml", relaxation + "[time]\nend = 0.1\n" + vesicle);
  must(into("out", "relax"));
  must({"report", "out", "--units", "--no-pictures"});
  const std::string page = read("out/report.html");
  const Table series = table("out/series.csv");
  const double end = E * series.number(series.rows.size() - 1, "energy");
  EXPECT_NE(page.find(fmt::format("{:.9g}", end)), std::string::npos) << end;
  for (const char* text : {"energy_kT", "t (s)", "length: R = 10 µm", "F/(8πκ) = 1", "lambda_Pa"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace sbeh::tools::test
