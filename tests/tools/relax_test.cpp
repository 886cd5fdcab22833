// One evolution: the columns and times of its history, its profiles, and where it starts from.
#include "tests/tools/workplace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace sbeh::tools::test {
namespace {

using Relax = Workplace;

const std::string columns =
    "time,time_step,energy,energy_distortion,energy_bending,energy_thermotropic,energy_area_"
    "difference,"
    "dissipation_friction,dissipation_order,dissipation_viscous,energy_balance,area,volume,"
    "reduced_volume,W2,order_min,order_mean,order_max,order_variance,order_std,domains,domain_area,"
    "domain_boundary,H_abs_max,"
    "speed_max,lambda,mesh_quality,asymmetry,rejected_steps";

const std::string ellipsoid =
    "model = \"SBEH\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.8\n"
    "[numerics]\nelements = 24\n";

const std::string small_scan =
    "[scan]\nreduced_volume = [0.8]\nL = [0.05]\n[numerics]\nelements = 64\n";
std::string from_the_scan(const std::string& model, const std::string& L) {
  return "model = \"" + model + "\"\n[time]\nend = 0.2\noutput = [0, 0.1, 0.2]\n"
       + "stop_at_rest = false\n[start]\nshape = \"scan\"\nfolder = \"scan\"\nmodel = \"SBEH\"\n"
       + "reduced_volume = 0.8\nL = " + L + "\n";
}

TEST_F(Relax, may_leave_a_row_for_every_step) {
  write("in.toml", ellipsoid + "[time]\nend = 0.01\noutput = 0.003\nevery_step = true\n");
  must(into("out", "relax"));
  const std::vector<double> times = table("out/series.csv").numbers("time");
  const std::vector<double> steps = table("out/series.csv").numbers("time_step");
  ASSERT_GT(times.size(), 10u);
  EXPECT_EQ(std::count(times.begin(), times.end(), 0.003), 1);
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times.back(), 0.01);
  for (std::size_t row = 1; row < times.size(); ++row)
    EXPECT_NEAR(times[row] - times[row - 1], steps[row], 1e-15);
}

TEST_F(Relax, leaves_a_history_with_every_column_at_exactly_the_times_asked_for) {
  write("in.toml", ellipsoid
                       + "[time]\nend = 0.01\noutput = [0, 1e-7, 0.001, 0.0033, 0.01]\n"
                         "profiles = [1e-5, 0.0017, 0.01]\n");
  must(into("out", "relax"));
  EXPECT_EQ(read("out/series.csv").substr(0, columns.size() + 1), columns + "\n");
  const Table series = table("out/series.csv");
  EXPECT_EQ(series.numbers("time"), (std::vector{0., 1e-7, 0.001, 0.0033, 0.01}));
  const Table profiles = table("out/profiles.csv");
  EXPECT_EQ(profiles.numbers("time"), (std::vector{1e-5, 0.0017, 0.01}));
  for (std::size_t row = 0; row < profiles.rows.size(); ++row) {
    const Table profile = table("out/" + profiles.text(row, "file"));
    EXPECT_EQ(profile.columns,
              (std::vector<std::string>{"arc_length", "r", "z", "order", "mean_curvature"}));
    EXPECT_EQ(profile.rows.size(), 3u * 24 + 1);
  }
  EXPECT_EQ(series.numbers("time_step").front(), 0);
  for (std::size_t row = 0; row < series.rows.size(); ++row) {
    const auto at = [&](const char* column) { return series.number(row, column); };
    EXPECT_NEAR(at("energy"),
                at("energy_distortion") + at("energy_bending") + at("energy_thermotropic"),
                1e-12 * std::abs(at("energy")));
    EXPECT_NEAR(at("reduced_volume"), 0.8, 1e-10);
    EXPECT_NEAR(at("order_variance"), std::pow(at("order_std"), 2), 1e-14);
    if (row > 0) {
      EXPECT_LT(at("energy"), series.number(row - 1, "energy"));
    }
  }
}

