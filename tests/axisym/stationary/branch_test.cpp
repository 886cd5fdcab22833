// Branches of stationary states over the (V_r, L) plane: the grid of the paper, and the fold.
#include "axisym/stationary/ssh_branch.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

const std::vector<double> grid_volumes{0.8, 0.7, 0.6}, grid_L{0.01, 0.03, 0.05, 0.07};

TEST(Grid, has_SBEH_below_SSH_with_a_gap_that_grows_with_L_and_with_falling_V_r) {
  std::array<BranchState, 2> row{first_oblate(Model::SBEH), first_oblate(Model::SSH)};
  std::vector<double> gap_above(grid_L.size(), 0.);
  for (const double v : grid_volumes) {
    double gap_left = 0;
    for (std::size_t k = 0; k < grid_L.size(); ++k) {
      std::array<double, 2> U{};
      for (const std::size_t m : {0u, 1u}) {
        const Model model = m == 0 ? Model::SBEH : Model::SSH;
        if (k == 0) row[m] = reach(model, row[m], {v, 0.05});
        const BranchState b = reach(model, row[m], {v, grid_L[k]});
        U[m] = energy_of(paper_material(grid_L[k]), b).total();
      }
      const double gap = U[1] - U[0];
      std::printf("V_r %.1f L %.2f: SBEH %.9f SSH %.9f gap %.6f\n", v, grid_L[k], U[0], U[1], gap);
      EXPECT_GT(gap, 0);
      EXPECT_GT(gap, gap_left);
      EXPECT_GT(gap, gap_above[k]);
      gap_left = gap_above[k] = gap;
    }
  }
}

TEST(Grid, has_the_order_smallest_at_the_rim) {
  BranchState row = first_oblate(Model::SBEH);
  for (const double v : grid_volumes) {
    row = reach(Model::SBEH, row, {v, 0.05});
    for (const double L : grid_L) {
      const State s = reach(Model::SBEH, row, {v, L});
      Eigen::Index rim, smallest;
      s.X.row(0).maxCoeff(&rim);
      s.beta.minCoeff(&smallest);
      EXPECT_LE(std::abs(rim - smallest), 1) << v << ' ' << L;
      EXPECT_LT(s.beta[smallest], s.beta[0] - 1e-3) << v << ' ' << L;
    }
  }
}

TEST(SSH, has_shapes_that_do_not_depend_on_L) {
  BranchState row = first_oblate(Model::SSH);
  for (const double v : grid_volumes) {
    row = reach(Model::SSH, row, {v, 0.05});
    const BranchState low = reach(Model::SSH, row, {v, 0.01}),
                      high = reach(Model::SSH, row, {v, 0.07});
    const double miss = (low.X - high.X).cwiseAbs().maxCoeff();
    std::printf("V_r %.1f: largest distance of nodes between L = 0.01 and 0.07: %.1e\n", v, miss);
    EXPECT_LT(miss, 1e-9);
    const double ratio = elastic(energy_of(paper_material(0.07), high))
                       / elastic(energy_of(paper_material(0.01), low));
    EXPECT_NEAR(ratio, 7, 1e-9);
  }
}

// ∫ |B|⁴ dS
double fourth_power_of_curvature(const StationaryState& s) {
  double sum = 0;
  for_each_point(s.X, diagnostic_points(), [&](int e, const ShapeValues& q, const CurvePoint& p) {
    const double B_tt = value_at(s.H, e, q) - p.B_phi;
    const double squared = B_tt * B_tt + p.B_phi * p.B_phi;
    sum += p.dS * squared * squared;
  });
  return sum;
}

