// Pears and saddles of a scan: where they are, and what they tend to.
#include "studies/scan/traced_states.h"
#include "tests/studies/parameters/input_file.h"

#include <cmath>
#include <numbers>

namespace sbeh::studies {
namespace {

using namespace test;
using axisym::Branch;
using model::Model;
using std::numbers::pi;

// c₀ = 3. By an independent spectral calculation pears leave the prolate at V_r = 0.752601896165; by shooting they fold at
// 0.890424336550.
constexpr double loss = 0.752601896165, fold = 0.890424336550;

axisym::StationaryCase pear_at(double v) {
  axisym::StationaryCase of{.model = Model::SSH, .branch = Branch::pear, .reduced_volume = v};
  of.material = of.material.with_L(0.01);
  of.material.spontaneous_curvature = -3;
  return of;
}

TEST(Pears, are_where_shooting_and_a_spectral_calculation_have_them) {
  const axisym::StationaryCase of = pear_at(0.8);
  TracedStates traced(of.material, of.numerics);
  EXPECT_EQ(traced.at(Branch::pear, fold - 1e-4).size(), 2U);  // a minimum and a saddle
  EXPECT_EQ(traced.at(Branch::pear, fold + 1e-6).size(), 0U);
  EXPECT_EQ(traced.at(Branch::pear, loss + 5e-3).size(), 2U);
  EXPECT_EQ(traced.at(Branch::pear, loss - 1e-6).size(),
            0U);  // whose neck is narrower than traces go
  EXPECT_EQ(traced.at(Branch::pear, 0.8).size(), 2U);
  const PointOutcome lowest = traced.point(of);
  EXPECT_EQ(lowest.row.status, PointStatus::stationary) << lowest.row.stop_reason;
  EXPECT_EQ(lowest.row.negative_directions, 0);
  const PointOutcome beyond = traced.point(pear_at(0.9));
  EXPECT_EQ(beyond.row.status, PointStatus::unresolved);
  EXPECT_NE(beyond.row.stop_reason.find("no pear is there"), std::string::npos);
}

// Two spheres beside each other, without their neck: (κ/2)(2/R + H₀)² 4πR² of each, and ∫K = 4π.
TEST(Pears, tend_to_two_spheres_as_their_neck_closes) {
  const axisym::StationaryCase of = pear_at(0.74);
  const PointOutcome point = TracedStates(of.material, of.numerics).point(of);
  EXPECT_EQ(point.row.status, PointStatus::limit) << point.row.stop_reason;
  ASSERT_TRUE(point.row.diagnostics && point.row.error);
  EXPECT_EQ(point.row.error->energy, 0);
  const axisym::Diagnostics& d = *point.row.diagnostics;
  EXPECT_NEAR(d.reduced_volume, 0.74, 1e-12);
  const double sum = -d.W2 / (8 * pi), R = (sum + std::sqrt(2 - sum * sum)) / 2, r = sum - R;
  EXPECT_NEAR(R * R + r * r, 1, 1e-12);
  EXPECT_NEAR(R * R * R + r * r * r, 0.74, 1e-10);
  const double kappa = of.material.kappa(model::full_order);
  double bending = 4 * pi * of.material.kappa_gauss(model::full_order);
  for (const double radius : {R, r})
    bending += kappa / 2 * std::pow(-2 / radius + 3, 2) * 4 * pi * radius * radius;
  EXPECT_NEAR(d.energy.bending, bending, 1e-10);
}

TEST(ScanOfAllBranches, is_read_back_and_refused_where_it_cannot_be) {
  const std::string scan = "[scan]\nreduced_volume = 0.8\nL = 0.01\nfurther = 1\n";
  const ScanInput input = read_scan(written(scan + "branches = 'all'\n"));
  EXPECT_EQ(input.branches.size(), 4U);
  EXPECT_EQ(input.further, 1);
  EXPECT_EQ(read_scan(written(describe(input, "0"))), input);
  const auto message = [&](const std::string& rest) {
    return message_for(read_scan, written(scan + rest));
  };
  EXPECT_NE(message("branches = 'every'\n").find("or \"all\""), std::string::npos);
  EXPECT_NE(message("method = 'flow'\n").find("needs method"), std::string::npos);
  EXPECT_NE(message("[material]\narea_difference = { stiffness = inf, delta_a0 = 1.1 }\n")
                .find("finite stiffness"),
            std::string::npos);
}

}  // namespace
}  // namespace sbeh::studies
