// Inputs of studies of stability: what is read, which runs that makes, and what is refused with which words.
#include "studies/stability/stability_input.h"

#include "studies/parameters/input_kind.h"
#include "tests/studies/parameters/input_file.h"

namespace sbeh::studies {
namespace {

using namespace test;
using model::Model;

const std::string small = "[stability]\nreduced_volume = 0.8\nL = 0.05\n";

StabilityInput input_of(const std::string& text) { return read_stability(written(text)); }

TEST(StabilityInput, has_the_documented_defaults) {
  const StabilityInput input = input_of(small);
  EXPECT_EQ(input.models, (std::vector{Model::SBEH, Model::SSH}));
  EXPECT_EQ(input.branches, std::vector{axisym::Branch::oblate});
  EXPECT_EQ(input.perturbations, (std::vector<meshing::Harmonic>{{2, 2, 0.01}, {3, 3, 0.01}}));
  EXPECT_EQ(input.start, StabilityStart::harmonic);
  EXPECT_EQ(input.triangles, 320);
  EXPECT_EQ(input.coarser, 0);
  EXPECT_EQ(input.end_time, 20);
  EXPECT_EQ(input.numerics_3d.largest_step, 0.1);
  EXPECT_EQ(input.numerics_3d.tolerance, 1e-3);
}

TEST(StabilityInput, runs_the_classical_model_once_unless_its_rates_are_not_proportional_to_L) {
  const std::string grid = "[stability]\nreduced_volume = [0.7, 0.8]\nL = [0.03, 0.05]\n";
  const auto keys = keys_of(input_of(grid));
  EXPECT_EQ(keys.size(), 2 * (2 + 1) * 2u);
  for (const StabilityKey& key : keys)
    if (key.model == Model::SSH) {
      EXPECT_EQ(key.L, 0.05);
    }
  EXPECT_EQ(keys_of(input_of(grid + "[material]\nresidual_stiffness = 0.01\n")).size(), 16u);
}

TEST(StabilityInput, that_is_wrong_is_refused_with_line_key_and_value) {
  const std::vector<Case> added{
      {"modes = 2",
       ":4: [stability] modes: unknown key; did you mean 'models'? Known: reduced_volume, L, "
       "models, branches, "
       "perturbations, start"},
      {"start = 'modes'", ":4: [stability] start = 'modes': must be one of 'harmonic', 'mode'"},
      {"branches = ['stomatocyte']",
       ":4: [stability] branches = 'stomatocyte': must be one of 'oblate', 'prolate'"},
      {"perturbations = [[3, -3, 0.01]]",
       ":4: [stability] perturbations = [[3, -3, 0.01]]: must have m >= 1, not -3: with m = 0 the "
       "axisymmetric solver is enough, and m < 0 is m > 0 turned about the axis"},
      {"perturbations = [[3, 1, 0.01], [4, 1, 0.01]]",
       ":4: [stability] perturbations = [[3, 1, 0.01], [4, 1, 0.01]]: must have l = 3, 5 or 7 "
       "where m "
       "= 1, not 4: that mostly turns the surface"},
      {"perturbations = [[2, 2, -0.01]]",
       ":4: [stability] perturbations = [[2, 2, -0.01]]: must have amplitudes > 0 and <= 0.3, not "
       "-0.01"},
      {"[surface3d]\nend = 0", ":5: [surface3d] end = 0: must be > 0"},
      {"[surface3d]\ntriangles = 3", ":5: [surface3d] triangles = 3: must be >= 20 and <= 200000"},
      {"[surface3d]\ntriangles = 80\ncoarser = 80",
       ":6: [surface3d] coarser = 80: must be >= 20 and <= 79"},
      {"[surface3d]\nlargest_step = -1",
       ":5: [surface3d] largest_step = -1: must be in 1e-14 ... 1000"},
      {"[material]\nL = 0.1",
       ":5: [material] L = 0.1: must not be given in a study of stability, where L comes from "
       "[stability]"},
      {"[surface]",
       ":4: [surface]: unknown table; did you mean 'surface3d'? Known: stability, surface3d, "
       "material, numerics, units"},
  };
  expect_messages(read_stability, small, added);
  expect_messages(
      read_stability, "",
      {{"[stability]\nreduced_volume = [0.8, 1]\nL = 0.05",
        ":2: [stability] reduced_volume = [0.8, 1]: must be < 1: there is only the sphere, which "
        "cannot move"}});
}

TEST(Description, of_a_study_of_stability_reads_back_as_the_same_study) {
  const std::vector<std::string> texts{
      small,
      "[stability]\nreduced_volume = [0.61, 0.7]\nL = { from = 0.01, to = 0.03, count = 3 }\n"
      "models = ['SSH']\nbranches = ['prolate', 'oblate']\nperturbations = [[4, 3, 0.123]]\n"
      "start = 'mode'\n[surface3d]\ntriangles = 80\ncoarser = 20\nend = 0.1\nlargest_step = "
      "0.3\ntolerance = 1e-5\n"
      "[material]\nfriction = 0.7\n[numerics]\nelements = 32\n"};
  for (const std::string& text : texts) {
    const StabilityInput input = input_of(text);
    const std::string description = describe(input, "1.2.3");
    EXPECT_EQ(input, input_of(description));
    EXPECT_EQ(describe(input_of(description), "1.2.3"), description);
    EXPECT_EQ(kind_of(written(text)), InputKind::stability);
  }
}

}  // namespace
}  // namespace sbeh::studies