// The potential holds the order with u″(2/3) = 27, curvature pulls with (9/2)L|B|²β = 3L|B|²: pointwise
// 2/3 − β = L|B|²/9, which gains (3L|B|²)²/(2·27). Change of shape and (E1) come in with L³.
TEST(Gap, between_SSH_and_SBEH_begins_as_a_sixth_of_the_fourth_power_of_curvature_times_L_squared) {
  for (const double v : {0.8, 0.6}) {
    BranchState fixed = oblate(Model::SSH, {v, 0.01}, 48),
                free = oblate(Model::SBEH, {v, 0.01}, 48);
    const double predicted = fourth_power_of_curvature(fixed) / 6;
    char title[80];
    std::snprintf(title, sizeof title, "V_r %.1f: (gap/L^2)/%.3f - 1", v, predicted);
    OrderTable table(title, "L");
    for (const double L : {8e-3, 4e-3, 2e-3}) {
      fixed = reach(Model::SSH, fixed, {v, L});
      free = reach(Model::SBEH, free, {v, L});
      const Material material = paper_material(L);
      const double gap = energy_of(material, fixed).total() - energy_of(material, free).total();
      table.add(L, gap / (L * L) / predicted - 1);
    }
    EXPECT_NEAR(table.print(), 1, 0.1);  // the next term is of relative order L
  }
}

TEST(Follow, reaches_a_point_along_any_way) {
  const BranchState start = first_oblate(Model::SBEH);
  const PlanePoint end{0.65, 0.02};
  const BranchState direct = reach(Model::SBEH, start, end);
  const BranchState by_L = reach(Model::SBEH, reach(Model::SBEH, start, {0.8, 0.02}), end);
  const BranchState by_V = reach(Model::SBEH, reach(Model::SBEH, start, {0.65, 0.05}), end);
  EXPECT_EQ(direct.at.reduced_volume, end.reduced_volume);
  EXPECT_EQ(direct.at.L, end.L);
  const Diagnostics d = diagnose(paper_material(end.L), direct);
  EXPECT_NEAR(d.area / (4 * pi), 1, 1e-10);
  EXPECT_NEAR(d.reduced_volume, end.reduced_volume, 1e-10);
  // The same state, on nodes that were placed along different ways: equal to the error in space.
  const double U = energy_of(paper_material(end.L), direct).total();
  for (const BranchState& b : {by_L, by_V}) {
    EXPECT_NEAR(energy_of(paper_material(end.L), b).total(), U, 1e-7);
    EXPECT_EQ(b.determinant_sign, direct.determinant_sign);
  }
  EXPECT_LT(residual_of(paper_material(end.L), Model::SBEH, direct), 1e-6);
}

TEST(Follow, keeps_the_sign_of_the_determinant_up_to_the_fold) {
  BranchState b = first_oblate(Model::SBEH);
  b = reach(Model::SBEH, b, {0.6, 0.05});
  const int sign = b.determinant_sign;
  EXPECT_NE(sign, 0);
  for (const double L : {0.06, 0.065, 0.069, 0.0705}) {
    b = reach(Model::SBEH, b, {0.6, L});
    EXPECT_EQ(b.determinant_sign, sign) << "L = " << L;
  }
}

TEST(Follow, of_SSH_meets_no_fold_in_L) {
  const BranchState b = oblate(Model::SSH, {0.6, 0.05}, 24);
  EXPECT_EQ(reach(Model::SSH, b, {0.6, 0.5}).at.L, 0.5);
}

TEST(Follow, does_not_claim_to_reach_what_is_not_there) {
  const BranchState b = first_oblate(Model::SBEH);
  for (const PlanePoint nowhere : {PlanePoint{1.02, 0.05}, PlanePoint{0.8, -0.01}})
    EXPECT_NE(follow(paper_material(0.05), Model::SBEH, b, nowhere, with_elements(24)).arrival,
              Arrival::reached)
        << nowhere.reduced_volume << ' ' << nowhere.L;
}

FollowResult towards(const BranchState& from, double L, int elements) {
  return follow(paper_material(from.at.L), Model::SBEH, from, {from.at.reduced_volume, L},
                with_elements(elements));
}

