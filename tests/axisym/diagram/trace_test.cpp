// Branches with spontaneous curvature, over their folds, to where their necks close.
#include "axisym/diagram/closing.h"
#include "axisym/diagram/equal_energy.h"
#include "axisym/shape_class.h"
#include "axisym/shooting/seifert_shooting.h"
#include "tests/axisym/diagram/traced.h"

namespace sbeh::axisym::test {
namespace {

const TraceOptions no_modes{.largest_m = 0};

// An independent calculation: spectral, ten digits.
struct Loss {
  double c0;
  bool prolate;
  double reduced_volume;
};
constexpr Loss losses[]{{3, true, 0.752601896165}, {-2.4, false, 0.731398942384}};

TEST(Trace, loses_the_symmetry_where_an_independent_calculation_does) {
  for (const Loss& of : losses)
    for (const int elements : {48, 96}) {
      const Line line = down_to(0.72, bare(-of.c0), true);
      const Trace found =
          trace(line, round(line, of.prolate, elements), with_elements(elements), no_modes);
      const auto lost = of_kind(found, Special::symmetry_loss);
      ASSERT_EQ(lost.size(), 1U) << of.c0;
      std::printf("  c0 = %g, %d elements: V_r = %.12f, error %.1e\n", of.c0, elements,
                  volume_of(line, lost[0]), lost[0].error);
      EXPECT_LT(lost[0].error, 1e-9);
      EXPECT_NEAR(volume_of(line, lost[0]), of.reduced_volume, 1e-9);
    }
}

// By shooting, with other unknowns and equations.
TEST(Trace, has_the_losses_and_folds_of_shooting) {
  const Numerics numerics = with_elements(48);
  for (const auto& [c0, prolate] :
       {std::pair{3., true}, {2.5, true}, {-1., false}, {-2.4, false}}) {
    const LossAndFold shot = shoot_symmetry_loss(prolate ? Branch::prolate : Branch::oblate,
                                                 {.tolerance = 1e-14, .H0 = -c0});
    const Line line = down_to(0.55, bare(-c0), true);
    const Trace parent = trace(line, round(line, prolate, 48), numerics, no_modes);
    const auto lost = of_kind(parent, Special::symmetry_loss);
    ASSERT_FALSE(lost.empty()) << c0;
    Line open = line;
    open.symmetric = false;
    const auto start = leaving(open, lost[0], numerics);
    ASSERT_TRUE(start) << c0;
    const auto folds = of_kind(trace(open, *start, numerics, no_modes), Special::fold);
    ASSERT_FALSE(folds.empty()) << c0;
    std::printf("  c0 = %g: %.12f, %.12f by shooting, errors %.1e, %.1e\n", c0,
                shot.loss.reduced_volume, shot.fold.reduced_volume, shot.loss.error,
                shot.fold.error);
    EXPECT_LT(std::max(shot.loss.error, shot.fold.error), 1e-9);
    EXPECT_NEAR(volume_of(line, lost[0]), shot.loss.reduced_volume, 1e-9) << c0;
    EXPECT_NEAR(volume_of(line, folds[0]), shot.fold.reduced_volume, 1e-9) << c0;
    const double F = F_of(line, lost[0].state, lost[0].state.mu) / (8 * pi);
    EXPECT_NEAR(F, shot.loss.energy, 1e-7) << c0;
  }
}

// Two spheres side by side of area 4π whose neck is ideal at c₀ = 3: 1/R + 1/r = 3, R² + r² = 1.
double volume_of_ideal_pair(double c0) {
  double low = std::sqrt(0.5), high = 0.999;  // of R; 1/R + 1/r grows with it
  for (int k = 0; k < 60; ++k) {
    const double R = (low + high) / 2, r = std::sqrt(1 - R * R);
    (1 / R + 1 / r < c0 ? low : high) = R;
  }
  const double r = std::sqrt(1 - low * low);
  return low * low * low + r * r * r;
}

TEST(Trace, of_pears_folds_and_ends_where_the_neck_closes) {
  constexpr double c0 = 3;
  const Numerics numerics = with_elements(48);
  const Line prolates = down_to(0.72, bare(-c0), true), pears = down_to(0.5, bare(-c0), false);
  const Trace parent = trace(prolates, round(prolates, true, 48), numerics, no_modes);
  const auto lost = of_kind(parent, Special::symmetry_loss);
  ASSERT_EQ(lost.size(), 1U);
  SpecialState here = lost[0];
  here.state.mu = (0.98 - volume_of(prolates, here)) / (0.98 - 0.5);
  const auto start = leaving(pears, here, numerics);
  ASSERT_TRUE(start);
  const Trace found = trace(pears, *start, numerics, no_modes);
  EXPECT_EQ(found.end, TraceEnd::limit);

  // Towards larger V_r at first, unstable; back on a stable leg.
  const auto folds = of_kind(found, Special::fold);
  ASSERT_EQ(folds.size(), 1U);
  EXPECT_GT(volume_of(pears, folds[0]), volume_of(prolates, lost[0]) + 0.1);
  EXPECT_LT(folds[0].error, 1e-9);
  for (const TracePoint& p : found.points) EXPECT_EQ(p.negative_directions, p.leg == 0 ? 1 : 0);
  EXPECT_EQ(classify(found.points.back().state.X), ShapeClass::pear);

  const PathState& last = found.points.back().state;
  EXPECT_LT(thinnest_neck(last.X), 2e-3);
  const Diagnostics d = diagnose(pears.material, last);
  const auto spheres = closing_shape(pears.material, d);
  ASSERT_TRUE(spheres);
  EXPECT_EQ(spheres->radii.size(), 2U);
  EXPECT_FALSE(spheres->nested);
  const double limit = diagnose(pears.material, *spheres).reduced_volume;
  EXPECT_NEAR(limit, volume_of_ideal_pair(c0), 1e-12);
  EXPECT_NEAR(d.reduced_volume, limit, 0.02);  // a neck of radius a is off by a ln(1/a)

  // The way into the neck tells its V_r without knowing the spheres.
  std::array<ClosingMeasures, 4> way;
  double wanted = 0;
  auto point = found.points.rbegin();
  for (ClosingMeasures& at : way) {
    while (thinnest_neck(point->state.X) < wanted) ++point;
    at = {thinnest_neck(point->state.X), {pears.at(point->state.mu).reduced_volume}};
    wanted = 2 * at.radius;
  }
  const ClosedMeasures closed = with_closed_neck(way);
  EXPECT_LT(closed.errors[0], 1e-3);
  EXPECT_NEAR(closed.values[0], limit, closed.errors[0]);
}

TEST(Trace, counts_directions_among_all_shapes_where_enough_modes_tell) {
  const Line line = down_to(0.6, bare(0), true);
  for (const int largest_m : {3, 4})
    for (const TracePoint& p :
         trace(line, round(line, false, 48), with_elements(48), {.largest_m = largest_m}).points) {
      const double volume = line.at(p.state.mu).reduced_volume;
      EXPECT_EQ(p.negative_directions, 0) << volume;
      if (largest_m < 4)
        EXPECT_FALSE(p.negative_directions_3d) << volume;
      else
        EXPECT_EQ(p.negative_directions_3d, volume > 0.749729 ? 2 : 0) << volume;
    }
}

// dU/dV = P along a branch, by differences of order 4.
TEST(Trace, has_energies_that_go_with_the_pressure) {
  const Line line = down_to(0.6, bare(1), true);
  const Trace found = trace(line, round(line, false, 48), with_elements(48), no_modes);
  ASSERT_GT(found.points.size(), 5U);
  constexpr double h = 0.01;  // of μ
  for (const TracePoint& p : found.points) {
    const double mu = p.state.mu;
    if (mu < 0.1 || mu > 0.9 || p.leg > 0) continue;
    const auto F = [&](double t) {
      const auto s =
          solve_at(line.material, line.model, line.at(mu + t), p.state, {.symmetric = true});
      EXPECT_TRUE(s);
      return F_of(line, *s, mu + t);
    };
    const double slope = (8 * (F(h) - F(-h)) - (F(2 * h) - F(-2 * h))) / (12 * h);
    EXPECT_NEAR(slope / line.volume_rate(), p.state.pressure, 1e-5 * std::abs(p.state.pressure));
  }
}

// F/8πκ at V_r = 0.651076483847, where oblates and prolates have the same (by shooting).
TEST(EqualEnergy, of_classical_prolates_and_oblates) {
  const Numerics numerics = with_elements(48);
  const Line line = down_to(0.6, bare(0), true);
  std::vector<PathState> states[2];
  for (const bool prolate : {false, true})
    for (const TracePoint& p : trace(line, round(line, prolate, 48), numerics, no_modes).points)
      states[prolate].push_back(p.state);
  const auto equal = equal_energies(line, states[0], states[1], numerics);
  ASSERT_EQ(equal.size(), 1U);
  EXPECT_LT(equal[0].error, 1e-7);
  EXPECT_NEAR(equal[0].first.at.reduced_volume, 0.651076483847198, std::max(1e-9, equal[0].error));
}

TEST(ClosingShape, has_the_mean_curvature_that_the_neck_wants) {
  for (const double H0 : {-4., -3., 1.5}) {
    const Material material = bare(H0);
    const auto all = with_ideal_necks(material);
    EXPECT_FALSE(all.empty());
    for (const TouchingSpheres& spheres : all) {
      double area = 0;
      for (const double R : spheres.radii) area += R * R;
      EXPECT_NEAR(area, 1, 1e-12);
      const double first = 1 / spheres.radii.front(),
                   last = (spheres.nested ? -1 : 1) / spheres.radii.back();
      EXPECT_NEAR(-(first + last), H0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym::test
