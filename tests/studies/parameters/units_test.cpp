// [units]: what numbers are in physical units, physical values in inputs, and what is refused with which words.
#include "studies/parameters/units.h"

#include "studies/evolution/relax_input.h"
#include "studies/evolution/run_input.h"
#include "studies/modes/modes_input.h"
#include "studies/scan/scan_input.h"
#include "tests/studies/parameters/input_file.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::studies {
namespace {

using namespace test;
using std::numbers::pi;

constexpr double kT = 1.380649e-23 * 300;
const std::string vesicle =
    "[units]\nradius_um = 10\nbending_rigidity_kT = 20\nsurface_viscosity = 5e-10\n";
const Units units_of_vesicle{.radius_um = 10, .bending_rigidity = 20, .surface_viscosity = 5e-10};

// The bending energy of a sphere of uniform order is 8πκ whatever its radius, and its Gaussian part −4πκ.
TEST(Scales, give_a_sphere_its_bending_energy_in_kT_and_in_J) {
  const model::Material material = model::Material{}.with_L(0.03);
  const double bending = 8 * pi * material.kappa(model::full_order);
  Units units = units_of_vesicle;
  EXPECT_NEAR(bending * scales_of(units, material, model::Model::SSH).factor(dimension::energy),
              8 * pi * 20, 1e-11);
  units.in_kT = false;
  units.bending_rigidity = 8e-20;
  const Scales in_J = scales_of(units, material, model::Model::SSH);
  EXPECT_NEAR(bending * in_J.factor(dimension::energy), 8 * pi * 8e-20, 1e-31);
  EXPECT_EQ(in_J.unit(dimension::energy), "J");
}

// A residual stiffness is a part of κ.
TEST(Scales, count_all_of_the_stiffness_at_full_order) {
  model::Material material;
  material.L1 = 0.02, material.L2 = 0.01, material.L3 = -0.005;
  material.residual_stiffness = 0.005;
  const Scales scales = scales_of(units_of_vesicle, material, model::Model::SBEH);
  EXPECT_NEAR(*scales.energy, 20 * kT / 0.05, 1e-33);
}

// Physical laws between what is converted: the viscous stress μ_s V/R, the drag γV, the tension E/R², the pressure E/R³.
TEST(Scales, of_viscosity_and_of_friction_keep_the_balance_of_forces) {
  model::Material material = model::Material{}.with_L(0.05);
  material.viscosity = 2;
  material.friction_normal = material.friction_tangential = 0.3;
  const Scales s = scales_of(units_of_vesicle, material, model::Model::SBEH);
  const double R = 1e-5, tension = s.factor(dimension::tension),
               speed = 1e-6 * s.factor(dimension::speed);
  EXPECT_NEAR(2 * tension / (5e-10 * speed / R), 1, 1e-12);  // 2 is the number μ̂
  EXPECT_NEAR(s.factor(dimension::pressure) * R / tension, 1, 1e-13);

  Units dragged = units_of_vesicle;
  dragged.surface_viscosity.reset();
  dragged.friction = 1e6;
  const Scales d = scales_of(dragged, material, model::Model::SBEH);
  EXPECT_NEAR(0.3 * d.factor(dimension::friction), 1e6, 1e-6);
  EXPECT_NEAR(d.factor(dimension::friction) * 1e-6 * d.factor(dimension::speed)
                  / d.factor(dimension::pressure),
              1, 1e-12);
}

TEST(Scales, name_their_units_for_people_and_for_columns) {
  const Scales s = scales_of(units_of_vesicle, {}, model::Model::SBEH);
  using namespace dimension;
  for (const auto& [of, unit, suffix] :
       std::vector<std::tuple<Dimension, const char*, const char*>>{
           {none, "", ""},
           {length, "µm", "_um"},
           {area, "µm²", "_um2"},
           {volume, "µm³", "_um3"},
           {curvature, "1/µm", "_per_um"},
           {energy, "kT", "_kT"},
           {tension, "N/m", "_N_per_m"},
           {pressure, "Pa", "_Pa"},
           {dimension::time, "s", "_s"},
           {rate, "1/s", "_per_s"},
           {speed, "µm/s", "_um_per_s"},
           {power, "kT/s", "_kT_per_s"},
           {friction, "Pa s/m", "_Pa_s_per_m"}}) {
    EXPECT_EQ(s.unit(of), unit);
    EXPECT_EQ(s.suffix(of), suffix);
  }
}

TEST(Scales, leave_times_alone_that_nothing_tells) {
  Units units = units_of_vesicle;
  units.surface_viscosity.reset();
  const Scales s = scales_of(units, {}, model::Model::SBEH);
  EXPECT_EQ(s.factor(dimension::time), 1);
  EXPECT_EQ(s.suffix(dimension::rate), "_per_T");
  EXPECT_EQ(s.unit(dimension::power), "kT/T");
}

TEST(Units, of_an_input_are_read_described_and_read_back) {
  const std::string texts[] = {
      vesicle, "[units]\nradius_um = 0.1\nbending_rigidity_J = 8.3e-20\ntemperature = 310.5\n",
      "[units]\nradius_um = 3\nbending_rigidity_kT = 0.1\nfriction = 1e5\n"};
  for (const std::string& text : texts) {
    const ScanInput scan = read_scan(written(small_scan + text));
    ASSERT_TRUE(scan.units);
    EXPECT_EQ(read_scan(written(describe(scan, "1"))), scan);
    const RelaxInput relax = read_relax(written(small_relax + text));
    EXPECT_EQ(read_relax(written(describe(relax, "1"))), relax);
  }
  EXPECT_EQ(read_scan(written(small_scan + vesicle)).units, units_of_vesicle);
  EXPECT_FALSE(read_scan(written(small_scan)).units);
}

TEST(Units, that_are_wrong_are_refused_with_line_key_and_value) {
  const auto read = [](const std::filesystem::path& path) { return read_scan(path); };
  expect_messages(
      read, small_scan,
      {{"[units]\nbending_rigidity_kT = 20", ":4: [units] radius_um: missing; must be a number"},
       {"[units]\nradius_um = 1", ":4: [units] bending_rigidity_kT: missing; must be a number"},
       {"[units]\nradius_um = 0\nbending_rigidity_kT = 20",
        ":5: [units] radius_um = 0: must be > 0"},
       {"[units]\nradius_um = 1\nbending_rigidity_kT = -20",
        ":6: [units] bending_rigidity_kT = -20: must be > 0"},
       {"[units]\nradius_um = 1\nbending_rigidity_kT = 20\nbending_rigidity_J = 1e-19",
        ":6: [units] bending_rigidity_kT = 20: must not be given together with "
        "bending_rigidity_J"},
       {"[units]\nradius_um = 1\nbending_rigidity_kT = 20\nsurface_viscosity = 1\nfriction = 1",
        ":8: [units] friction = 1: must not be given together with surface_viscosity: either tells "
        "the unit of time"},
       {"[units]\nradius_um = 1\nbending_rigidity_kT = 20\ntemperatur = 300",
        ":7: [units] temperatur: unknown key; did you mean 'temperature'? Known: temperature, "
        "radius_um, bending_rigidity_J, bending_rigidity_kT, surface_viscosity, friction"},
       {"units = 3",
        ":4: [scan] units: unknown key. Known: reduced_volume, L, axes, models, branches, "
        "method, further, end_time, beyond_fold, modes, order_formula, domains, domain_width"}});
  const auto relax = [](const std::filesystem::path& path) { return read_relax(path); };
  expect_messages(relax, small_relax,
                  {{"[material]\nL = 0.05\nviscosity = 0\n" + vesicle,
                    ":7: [units]: "
                    "surface_viscosity tells no time: the material has no viscosity; give friction "
                    "(Pa s/m) instead"}});
}

// Against the conversion written out.
TEST(PhysicalValues, stand_in_inputs_for_numbers) {
  const std::string begin =
      "model = \"SBEH\"\nstart = { shape = \"ellipsoid\", reduced_volume = 0.7 }\n";
  const RelaxInput input = read_relax(
      written(begin
              + "[time]\nend = \"2 s\"\noutput = [0, \"500 ms\", \"0.02 min\"]\nprofiles = [1]\n"
                "[material]\nL = 0.04\nspontaneous_curvature = \"-0.12 1/um\"\nviscosity = 2\n"
              + vesicle));
  const double T = 5e-10 * 1e-10 / (2 * 20 * kT / 0.08);
  EXPECT_NEAR(input.times.end, 2 / T, 1e-13 * 2 / T);
  ASSERT_EQ(input.times.rows.size(), 3u);
  EXPECT_NEAR(input.times.rows[1], 0.5 / T, 1e-13 / T);
  EXPECT_NEAR(input.times.rows[2], 1.2 / T, 1e-13 * 2 / T);
  EXPECT_NEAR(input.material.spontaneous_curvature, -1.2, 1e-15);

  const ModesInput modes = read_modes(
      written("[modes]\nreduced_volume = 0.7\nL = 0.05\nfluctuations = \"1 kT\"\n" + vesicle));
  EXPECT_NEAR(modes.thermal_energy, 0.1 / 20, 1e-17);  // κ̂ = 0.1 is 20 k_BT
}

TEST(PhysicalValues, that_are_wrong_are_refused) {
  const auto read = [](const std::filesystem::path& path) { return read_relax(path); };
  const std::string begin =
      "model = \"SBEH\"\nstart = { shape = \"ellipsoid\", reduced_volume = 0.7 }\n";
  const std::string times =
      ": must be a number, or a text as in '2 s' with one of these units: s, "
      "ms, us, min, h";
  expect_messages(
      read, begin,
      {{"time.end = '2 um'\n" + vesicle, ":3: [time] end = '2 um'" + times},
       {"time.end = '2'\n" + vesicle, ":3: [time] end = '2'" + times},
       {"time.end = 's'\n" + vesicle, ":3: [time] end = 's'" + times},
       {"time.end = ''\n" + vesicle, ":3: [time] end = ''" + times},
       {"time.end = '-2 s'\n" + vesicle, ":3: [time] end = '-2 s': must be > 0"},
       {"time.end = 'nan s'\n" + vesicle, ":3: [time] end = 'nan s': must be a finite number"},
       {"time.end = '2 s'\n",
        ":3: [time] end = '2 s': must be a number; a unit needs a table [units], which tells of "
        "what vesicle"},
       {"time.end = '2 s'\n[units]\nradius_um = 1\nbending_rigidity_kT = 20\n",
        ":3: [time] end = '2 s': needs surface_viscosity (Pa s m) or friction (Pa s/m) in [units], "
        "which tell the unit of time"},
       {"time.end = 2\nnumerics.elements = '3 um'\n" + vesicle,
        ":4: [numerics] elements = '3 um': must be an integer"}});
  expect_messages([](const std::filesystem::path& path) { return read_scan(path); }, small_scan,
                  {{"method = 'flow'\nend_time = '2 s'\n" + vesicle,
                    ":5: [scan] end_time = '2 s': must be a number"}});
}

}  // namespace
}  // namespace sbeh::studies
