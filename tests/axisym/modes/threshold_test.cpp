// Thresholds: zeros of eigenvalues along branches, against folds, pitchforks and other numbers of elements.
#include "axisym/modes/threshold.h"

#include "axisym/modes/stability_3d.h"
#include "axisym/stationary/branch_entry.h"
#include "tests/axisym/cases.h"

#include <algorithm>
#include <array>

namespace sbeh::axisym {
namespace {

using namespace test;

Line line_of(Model model, const BranchState& from, PlanePoint to) {
  Line line{Material{}, model, from.at, to};
  line.symmetric = true;
  return line;
}

std::vector<Threshold> thresholds_to(Model model, const BranchState& from, PlanePoint to) {
  constexpr std::array ms{0, 1, 2, 3, 4, 5};
  return thresholds_along(line_of(model, from, to), from, ms, with_elements(element_count(from.X)));
}

BranchState ssh(Branch branch, double reduced_volume, int elements) {
  const Material material = paper_material(0.05);
  const Numerics numerics = with_elements(elements);
  const auto entry = enter_branch(branch, material, numerics);
  const FollowResult there =
      follow(material, Model::SSH, entry.value().state, {reduced_volume, 0.05}, numerics);
  EXPECT_EQ(there.arrival, Arrival::reached);
  return there.state;
}

// In steps along the branch, as a scan goes.
std::vector<Threshold> thresholds_of_ssh(Branch branch, double from, double to, int elements) {
  constexpr double stride = 0.02;
  const Numerics numerics = with_elements(elements);
  BranchState here = ssh(branch, from, elements);
  std::vector<Threshold> all;
  while (here.at.reduced_volume > to) {
    const PlanePoint next{std::max(to, here.at.reduced_volume - stride), here.at.L};
    for (Threshold& t : thresholds_to(Model::SSH, here, next)) all.push_back(std::move(t));
    const FollowResult there = follow(Material{}, Model::SSH, here, next, numerics);
    EXPECT_EQ(there.arrival, Arrival::reached) << next.reduced_volume;
    here = there.state;
  }
  return all;
}

TEST(Threshold, of_the_SSH_oblate_is_that_of_m_2_and_the_loss_of_its_symmetry) {
  const auto found = thresholds_of_ssh(Branch::oblate, 0.98, 0.505, 48);
  ASSERT_EQ(found.size(), 2u);
  for (const Threshold& t : found) {
    EXPECT_TRUE(t.is_located);
    std::printf("  m = %d %s: V_r = %.10f +- %.1e\n", t.m, name(t.parity),
                t.state.at.reduced_volume, t.error);
  }
  EXPECT_EQ(found[0].m, 2);
  EXPECT_EQ(found[0].parity, Parity::even);
  EXPECT_EQ(found[1].m, 0);
  EXPECT_EQ(found[1].parity, Parity::odd);
  // By shooting, see the README.
  EXPECT_NEAR(found[1].state.at.reduced_volume, 0.51043892235, 1e-8);
}

TEST(Threshold, of_the_SSH_oblate_for_m_2_does_not_move_under_refinement) {
  std::vector<double> volumes;
  for (const int elements : {48, 96, 192}) {
    const auto found = thresholds_to(Model::SSH, ssh(Branch::oblate, 0.76, elements), {0.74, 0.05});
    ASSERT_EQ(found.size(), 1u);
    volumes.push_back(found.front().state.at.reduced_volume);
    std::printf("  from %d elements: V_r = %.11f +- %.1e, with %d\n", elements, volumes.back(),
                found.front().error, element_count(found.front().state.X));
  }
  EXPECT_NEAR(volumes[0], volumes[2], 1e-8);
  EXPECT_NEAR(volumes[1], volumes[2], 1e-9);
}

TEST(Threshold, of_the_SSH_prolate_there_is_none) {
  EXPECT_TRUE(thresholds_of_ssh(Branch::prolate, 0.98, 0.4, 48).empty());
}

// Of the state near a threshold.
int directions_at(const Threshold& threshold, PlanePoint at) {
  const auto state = solve_at({}, Model::SBEH, at, threshold.state);
  const auto modes =
      state ? stability_3d(paper_material(at.L), Model::SBEH, *state, 5) : std::nullopt;
  return modes ? modes->negative_directions.value_or(-1) : -1;
}

// First one direction of m = 1 and its twin, then those of m = 2; as the eigenvalues of states on both sides say.
TEST(Threshold, of_the_ordered_oblate_come_before_its_fold) {
  std::vector<std::vector<Threshold>> found;
  for (const int elements : {48, 96})
    found.push_back(
        thresholds_to(Model::SBEH, oblate(Model::SBEH, {0.6, 0.06}, elements), {0.6, 0.08}));
  for (const auto& each : found) {
    ASSERT_EQ(each.size(), 2u);
    for (int k = 0; k < 2; ++k) {
      const Threshold& t = each[std::size_t(k)];
      const double L = t.state.at.L;
      std::printf("  m = %d %s: L = %.10f +- %.1e, with %d elements\n", t.m, name(t.parity), L,
                  t.error, element_count(t.state.X));
      EXPECT_EQ(t.m, k + 1);
      EXPECT_EQ(t.parity, Parity::even);
      EXPECT_TRUE(t.is_located);
      EXPECT_EQ(directions_at(t, {0.6, L - 1e-7}), 2 * k);
      EXPECT_EQ(directions_at(t, {0.6, L + 1e-7}), 2 * k + 2);
      EXPECT_NEAR(L, found[0][std::size_t(k)].state.at.L, 1e-8);
    }
  }
}

// The oblate's folds of folds.csv, here with twice as many elements as there.
TEST(Threshold, of_m_0_is_the_fold_of_the_branch_to_eight_digits) {
  const Numerics numerics = with_elements(96);
  for (const auto& [v, L] : {std::pair{0.6, 0.07}, {0.7, 0.092}, {0.8, 0.135}}) {
    const BranchState from = oblate(Model::SBEH, {v, L}, 96);
    const Line line = line_of(Model::SBEH, from, {v, 1.1 * L});
    const FollowResult end = follow(line, from, numerics);
    ASSERT_EQ(end.arrival, Arrival::fold);

    auto here = with_tangent(line, {from, 0});
    double ds = 0.1;
    for (auto next = here; next && next->slope() > 0; next = advance(line, *here, ds, 1e-8))
      here = next;
    ASSERT_TRUE(here);
    const Threshold threshold = threshold_within(line, *here, ds, 0, Parity::even, numerics);
    EXPECT_TRUE(threshold.is_located);
    std::printf("  V_r = %g: zero of m = 0 at L = %.11f, fold at %.11f\n", v, threshold.state.at.L,
                end.state.at.L);
    EXPECT_NEAR(threshold.state.at.L / end.state.at.L, 1, 1e-8);
  }
}

}  // namespace
}  // namespace sbeh::axisym