TEST_F(Relax, ends_its_history_with_the_last_state_even_if_nobody_asked_for_that_time) {
  write("in.toml", ellipsoid + "[time]\nend = 0.001\noutput = [0.0005]\nprofiles = [0]\n");
  must(into("out", "relax"));
  EXPECT_EQ(table("out/series.csv").numbers("time"), (std::vector{0.0005, 0.001}));
  EXPECT_EQ(table("out/profiles.csv").numbers("time"), (std::vector{0., 0.001}));
}

TEST_F(Relax, from_a_row_of_a_scan_stays_at_rest_with_that_rows_L) {
  write("scan.toml", small_scan);
  write("in.toml", from_the_scan("SBEH", "0.05"));
  must(into("scan", "scan", "scan.toml"));
  must(into("out", "relax"));
  const Table scan = table("scan/scan.csv");
  const double energy = scan.number(scan.find("SBEH", "0.8", "0.05"), "energy");
  const Table series = table("out/series.csv");
  EXPECT_EQ(series.numbers("time"), (std::vector{0., 0.1, 0.2}));
  for (const double value : series.numbers("energy")) EXPECT_NEAR(value, energy, 1e-8);
}

TEST_F(Relax, from_a_row_of_a_scan_moves_with_another_L_or_model_and_says_so) {
  write("scan.toml", small_scan);
  must(into("scan", "scan", "scan.toml"));
  write("L.toml", from_the_scan("SBEH", "0.05") + "[material]\nL = 0.06\n");
  write("model.toml", from_the_scan("SSH", "0.05"));
  const std::map<std::string, std::string> changes{
      {"L", "material.L1: 0.05 there, 0.06 here"},
      {"model", "model: \"SBEH\" there, \"SSH\" here"}};
  for (const auto& [name, change] : changes) {
    const Ended ended = sbeh(into(name, "relax", name + ".toml"));
    EXPECT_EQ(ended.exit_code, 0);
    const std::string remark =
        "scan, SBEH oblate, V_r = 0.8, L = 0.05: " + change + "; the energy of this start is ";
    EXPECT_TRUE(ended.err.starts_with("sbeh: " + remark)) << ended.err;
    EXPECT_NE(read(name + "/run.toml").find("\n# " + remark), std::string::npos);
    EXPECT_NE(sbeh({"check", name + ".toml"}).out.find("\n# " + remark), std::string::npos);
    const std::vector<double> energy = table(name + "/series.csv").numbers("energy");
    EXPECT_LT(energy.back(), energy.front() - 1e-6) << name;
    // What it was, and what it is.
    const std::string told = ended.err.substr(5 + remark.size() + 1);
    EXPECT_NEAR(std::stod(told), table("scan/scan.csv").number(0, "energy"), 1e-8);
    EXPECT_NEAR(std::stod(told.substr(told.find("computed with, ") + 15)), energy.front(), 1e-8);
  }
  for (const double order : table("model/series.csv").numbers("order_min"))
    EXPECT_NEAR(order, 2. / 3, 1e-12);
}

// Each of them once was left behind without a word.
TEST_F(Relax, from_a_row_of_a_scan_goes_on_with_its_material) {
  const std::vector<std::string> materials{"spontaneous_curvature = -2.7",
                                           "residual_stiffness = 0.01",
                                           "order_viscosity = -3",
                                           "potential = [0, 0, -9, 0, 10]",
                                           "friction_normal = 0.7",
                                           "viscosity = 0.25",
                                           "immobility = 3"};
  for (const std::string& material : materials) {
    write("scan.toml",
          "[scan]\nreduced_volume = [0.9]\nL = [0.05]\nmodels = [\"SSH\"]\n[material]\n" + material
              + "\n[numerics]\nelements = 32\n");
    must(into("scan", "scan", "scan.toml"));
    write("in.toml",
          "time.end = 0.001\n[start]\nshape = \"scan\"\nfolder = \"scan\"\nmodel = \"SSH\"\n"
          "reduced_volume = 0.9\nL = 0.05\n");
    const Ended ended = sbeh(into("out", "relax"));
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    EXPECT_EQ(ended.err, "") << material;
    EXPECT_NE(read("out/run.toml").find("\n" + material + "\n"), std::string::npos);
    EXPECT_NEAR(table("out/series.csv").number(0, "energy"),
                table("scan/scan.csv").number(0, "energy"), 1e-9);
    std::filesystem::remove_all(path("scan"));
    std::filesystem::remove_all(path("out"));
  }
}

