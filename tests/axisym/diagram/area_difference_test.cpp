// States with an area difference: the shapes of the spontaneous-curvature model, in other ensembles.
#include "axisym/stationary/stability.h"
#include "tests/axisym/diagram/traced.h"

namespace sbeh::axisym::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr PlanePoint at{0.8, 0.5};  // with L = 1/2 κ is 1

// A prolate of c₀ = 2.
BranchState curved() {
  const Material material = bare(-2);
  const Line line = down_to(at.reduced_volume, material, true);
  const auto found = follow(line, {round(line, true, 48), line.from}, with_elements(48));
  EXPECT_EQ(found.arrival, Arrival::reached);
  return found.state;
}

TEST(AreaDifference, makes_the_shapes_of_a_spontaneous_curvature) {
  const BranchState c = curved();
  const Diagnostics d = diagnose(bare(-2), c);
  for (const double stiffness : {1.4, 50., infinite}) {
    // At rest c = 2 κ: W₂⁰ = W₂ − A c/(π k_ad).
    const Material material = bare(0, {stiffness, d.W2 - 4 * 2 / stiffness});
    const auto found = solve_at(material, Model::SSH, at, c, {.symmetric = true});
    ASSERT_TRUE(found) << stiffness;
    EXPECT_NEAR(found->moment, 2, 1e-7) << stiffness;
    EXPECT_LT((found->X - c.X).cwiseAbs().maxCoeff(), 1e-7) << stiffness;
    EXPECT_LT(residual_of(material, Model::SSH, *found), 1e-6);
    const Diagnostics there = diagnose(material, *found);
    EXPECT_NEAR(there.W2, d.W2, 1e-7);
    EXPECT_NEAR(there.energy.area_difference,
                stiffness == infinite ? 0 : stiffness / 8 * std::pow(8 / stiffness, 2), 1e-6);
    // ½∫(H + 2)² = ½∫H² + 2 W₂ + 2A
    EXPECT_NEAR(there.energy.bending + 2 * d.W2 + 8 * pi, d.energy.bending, 1e-6);
  }
}

TEST(AreaDifference, changes_the_energy_by_the_moment) {
  // ∂U/∂W₂⁰ = −c, and with H₀ ∂U/∂H₀ = κ(4πH₀ − W₂).
  const BranchState c = curved();
  const double W2 = diagnose(bare(-2), c).W2;
  constexpr double h = 3e-4;  // W₂ of prolates hardly moves there: c goes by 1 with 4e-3 of it
  const auto energy_with = [&](const Material& material) {
    const auto s = solve_at(material, Model::SSH, at, c, {.symmetric = true});
    EXPECT_TRUE(s);
    return diagnose(material, *s).energy.total();
  };
  const auto slope = [&](const auto& energy) {  // of order 4
    return (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
  };
  for (const double stiffness : {1.4, infinite}) {
    const double target = W2 - 8 / stiffness;
    EXPECT_NEAR(slope([&](double t) {
                  return energy_with(bare(0, {stiffness, target + t}));
                }),
                -2, 1e-6)
        << stiffness;
  }
  EXPECT_NEAR(slope([&](double t) { return energy_with(bare(-2 + t)); }), 4 * pi * -2 - W2, 1e-6);
}

// The bilayer couple is the limit of a large stiffness, linearly in its inverse.
TEST(AreaDifference, of_a_large_stiffness_is_the_bilayer_couple) {
  const double W2 =
      diagnose(bare(0),
               [] {
                 const Line line = down_to(0.7, bare(0), true);
                 return follow(line, {round(line, true, 48), line.from}, with_elements(48)).state;
               }())
          .W2;
  const auto loss = [&](double stiffness) {
    Line line = down_to(0.6, bare(0), true);
    const auto start = follow(line, {round(line, true, 48), line.from}, with_elements(48));
    line.material.area_difference = {stiffness, W2};
    line.first_W2 = W2;
    // From V_r = 0.7, where nothing has to be moved, upwards.
    const double mu = (0.98 - 0.7) / (0.98 - 0.6);
    const Line to_start = down_to(0.7, bare(0), true);
    const auto there =
        follow(to_start, {round(to_start, true, 48), to_start.from}, with_elements(48));
    EXPECT_EQ(start.arrival, Arrival::reached);
    auto path = with_tangent(line, {there.state, mu});
    EXPECT_TRUE(path);
    path->tangent = scaled(path->tangent, -1);
    const auto lost =
        of_kind(trace(line, *path, with_elements(48), {.largest_m = 0}), Special::symmetry_loss);
    EXPECT_EQ(lost.size(), 1U) << stiffness;
    return lost.empty() ? 0 : volume_of(line, lost[0]);
  };
  const double coupled = loss(infinite), near = loss(1000), nearer = loss(2000);
  std::printf("  V_r = %.10f, %.10f, %.10f\n", coupled, near, nearer);
  EXPECT_NEAR((near - coupled) / (nearer - coupled), 2, 0.02);
  EXPECT_NEAR(2 * nearer - near, coupled, 1e-6);
}

TEST(AreaDifference, takes_away_no_more_than_one_direction) {
  // In which the energy falls at a given H₀; the stiffer, the fewer.
  const Line line = down_to(0.5, bare(-3), true);
  const Trace found = trace(line, round(line, true, 48), with_elements(48), {.largest_m = 0});
  int more = 0;
  for (const TracePoint& p : found.points) {
    // As the neck closes V_r comes to a stand, and an eigenvalue is zero to rounding.
    if (std::abs(p.state.slope()) < 1e-7) continue;
    const double W2 = diagnose(bare(-3), p.state).W2;
    StationaryState s = p.state;
    s.moment = 3;
    int before = p.negative_directions;
    for (const double stiffness : {0.5, 5., 500., infinite}) {
      Material material = bare(0, {stiffness, W2 - 12 / stiffness});
      const double compliance = material.area_difference.compliance();
      StationaryState same = s;
      same.tension += 9. / 2 + 9 * compliance / 2;  // the same stress: (κ/2)H₀², and −c²/(2π k_ad)
      const int now = negative_directions(material, Model::SSH, same);
      EXPECT_LE(now, before);
      EXPECT_GE(now, p.negative_directions - 1);
      before = now;
    }
    more += p.negative_directions - before;
  }
  EXPECT_GT(more, 0);
}

}  // namespace
}  // namespace sbeh::axisym::test