TEST(Fold, of_the_smooth_oblate_at_06_lies_at_L_007064) {
  const BranchState b = oblate(Model::SBEH, {0.6, 0.05}, 24);
  std::vector<double> found;
  for (const int elements : {24, 48, 96}) {
    const FollowResult r = towards(refined(Model::SBEH, b, elements), 0.12, elements);
    ASSERT_EQ(r.arrival, Arrival::fold) << elements << " elements";
    const Diagnostics d = diagnose(paper_material(r.state.at.L), r.state);
    std::printf("%d elements: L* = %.10f, |H| %.4f and order %.5f at the rim\n", elements,
                r.state.at.L, d.H_abs_max, d.order_min);
    found.push_back(r.state.at.L);
    EXPECT_GT(d.H_abs_max, 5);  // the end of a branch of smooth states
    EXPECT_LT(d.H_abs_max, 6);
    EXPECT_GT(d.order_min, 0.4);
    EXPECT_LT(d.order_min, 0.5);
  }
  EXPECT_GT(found.back(), 0.0706);
  EXPECT_LT(found.back(), 0.0708);
  EXPECT_LT(std::abs(found[1] - found[0]), 1e-6);
  EXPECT_LT(std::abs(found[2] - found[1]), 1e-6);
}

TEST(Fold, does_not_depend_on_where_the_way_begins_or_how_far_it_asks) {
  const BranchState far = oblate(Model::SBEH, {0.6, 0.03}, 48),
                    near = reach(Model::SBEH, far, {0.6, 0.07});
  const FollowResult a = towards(far, 0.12, 48), b = towards(near, 0.12, 48),
                     c = towards(near, 0.071, 48);
  for (const FollowResult* r : {&a, &b, &c}) ASSERT_EQ(r->arrival, Arrival::fold);
  // Located where the tangent's parameter component is 1e-7 of its length, and nodes differ.
  EXPECT_NEAR(a.state.at.L, b.state.at.L, 1e-7);
  EXPECT_NEAR(c.state.at.L, b.state.at.L, 1e-7);
}

TEST(Fold, is_approached_by_the_order_at_the_rim_like_a_square_root) {
  // The branch turns there: β − β* is proportional to √(L* − L).
  const BranchState b = oblate(Model::SBEH, {0.6, 0.07}, 48);
  const FollowResult fold = towards(b, 0.12, 48);
  ASSERT_EQ(fold.arrival, Arrival::fold);
  OrderTable table("order at the rim against its value at the fold", "L* - L");
  BranchState s = b;
  for (const double distance : {4e-6, 1e-6, 2.5e-7}) {
    s = reach(Model::SBEH, s, {0.6, fold.state.at.L - distance});
    table.add(distance, diagnose({}, s).order_min - diagnose({}, fold.state).order_min);
  }
  EXPECT_NEAR(table.print(), 0.5, 0.05);
}

// Another branch is near this fold, to which a long step towards it would jump.
TEST(Fold, is_the_same_from_wherever_its_branch_is_followed) {
  Material material = paper_material(0.05);
  material.flexoelectric = model::Polynomial({0, 0, 0.045});
  SshBranch classical(Branch::prolate, material, {});
  const auto ssh = classical.at(0.65);
  ASSERT_TRUE(ssh && ssh->arrival == Arrival::reached);
  const auto ordered = solve_at(material, Model::SBEH, {0.65, 0.05}, ssh->state,
                                {.most_iterations = 30, .symmetric = true});
  ASSERT_TRUE(ordered);
  for (const double L : {0.08, 0.16}) {
    const FollowResult begin = follow(material, Model::SBEH, *ordered, {0.65, L}, {});
    ASSERT_EQ(begin.arrival, Arrival::reached);
    const FollowResult end = follow(material, Model::SBEH, begin.state, {0.65, 4 * L}, {});
    ASSERT_EQ(end.arrival, Arrival::fold) << L;
    EXPECT_NEAR(end.state.at.L, 0.168005981, 1e-7) << L;  // 48 elements: 1e-8 of it
  }
}

}  // namespace
}  // namespace sbeh::axisym