TEST_F(Relax, from_a_row_that_is_not_stationary_or_not_there_is_refused) {
  write("scan.toml", small_scan);
  write("in.toml", from_the_scan("SBEH", "0.07"));
  must_refuse(into("out", "relax"),
              "scan: is not there: neither from the folder of the input nor from ");
  must(into("scan", "scan", "scan.toml"));
  must_refuse(into("out", "relax"),
              "scan/scan.csv: has no row SBEH oblate, V_r = 0.8, L = 0.07; the nearest that is "
              "stationary is SBEH oblate, V_r = 0.8, L = 0.05\n");
  write("in.toml", from_the_scan("SBEH", "0.05"));
  write("scan/points/SBEH_oblate_v0.8_L0.05.csv", "r,z\n");
  must_refuse(into("out", "relax"),
              "scan/points/SBEH_oblate_v0.8_L0.05.csv: is no profile of this program");
  EXPECT_FALSE(exists(path("out")));
}

TEST_F(Relax, from_a_row_beyond_the_fold_is_refused_with_the_row_that_can_be_taken) {
  write("scan.toml",
        "[scan]\nreduced_volume = [0.6]\nL = [0.05, 0.06, 0.08]\nmodels = [\"SBEH\"]\n"
        "[numerics]\nelements = 24\n");
  must(into("scan", "scan", "scan.toml"));
  std::string row = from_the_scan("SBEH", "0.08");
  row.replace(row.find("= 0.8"), 5, "= 0.6");
  write("in.toml", row);
  const std::string start =
      "scan/scan.csv: its row SBEH oblate, V_r = 0.6, L = 0.08 is unresolved, not stationary, and "
      "so no "
      "start (the smooth oblate branch ends in a fold at ";
  for (const auto& arguments : {into("out", "relax"), {"check", "in.toml"}})
    must_refuse(arguments, start);
  const std::string advice =
      "that with L = 0.06 is: start from it, and give L = 0.08 in [material] to go on with that\n";
  const std::string said = sbeh(into("out", "relax")).err;
  EXPECT_TRUE(said.ends_with(advice)) << said;
  EXPECT_FALSE(exists(path("out")));
  const std::string profile = "scan/points/SBEH_oblate_v0.6_L0.08.csv";
  const Ended mesh = sbeh({"mesh", "revolve", profile, "--triangles", "320", "--report"});
  EXPECT_TRUE(mesh.err.starts_with("sbeh: " + profile
                                   + ": the row of this profile is unresolved, "
                                     "not stationary: the smooth oblate branch ends in a fold at "))
      << mesh.err;
  row.replace(row.find("0.08"), 4, "0.06");
  write("in.toml", row + "[material]\nL = 0.08\n");
  must({"check", "in.toml"});
}

TEST_F(Relax, ends_where_the_surface_passes_through_itself_and_says_so) {
  const auto oblate = [](const std::string& model, const std::string& v) {
    return "model = \"" + model + "\"\n[start]\nshape = \"ellipsoid\"\nreduced_volume = " + v
         + "\n[numerics]\nelements = 24\ntolerance = 1e-4\nlargest_step = 1\n"
           "[time]\nend = 100\noutput = [0, 1, 100]\nprofiles = [0, 100]\n";
  };
  for (const std::string model : {"SSH", "SBEH", "Helfrich-local"})
    for (const std::string v : {"0.45", "0.42", "0.4"}) {
      const std::string out = model + v;
      write("in.toml", oblate(model, v));
      const Ended ended = sbeh(into(out, "relax"));
      EXPECT_EQ(ended.exit_code, 1) << out;
      EXPECT_TRUE(ended.out.starts_with("the surface touches itself at t = ")) << ended.out;
      EXPECT_TRUE(ended.err.starts_with("sbeh: the surface passes through itself")) << ended.err;
      const Table last = table(out + "/profiles/0001.csv");
      EXPECT_LT(last.numbers("z").front() - last.numbers("z").back(), 0) << out;
      EXPECT_GT(last.numbers("z").front() - last.numbers("z").back(), -0.03) << out;
    }
  write("in.toml", oblate("SSH", "0.55"));
  must(into("apart", "relax"));
}

