// What gives way at the folds of ordered shapes, and where.
#include "axisym/stationary/fold_kind.h"

#include "axisym/stationary/branch_entry.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

struct Case {
  Branch branch;
  double v, H0, L;
  FoldKind kind;
  double k0 = 0;
};
Material material_of(const Case& c) {
  Material material;
  material.spontaneous_curvature = c.H0;
  material.residual_stiffness = c.k0;
  return material;
}

// The state at the fold of the ordered branch, from SSH's shape.
std::optional<BranchState> fold_of(const Case& c, const Numerics& numerics) {
  const Material material = material_of(c);
  constexpr double first = 1e-5;
  const auto entry = enter_branch(c.branch, material.with_L(first), numerics);
  if (!entry) return {};
  const auto ssh = follow(material, Model::SSH, entry->state, {c.v, first}, numerics);
  const auto ordered = solve_at(material, Model::SBEH, {c.v, first}, ssh.state);
  if (!ordered) return {};
  BranchState state = *ordered;
  for (double L = 4 * first; state.at.L < 2; L = std::min(4 * L, 2.)) {
    const auto next = follow(material, Model::SBEH, state, {c.v, L}, numerics);
    if (next.arrival == Arrival::fold) return next.state;
    if (next.arrival == Arrival::lost) return {};
    state = next.state;
  }
  return {};
}

TEST(FoldKind, is_where_the_order_is_lost_on_every_branch) {
  for (const Case& c : {Case{Branch::oblate, 0.6, 0, 0.0706374, FoldKind::rim},
                        {Branch::oblate, 0.75, 0, 0.1106907, FoldKind::rim},
                        {Branch::oblate, 0.84, 0, 0.1689, FoldKind::rim},
                        {Branch::oblate, 0.86, 0, 0.8894, FoldKind::whole},
                        {Branch::oblate, 0.9, 0, 0.8280, FoldKind::whole},
                        {Branch::oblate, 0.75, 1, 0.0536, FoldKind::rim},
                        {Branch::oblate, 0.9, 0.2, 0.6392, FoldKind::whole},
                        {Branch::oblate, 0.8, -1, 1.2459, FoldKind::rim},
                        {Branch::oblate, 0.8, 0, 0.9414, FoldKind::whole, 0.05},
                        {Branch::oblate, 0.7, -2.4, 0.0699, FoldKind::pole},
                        {Branch::oblate, 0.75, -2.4, 0.0801, FoldKind::pole},
                        {Branch::oblate, 0.8, -2.4, 0.0956, FoldKind::pole},
                        {Branch::prolate, 0.6, 0, 0.1255, FoldKind::pole},
                        {Branch::prolate, 0.9, 0, 0.2763, FoldKind::pole},
                        {Branch::prolate, 0.8, -2.4, 0.1005, FoldKind::neck},
                        {Branch::prolate, 0.9, 0, 0.6313, FoldKind::whole, 0.05},
                        {Branch::stomatocyte, 0.55, 0, 3.46e-4, FoldKind::neck, 0.001},
                        {Branch::stomatocyte, 0.5, 0, 6.7148e-5, FoldKind::neck},
                        {Branch::stomatocyte, 0.64, 0, 6.67e-4, FoldKind::neck}}) {
    SCOPED_TRACE(testing::Message()
                 << name(c.branch) << " " << c.v << ", H0 = " << c.H0 << ", k0 = " << c.k0);
    const auto fold = fold_of(c, {});
    ASSERT_TRUE(fold);
    EXPECT_NEAR(fold->at.L / c.L, 1, 0.01);
    const Material material = material_of(c);
    const auto kind = fold_kind(material, fold->at.L, *fold);
    ASSERT_TRUE(kind);
    EXPECT_EQ(name(*kind), std::string(name(c.kind)));
    // Of positions and order alone, which is what a scan keeps, and with the poles the other way round.
    const Material there = material.with_L(fold->at.L);
    EXPECT_EQ(fold_kind(material, fold->at.L, guess_from(there, Model::SBEH, *fold)), kind);
    State turned{fold->X.rowwise().reverse(), fold->beta.reverse()};
    turned.X.row(1) *= -1;
    EXPECT_EQ(fold_kind(material, fold->at.L, guess_from(there, Model::SBEH, turned)), kind);
  }
}

}  // namespace
}  // namespace sbeh::axisym
