// Inputs of diagrams: what is read, and what is refused with which words.
#include "studies/diagram/diagram_input.h"

#include "studies/parameters/input_kind.h"
#include "tests/studies/parameters/input_file.h"

namespace sbeh::studies {
namespace {

using namespace test;

const std::string small_diagram = "[diagram]\nkind = 'area-difference'\n";

TEST(DiagramInput, has_the_documented_defaults) {
  const DiagramInput input = read_diagram(written(small_diagram));
  EXPECT_EQ(kind_of(written(small_diagram)), InputKind::diagram);
  EXPECT_EQ(input.kind, DiagramKind::area_difference);
  EXPECT_EQ(input.values, usual_values(DiagramKind::area_difference));
  EXPECT_EQ(input.values.size(), 51U);
  EXPECT_EQ(input.stiffness_ratio, 1.4);
  EXPECT_EQ(input.least_volume, 0.3);
  EXPECT_EQ(input.modes, 4);
  EXPECT_EQ(input.elements, 48);
}

TEST(DiagramInput, reads_back_from_its_description_as_the_same_input) {
  for (const std::string& text :
       {small_diagram, small_diagram + "values = [1.2, 0.9]\nstiffness_ratio = 3\nmodes = 0\n",
        std::string("[diagram]\nkind = 'spontaneous-curvature'\nvalues = [-3, 0.1]\n"
                    "least_volume = 0.6\nelements = 96\n"),
        std::string("[diagram]\nkind = 'bilayer-coupling'\n")}) {
    const DiagramInput input = read_diagram(written(text));
    EXPECT_EQ(read_diagram(written(describe(input, "0"))), input) << text;
  }
}

TEST(DiagramInput, that_is_wrong_is_refused_with_line_key_and_value) {
  expect_messages(
      read_diagram, "[diagram]\n",
      {{"kind = 'bilayer'",
        ":2: [diagram] kind = 'bilayer': must be one of 'spontaneous-curvature', "
        "'bilayer-coupling', 'area-difference'"},
       {"kind = 'bilayer-coupling'\nstiffness_ratio = 2",
        ":3: [diagram] stiffness_ratio = 2: must not be given without kind = \"area-difference\""},
       {"kind = 'bilayer-coupling'\nvalues = [1, 1]",
        ":3: [diagram] values = [1, 1]: must be different from each other"},
       {"kind = 'bilayer-coupling'\nleast_volume = 1",
        ":3: [diagram] least_volume = 1: must be >= 0.1 and <= 0.98"},
       {"kind = 'spontaneous-curvature'\nvalues = [11]",
        ":3: [diagram] values = 11: must be >= -10 and <= 10"}});
}

}  // namespace
}  // namespace sbeh::studies
