// Inputs of states: what is read, and what is refused with which words.
#include "studies/rest_states/states_input.h"

#include "studies/parameters/input_kind.h"
#include "tests/studies/parameters/input_file.h"

namespace sbeh::studies {
namespace {

using namespace test;

const std::string small_states = "[states]\nreduced_volume = 0.7\nL = 0.03\n";

StatesInput states_of(const std::string& text) { return read_states(written(text)); }

TEST(StatesInput, has_the_documented_defaults) {
  const StatesInput input = states_of(small_states);
  EXPECT_EQ(kind_of(written(small_states)), InputKind::states);
  EXPECT_EQ(input.model, model::Model::SBEH);
  EXPECT_EQ(input.start, StatesStart::branch);
  EXPECT_EQ(input.branch, axisym::Branch::oblate);
  EXPECT_EQ(input.reduced_volume, std::vector{0.7});
  EXPECT_EQ(input.L, std::vector{0.03});
  EXPECT_EQ(input.triangles, 320);
  EXPECT_EQ(input.eigenpairs, 6);
  EXPECT_EQ(input.rates, 0);
  EXPECT_FALSE(input.passes);
  EXPECT_EQ(input.material, model::Material{});
  EXPECT_EQ(input.numerics, axisym::Numerics{});
}

TEST(StatesInput, has_a_place_for_each_combination) {
  const auto places =
      places_of(states_of("[states]\nreduced_volume = [0.8, 0.7]\nL = [0.03, 0.05]\n"));
  ASSERT_EQ(places.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    EXPECT_EQ(places[std::size_t(k)].number, k + 1);
    EXPECT_EQ(places[std::size_t(k)].at.reduced_volume, k % 2 == 0 ? 0.7 : 0.8);
    EXPECT_EQ(places[std::size_t(k)].at.L, k < 2 ? 0.03 : 0.05);
  }
}

TEST(StatesInput, reads_back_from_its_description_as_the_same_input) {
  const std::string from_scan =
      "scan = \"" + scan_folder("[material]\nspontaneous_curvature = -2.7\n") + "\"\n";
  for (const std::string& text :
       {small_states, small_states + from_scan,
        small_states
            + "perturbation = [[2, 2, 0.1]]\nsymmetry = 'D2h'\n[follow]\nparameter = 'L'\nto = "
              "0.1\nswitch = false\n"
              "[units]\nradius_um = 10\nbending_rigidity_kT = 20\n",
        small_states
            + "mesh = \"a.stl\"\nmodel = 'SSH'\neigenpairs = 0\nrates = 3\npasses = "
              "true\n[search]\nreach = 0.2\n",
        small_states
            + "branch = 'prolate'\ntriangles = 1280\n[material]\nresidual_stiffness = 0.01\n"
              "[numerics]\nelements = 96\n"}) {
    const StatesInput input = states_of(text);
    const std::string description = describe(input, "1.2.3");
    EXPECT_EQ(input, states_of(description));
    EXPECT_EQ(describe(states_of(description), "1.2.3"), description);
  }
  EXPECT_EQ(states_of(small_states + from_scan).material.spontaneous_curvature, -2.7);
}

TEST(StatesInput, that_is_wrong_is_refused_with_line_key_and_value) {
  expect_messages(read_states, "[states]\n",
                  {{"L = 1",
                    ":1: [states] reduced_volume: missing; must be a number, a list of numbers, or "
                    "a range { from, to, count }"},
                   {"reduced_volume = 1\nL = 1",
                    ":2: [states] reduced_volume = 1: must be < 1: on the sphere area and volume "
                    "are one condition, not two"},
                   {"reduced_volume = 0.8",
                    ":1: [states] L: missing; must be a number, a list of numbers, or a range { "
                    "from, to, count }"}});
  expect_messages(
      read_states, small_states,
      {{"rates = 3\n[material]\norder = 'diffusive'\nmean_order = 0.6",
        ":4: [states] rates = 3: must be 0 with order = 'diffusive': its rates are not known"},
       {"rates = -1", ":4: [states] rates = -1: must be >= 0 and <= 50"},
       {"passes = 1", ":4: [states] passes = 1: must be true or false"},
       {"passes = true\n[follow]\nto = 0.6\nmost_negative = 0",
        ":7: [follow] most_negative = 0: must be >= 1 with passes = true: a branch of saddles "
        "would "
        "end at the first one"},
       {"eigenpairs = 51", ":4: [states] eigenpairs = 51: must be >= 0 and <= 50"},
       {"[search]\nreach = 0", ":5: [search] reach = 0: must be > 0 and <= 1"},
       {"[follow]\nto = 0.6\n[search]",
        ":6: [search]: must not be given together with [follow]: search first, then follow from a "
        "frame"},
       {"[follow]\nparameter = 'viscosity'",
        ":5: [follow] parameter = 'viscosity': must be one of 'reduced_volume', 'L', 'L2', 'L3', "
        "'H0', 'k0', 'W2', 'mean_order', 'potential_1', 'potential_2', 'potential_3', "
        "'potential_4', "
        "'flexoelectric_0', 'flexoelectric_1', 'flexoelectric_2', 'flexoelectric_3', "
        "'flexoelectric_4', 'kappa_0', 'kappa_1', 'kappa_2', 'kappa_3', 'kappa_4', "
        "'kappa_gauss_0', "
        "'kappa_gauss_1', 'kappa_gauss_2', 'kappa_gauss_3', 'kappa_gauss_4', 'lipid_density_0', "
        "'lipid_density_1', 'lipid_density_2', 'lipid_density_3', 'lipid_density_4'"},
       {"[follow]\nparameter = 'kappa_2'\nto = 1",
        ":5: [follow] parameter = 'kappa_2': needs kappa in [material], where its way begins"},
       {"[follow]\nparameter = 'W2'\nto = 1",
        ":5: [follow] parameter = 'W2': needs area_difference in [material], where its way begins"},
       {"[follow]\nparameter = 'mean_order'\nto = 0.5",
        ":5: [follow] parameter = 'mean_order': needs mean_order in [material], where its way "
        "begins"},
       {"[follow]\nparameter = 'L2'\nto = -1",
        ":6: [follow] to = -1: is no material there: 6 L1 + L2 + L3 = -0.8200000000000001: must be "
        "> 0 "
        "(distortion "
        "energy)"},
       {"[follow]\nparameter = 'k0'\nto = -1", ":6: [follow] to = -1: must be >= 0"},
       {"[follow]\nparameter = 'H0'\nto = 0",
        ":6: [follow] to = 0: must not be the H0 of the first state"},
       {"[follow]\nparameter = 'potential_4'\nto = -1",
        ":6: [follow] to = -1: the potential must be bounded below: its highest power even, with a "
        "coefficient > 0"},
       {"[follow]", ":4: [follow] to: missing; must be a number"},
       {"[follow]\nto = 0.7",
        ":5: [follow] to = 0.7: must not be the reduced_volume of the first state"},
       {"[follow]\nto = 1",
        ":5: [follow] to = 1: must be < 1: on the sphere area and volume are one condition, not "
        "two"},
       {"[follow]\nto = 0.6\nmost_negative = -1",
        ":6: [follow] most_negative = -1: must be >= 0 and <= 100"},
       {"[follow]\nto = 0.6\nlongest_step = 2",
        ":6: [follow] longest_step = 2: must be > 0 and <= 1"},
       {"triangles = 10", ":4: [states] triangles = 10: must be >= 20 and <= 200000"},
       {"model = 'Helfrich-local'",
        ":4: [states] model = 'Helfrich-local': must be one of 'SBEH', 'SSH'"},
       {"mesh = 'a.stl'\ntriangles = 320",
        ":5: [states] triangles = 320: must not be given: the surface of a file keeps its "
        "triangles"},
       {"frame = 'a.vtu'\nbranch = 'oblate'",
        ":5: [states] branch = 'oblate': must not be given together with frame: a state has one "
        "start"},
       {"frame = 'a.vtu'\nmesh = 'a.stl'",
        ":5: [states] mesh = 'a.stl': must not be given together with frame: a state has one "
        "start"}});
}

}  // namespace
}  // namespace sbeh::studies