TEST_F(Relax, from_rows_stays_at_rest_whatever_the_tolerance_the_steps_and_the_output_times) {
  write("scan.toml",
        "[scan]\nreduced_volume = [0.6, 0.8]\nL = [0.05]\nbranches = [\"oblate\", \"prolate\"]\n");
  write("necks.toml",
        "[scan]\nreduced_volume = [0.5, 0.6]\nL = [0.05]\nmodels = [\"SSH\"]\n"
        "branches = [\"stomatocyte\"]\n[numerics]\nelements = 96\n");
  must(into("scan", "scan", "scan.toml"));
  must(into("necks", "scan", "necks.toml"));
  const std::vector<std::string> ways{"[numerics]\ntolerance = 1e-8\n",
                                      "[numerics]\nfirst_step = 0.05\n",
                                      "[numerics]\nfirst_step = 1e-12\nsmallest_step = 1e-15\n",
                                      "[time]\noutput = [0, 1e-9, 1e-6, 1e-3]\n"};
  for (const std::string folder : {"scan", "necks"}) {
    const Table scan = table(folder + "/scan.csv");
    for (std::size_t row = 0; row < scan.rows.size(); ++row) {
      const std::string& way = ways[row % ways.size()];
      const auto of = [&](const char* column) { return scan.text(row, column); };
      ASSERT_EQ(of("status"), "stationary");
      const std::string out = folder + std::to_string(row);
      write("in.toml",
            fmt::format(
                "model = \"{}\"\n[start]\nshape = \"scan\"\nfolder = \"{}\"\nbranch = \"{}\"\n"
                "reduced_volume = {}\nL = 0.05\n{}{}end = 10\n",
                of("model"), folder, of("branch"), of("reduced_volume"), way,
                way.starts_with("[time]") ? "" : "[time]\n"));
      const Ended ended = sbeh(into(out, "relax"));
      EXPECT_EQ(ended.exit_code, 0) << out << ended.err;
      const std::string rest = "at rest at t = ";
      ASSERT_TRUE(ended.out.starts_with(rest)) << out << ended.out;
      EXPECT_LT(std::stod(ended.out.substr(rest.size())), 1);
      for (const double energy : table(out + "/series.csv").numbers("energy"))
        EXPECT_NEAR(energy, scan.number(row, "energy"), 1e-7) << out;
    }
  }
}

TEST_F(Relax, says_at_its_end_time_how_fast_the_membrane_still_moves) {
  const auto said = [&](const std::string& end) {
    write("in.toml", ellipsoid + "[time]\nend = " + end + "\n");
    const Ended ended = sbeh(into("to" + end, "relax"));
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return ended.out;
  };
  const std::string moving = said("0.01"), words = "\nnot at rest: it moves by ";
  const auto at = moving.find(words);
  ASSERT_NE(at, std::string::npos) << moving;
  EXPECT_GT(std::stod(moving.substr(at + words.size())), 0.1);
  EXPECT_NE(moving.find(", at rest it is below 1e-06\n"), std::string::npos) << moving;

  const std::string rests = said("50");
  EXPECT_TRUE(rests.starts_with("at rest")) << rests;
  EXPECT_EQ(rests.find("not at rest"), std::string::npos) << rests;
}

