// The energies of the paper's stationary oblates, studies/inputs/paper_scan.toml.
#include "tests/tools/workplace.h"

#include <cmath>
#include <numbers>

namespace sbeh::tools::test {
namespace {

struct Reference {
  const char *model, *reduced_volume, *L;
  double energy;
};

// This program, version 0.1.0, the same scan with [numerics] elements = 96. From 64 elements to 96
// the energies change by less than 2e-10 of themselves, from the 48 of the scan by less than 1e-9.
constexpr Reference references[] = {
    {"SBEH", "0.6", "0.01", -11.845204138334}, {"SSH", "0.6", "0.01", -11.834665905079},
    {"SBEH", "0.6", "0.03", -10.469021753889}, {"SSH", "0.6", "0.03", -10.371256486519},
    {"SBEH", "0.6", "0.05", -9.190640147562},  {"SSH", "0.6", "0.05", -8.907847067959},
    {"SBEH", "0.6", "0.07", -8.038796181936},  {"SSH", "0.6", "0.07", -7.444437649399},
    {"SBEH", "0.7", "0.01", -11.970830490697}, {"SSH", "0.7", "0.01", -11.963631659883},
    {"SBEH", "0.7", "0.03", -10.824339082652}, {"SSH", "0.7", "0.03", -10.758153750930},
    {"SBEH", "0.7", "0.05", -9.741327809015},  {"SSH", "0.7", "0.05", -9.552675841977},
    {"SBEH", "0.7", "0.07", -8.729503196503},  {"SSH", "0.7", "0.07", -8.347197933024},
    {"SBEH", "0.8", "0.01", -12.092053639590}, {"SSH", "0.8", "0.01", -12.087572477107},
    {"SBEH", "0.8", "0.03", -11.170839061280}, {"SSH", "0.8", "0.03", -11.129976202604},
    {"SBEH", "0.8", "0.05", -10.287575391465}, {"SSH", "0.8", "0.05", -10.172379928101},
    {"SBEH", "0.8", "0.07", -9.444428712999},  {"SSH", "0.8", "0.07", -9.214783653597},
};

class PaperScan : public Workplace {
 protected:
  PaperScan() {
    must(into("out", "scan", std::filesystem::absolute("studies/inputs/paper_scan.toml").string()));
    scan = table("out/scan.csv");
  }
  Table scan;
};

TEST_F(PaperScan, has_the_energies_of_a_finer_mesh) {
  ASSERT_EQ(scan.rows.size(), std::size(references));
  for (const Reference& reference : references) {
    const std::size_t row = scan.find(reference.model, reference.reduced_volume, reference.L);
    EXPECT_EQ(scan.text(row, "status"), "stationary");
    EXPECT_NEAR(scan.number(row, "energy"), reference.energy, 1e-8 * std::abs(reference.energy))
        << reference.model << " " << reference.reduced_volume << " " << reference.L;
  }
}

// Full order: the Helfrich energy F = ∫ κ/2 H² of the classical oblate, with κ = 2L, κ_G = −2L at
// β = 2/3; the bending energy contains 4πκ_G beside it. 1.4525386 is the oblate's F/(8πκ) at
// V_r = 0.8 to 8 digits.
TEST_F(PaperScan, has_the_classical_oblate_where_the_order_is_full) {
  using std::numbers::pi;
  for (const char* L_text : {"0.01", "0.03", "0.05", "0.07"}) {
    const std::size_t row = scan.find("SSH", "0.8", L_text);
    const double L = scan.number(row, "L"), kappa = 2 * L, kappa_G = -2 * L;
    const double F = scan.number(row, "energy_bending") - 4 * pi * kappa_G;
    EXPECT_NEAR(F / (8 * pi * kappa), 1.4525386, 1e-7);
  }
}

}  // namespace
}  // namespace sbeh::tools::test
