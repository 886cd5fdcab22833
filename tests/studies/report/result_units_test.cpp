// Tables in physical units: every number against the conversion written out.
#include "studies/report/result_units.h"

#include "studies/io/output.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;

constexpr double kT = 1.380649e-23 * 300;
const std::string vesicle =
    "[units]\nradius_um = 10\nbending_rigidity_kT = 20\nsurface_viscosity = 5e-10\n";

class ResultsInUnits : public testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) const {
    make_folder((path() / name).parent_path());
    write_file(path() / name, text);
    return path() / name;
  }
  fs::path path() const { return folder_.path(); }
  void write_scan(const std::string& rows, const std::string& units = vesicle) const {
    write("run.toml",
          "[scan]\nreduced_volume = 0.6\nL = [0.05, 0.09]\n[material]\n"
          "residual_stiffness = 0.01\n"
              + units);
    write("scan.csv",
          "model,reduced_volume,L,status,energy,H_pole,fold_side,fold_L,rate_m2\n" + rows);
  }

 private:
  sbeh::test::TemporaryFolder folder_;
};

// κ and R are the same in all rows. At the fold the state, and so its energy, is that of the fold's L.
TEST_F(ResultsInUnits, of_a_scan_have_units_of_their_own_in_each_row) {
  write_scan(
      "SBEH,0.6,0.05,stationary,-9,2,before,0.07,-3\nSBEH,0.6,0.09,unresolved,-8,4,at,0.07,\n"
      "SSH,0.6,0.09,failed,nan,nan,,,\n");
  const ResultUnits units(path());
  const CsvTable table = units.converted(read_csv(path() / "scan.csv"), "scan.csv");
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"model", "reduced_volume", "L", "status", "energy_kT",
                                      "H_pole_per_um", "fold_side", "fold_L", "rate_m2_per_s",
                                      "unit_energy_kT", "unit_time_s"}));
  const double first = 20 / (0.1 + 0.01), second = 20 / (0.14 + 0.01), third = 20 / (0.18 + 0.01);
  EXPECT_NEAR(table.number(0, "energy_kT"), -9 * first, 1e-10);
  EXPECT_NEAR(table.number(1, "energy_kT"), -8 * second, 1e-10);
  EXPECT_NEAR(table.number(0, "H_pole_per_um"), 0.2, 1e-15);
  const double T = 5e-10 * 1e-10 / (first * kT);
  EXPECT_NEAR(table.number(0, "rate_m2_per_s") * T, -3, 1e-13);
  EXPECT_NEAR(table.number(0, "unit_time_s"), T, 1e-14 * T);
  EXPECT_NEAR(table.number(2, "unit_energy_kT"), third, 1e-12);
  EXPECT_EQ(table.text(2, "energy_kT"), "nan");
  EXPECT_EQ(table.text(1, "rate_m2_per_s"), "");
  EXPECT_EQ(table.text(0, "L"), "0.05");
}

TEST_F(ResultsInUnits, of_a_point_have_those_of_the_L_in_its_name) {
  write_scan("");
  const CsvTable series{{"time", "energy"}, {{"1", "2"}}}, profile{{"r", "z"}, {{"1", "2"}}};
  const ResultUnits units(path());
  const fs::path name = "points/SBEH_oblate_v0.7_L0.05.series.csv";
  EXPECT_NEAR(units.converted(series, name).number(0, "energy_kT"), 2 * 20 / 0.11, 1e-11);
  EXPECT_NEAR(units.converted(profile, name).number(0, "r_um"), 10, 1e-14);
  EXPECT_NEAR(units.converted(profile, "beyond_fold/rim.csv").number(0, "z_um"), 20, 1e-14);
  EXPECT_THROW(units.converted(series, "points/unknown.csv"), OutputError);
}

// The mean square of a contour is one of lengths, that of a mode's amplitude a number.
TEST_F(ResultsInUnits, may_mean_another_quantity_by_the_same_name_in_another_table) {
  write_scan("");
  const ResultUnits units(path());
  const CsvTable table{{"m", "mean_square"}, {{"2", "3"}}};
  EXPECT_NEAR(units.converted(table, "contour.csv").number(0, "mean_square_um2"), 300, 1e-12);
  EXPECT_EQ(units.converted(table, "fluctuations.csv").number(0, "mean_square"), 3);
}

TEST_F(ResultsInUnits, are_written_under_their_names_with_what_they_were_converted_by) {
  write_scan("SSH,0.6,0.05,stationary,-9,2,,,-3\n");
  write("points/SSH_oblate_v0.6_L0.05.csv", "arc_length,r,z,order,mean_curvature\n0,0,1,0.6,-2\n");
  write("own.csv", "cheese,wine\n1,2\n");
  const ResultUnits units(path());
  const fs::path into = path() / "physical";
  const ConvertedTables written = write_converted(path(), units, into, false, "1.2.3");
  EXPECT_EQ(written.count, 2);
  ASSERT_EQ(written.left.size(), 1u);
  EXPECT_EQ(written.left.front(),
            "own.csv: is no table of results: its column 'cheese' is not known");
  EXPECT_EQ(read_file(into / "points/SSH_oblate_v0.6_L0.05.csv"),
            "arc_length_um,r_um,z_um,order,mean_curvature_per_um\n0,0,10,0.6,-0.2\n");
  const std::string note = read_file(into / "units.toml");
  EXPECT_NE(note.find("bending_rigidity_kT = 20\n"), std::string::npos) << note;
  EXPECT_NE(note.find("# length: R = 10 µm"), std::string::npos) << note;
  EXPECT_NE(note.find("# H is the trace"), std::string::npos) << note;
  EXPECT_THROW(write_converted(path(), units, into, false, "1.2.3"), OutputError);
  EXPECT_EQ(write_converted(path(), units, into, true, "1.2.3").count, 2);  // not those in `into`
  const std::string scan = read_file(path() / "scan.csv");
  for (const fs::path& other : {path(), path() / "points"})
    EXPECT_THROW(write_converted(path(), units, other, true, "1.2.3"), OutputError);
  EXPECT_EQ(read_file(path() / "scan.csv"), scan);
}

TEST_F(ResultsInUnits, tell_of_fluctuations_at_another_temperature) {
  const std::string begin = "[modes]\nreduced_volume = 0.7\nL = 0.05\nfluctuations = ";
  const fs::path file = write("modes.toml", begin + "1e-3\n" + vesicle);
  const auto other = [&] {
    const DescribedUnits described = described_units(file);
    return ResultUnits(described, *described.units).other_temperature();
  };
  EXPECT_TRUE(
      other().starts_with("fluctuations are those of a thermal energy of 0.2 k_BT at 300 K"))
      << other();
  write("modes.toml", begin + "\"1 kT\"\n" + vesicle);
  EXPECT_EQ(other(), "");
}

TEST_F(ResultsInUnits, may_have_those_of_another_file) {
  write_scan("", "");
  try {
    const ResultUnits none(path());
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), path().string()
                                + ": has no [units] in its run.toml: name a file that has them "
                                  "with --units-from");
  }
  const fs::path other =
      write("other.toml", "[units]\nradius_um = 2\nbending_rigidity_J = 1e-19\n");
  const ResultUnits units(path(), other);
  EXPECT_EQ(units.units().radius_um, 2);
  EXPECT_NEAR(units.scales(0.045).factor(dimension::energy), 1e-18, 1e-31);
}

}  // namespace
}  // namespace sbeh::studies