TEST_F(Relax, that_is_perturbed_comes_back_to_the_row_it_began_from) {
  write("scan.toml",
        "[scan]\nreduced_volume = [0.65, 0.8]\nL = [0.05]\nbranches = [\"oblate\", \"prolate\"]\n"
        "[numerics]\nelements = 24\n");
  must(into("scan", "scan", "scan.toml"));
  for (const std::string model : {"SBEH", "SSH"})
    for (const std::string branch : {"oblate", "prolate"})
      for (const std::string v : {"0.65", "0.8"})
        for (const std::string modes : {"[[2, 0.02]]", "[[3, -0.02], [4, 0.01]]"}) {
          const std::string point = fmt::format("{}_{}_v{}_L0.05", model, branch, v);
          const std::string again = point + modes;
          write(
              "in.toml",
              fmt::format(
                  "model = \"{}\"\n[start]\nshape = \"scan\"\nfolder = \"scan\"\nbranch = \"{}\"\n"
                  "reduced_volume = {}\nL = 0.05\nperturbation = {}\n[numerics]\n"
                  "tolerance = 1e-4\nlargest_step = 1\n[time]\nend = 300\n",
                  model, branch, v, modes));
          const Ended ended = sbeh(into(again, "relax"));
          EXPECT_EQ(ended.exit_code, 0) << ended.err;
          EXPECT_TRUE(ended.out.starts_with("at rest")) << ended.out;
          const Table series = table(again + "/series.csv");
          const Table profile = table(fmt::format("scan/points/{}.csv", point));
          const Table last = table(again + "/profiles.csv");
          const Table end =
              table(fmt::format("{}/{}", again, last.text(last.rows.size() - 1, "file")));
          const double start_energy = series.numbers("energy").front(),
                       end_energy = series.numbers("energy").back();
          EXPECT_GT(start_energy, end_energy + 1e-5) << again;
          EXPECT_NEAR(series.numbers("reduced_volume").front(), std::stod(v), 1e-10);
          const auto height = [](const Table& t) {
            return t.numbers("z").front() - t.numbers("z").back();
          };
          EXPECT_NEAR(height(end), height(profile), 1e-3) << again;
        }
}

TEST_F(Relax, refuses_a_start_that_passes_through_itself) {
  write("in.toml",
        "model = \"SSH\"\ntime.end = 1\n[start]\nshape = \"ellipsoid\"\nreduced_volume = 0.4\n"
        "perturbation = [[2, -2]]\n");
  must_refuse(into("out", "relax"), "in.toml: [start] perturbation: is too large: ");
  EXPECT_FALSE(exists(path("out")));
}

TEST_F(Relax, of_harmonics_has_the_reduced_volume_asked_for) {
  for (const std::string v : {"0.9", "0.95", "0.999"}) {
    write("in.toml",
          "model = \"SSH\"\ntime.end = 1e-6\n[start]\nshape = \"harmonics\"\n"
          "modes = [[2, 0.04], [3, 0.02]]\nreduced_volume = "
              + v + "\n");
    must(into(v, "relax"));
    for (const double value : table(v + "/series.csv").numbers("reduced_volume"))
      EXPECT_NEAR(value, std::stod(v), 1e-10);
  }
  write("in.toml",
        "model = \"SSH\"\ntime.end = 1e-6\n[start]\nshape = \"harmonics\"\n"
        "modes = [[2, 0.04]]\nreduced_volume = 0.1\n");
  must_refuse(
      into("none", "relax"),
      "in.toml: [start] modes: harmonic sphere: reduced volume 0.1: r reaches 0 before, at ");
}

TEST_F(Relax, can_be_run_again_from_the_run_toml_it_leaves_with_the_same_bytes) {
  write("scan.toml", small_scan);
  must(into("scan", "scan", "scan.toml"));
  write("ellipsoid.toml", ellipsoid + "[time]\nend = 0.003\n");
  write("modes.toml",
        "model = \"SBEH\"\ntime.end = 0.003\n[start]\nshape = \"harmonics\"\n"
        "modes = [[2, 0.04], [3, 0.02]]\n[material]\nL = 0.05\n[numerics]\nelements = 16\n");
  write("row.toml", from_the_scan("SSH", "0.05"));
  for (const std::string name : {"ellipsoid", "modes", "row"}) {
    must(into(name, "relax", name + ".toml"));
    must(into(name + "2", "relax", name + "/run.toml"));
    EXPECT_TRUE(contents(name) == contents(name + "2")) << name;
  }
}

TEST_F(Relax, does_not_depend_on_the_number_of_threads) {
  write("in.toml", ellipsoid + "[time]\nend = 0.003\n");
  must({"relax", "in.toml", "-o", "one", "--no-pictures", "--threads", "1"});
  must({"relax", "in.toml", "-o", "two", "--no-pictures", "--threads", "2"});
  EXPECT_TRUE(contents("one") == contents("two"));
}

}  // namespace
}  // namespace sbeh::tools::test
