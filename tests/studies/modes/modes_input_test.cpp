// Inputs of modes: what is read, and what is refused with which words.
#include "studies/modes/modes_input.h"

#include "studies/parameters/input_kind.h"
#include "tests/studies/parameters/input_file.h"

#include <cmath>

namespace sbeh::studies {
namespace {

using namespace test;

const std::string small_modes = "[modes]\nreduced_volume = 0.7\nL = 0.03\n";

ModesInput modes_of(const std::string& text) { return read_modes(written(text)); }

TEST(ModesInput, has_the_documented_defaults) {
  const ModesInput input = modes_of(small_modes);
  EXPECT_EQ(kind_of(written(small_modes)), InputKind::modes);
  EXPECT_EQ(input.scan, "");
  EXPECT_EQ(input.state.model, model::Model::SBEH);
  EXPECT_EQ(input.state.branch, axisym::Branch::oblate);
  EXPECT_EQ(input.state.reduced_volume, 0.7);
  EXPECT_EQ(input.state.material, model::Material{}.with_L(0.03));
  EXPECT_EQ(input.state.numerics, axisym::Numerics{});
  EXPECT_EQ(input.largest_m, 5);
  EXPECT_EQ(input.number, 1);
  EXPECT_EQ(input.thermal_energy, 0);
}

TEST(ModesInput, reads_back_from_its_description_as_the_same_input) {
  const std::string from_scan =
      "scan = \"" + scan_folder("[material]\nspontaneous_curvature = -2.7\n") + "\"\n";
  for (const std::string& text :
       {small_modes, small_modes + from_scan,
        small_modes + from_scan + "[material]\nspontaneous_curvature = -2.7\nviscosity = 3\n",
        small_modes
            + "model = 'SSH'\nbranch = 'prolate'\nlargest_m = 12\nnumber = 3\nfluctuations = 1e-4\n"
              "[material]\nresidual_stiffness = 0.01\nfriction = 0.3\n[numerics]\nelements = "
              "96\n"}) {
    const ModesInput input = modes_of(text);
    const std::string description = describe(input, "1.2.3");
    EXPECT_EQ(input, modes_of(description));
    EXPECT_EQ(describe(modes_of(description), "1.2.3"), description);
  }
}

TEST(ModesInput, of_a_scan_has_its_material) {
  const std::string from_scan = small_modes + "scan = \""
                              + scan_folder("[material]\nspontaneous_curvature = -2.7\n") + "\"\n";
  EXPECT_EQ(modes_of(from_scan).state.material.spontaneous_curvature, -2.7);
  EXPECT_EQ(modes_of(from_scan).state.material.L1, 0.03);
  const std::string message =
      message_for(read_modes, written(from_scan + "[material]\nspontaneous_curvature = -2\n"));
  EXPECT_TRUE(
      message.starts_with(":6: [material] spontaneous_curvature = -2: must be as in the scan "))
      << message;
  EXPECT_TRUE(message.ends_with(", -2.7: the state is one of that material")) << message;
}

TEST(ModesInput, that_is_wrong_is_refused_with_line_key_and_value) {
  expect_messages(read_modes, "[modes]\n",
                  {{"L = 1", ":1: [modes] reduced_volume: missing; must be a number"},
                   {"reduced_volume = 1\nL = 1",
                    ":2: [modes] reduced_volume = 1: must be < 1: a sphere may have any tension, "
                    "and its modes depend on that"},
                   {"reduced_volume = 0.8", ":1: [modes] L: missing; must be a number"}});
  expect_messages(
      read_modes, small_modes,
      {{"largest_m = 51", ":4: [modes] largest_m = 51: must be >= 0 and <= 50"},
       {"largest_m = 1.5", ":4: [modes] largest_m = 1.5: must be an integer"},
       {"number = 0", ":4: [modes] number = 0: must be >= 1 and <= 20"},
       {"fluctuations = -1", ":4: [modes] fluctuations = -1: must be >= 0"},
       {"model = 'Helfrich-local'",
        ":4: [modes] model = 'Helfrich-local': must be one of 'SBEH', 'SSH'"},
       {"branch = 'bud'",
        ":4: [modes] branch = 'bud': must be one of 'oblate', 'prolate', 'stomatocyte', 'pear'"},
       {"bransh = 'oblate'",
        ":4: [modes] bransh: unknown key; did you mean 'branch'? Known: scan, model, branch, "
        "reduced_volume, L, largest_m, number, fluctuations"},
       {"[material]\nL = 0.02",
        ":5: [material] L = 0.02: must not be given in modes, where L comes from [modes]"}});
}

TEST(ModesCost, is_within_a_factor_of_two_of_what_was_measured) {
  using enum axisym::Branch;
  struct Measured {
    axisym::Branch branch;
    double reduced_volume;
    int largest_m, number, elements, modes;
    double seconds, megabytes;
  };
  for (const Measured& run : {Measured{oblate, 0.7, 5, 1, 48, 12, 0.38, 2},
                              Measured{oblate, 0.7, 15, 4, 48, 128, 3.46, 21},
                              Measured{oblate, 0.7, 20, 8, 96, 336, 14.5, 64},
                              Measured{oblate, 0.7, 5, 1, 192, 12, 1.12, 3},
                              Measured{prolate, 0.4, 5, 4, 48, 48, 4.32, 9},
                              Measured{prolate, 0.4, 15, 1, 48, 32, 3.02, 7},
                              Measured{prolate, 0.4, 20, 8, 96, 336, 30.1, 63},
                              Measured{prolate, 0.7, 8, 4, 48, 72, 6.07, 12},
                              Measured{stomatocyte, 0.62, 5, 1, 48, 6, 1.07, 2},
                              Measured{stomatocyte, 0.62, 8, 4, 48, 36, 5.13, 7}}) {
    ModesInput input;
    input.state.branch = run.branch;
    input.state.reduced_volume = run.reduced_volume;
    input.largest_m = run.largest_m;
    input.number = run.number;
    input.state.numerics.elements = run.elements;
    const ModesCost cost = cost_of(input);
    EXPECT_EQ(cost.modes, run.modes);
    EXPECT_LT(std::abs(std::log2(cost.seconds / run.seconds)), 1) << cost.seconds;
    EXPECT_LT(std::abs(std::log2(cost.megabytes / run.megabytes)), 1) << cost.megabytes;
  }
}

}  // namespace
}  // namespace sbeh::studies
