// Beyond the fold of the smooth oblates: saddles and sharp rims, on elements graded towards the rim, against
// the finite elements, against other meshes, and as the limit of a vanishing residual stiffness.
#include "axisym/rim/beyond_fold.h"

#include "axisym/rim/path.h"
#include "axisym/stationary/stability.h"
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;
using Eigen::VectorXd;
namespace spectral = axisym::spectral;

std::vector<RimRecord> beyond(double reduced_volume, const std::vector<double>& L) {
  return beyond_fold({}, reduced_volume, L);
}

const RimRecord* find(const std::vector<RimRecord>& rows, RimKind kind, double L = 0) {
  for (const RimRecord& row : rows)
    if (row.kind == kind && (L == 0 || row.L == L)) return &row;
  ADD_FAILURE() << "no " << name(kind) << " at L = " << L;
  return nullptr;
}

// The finite elements' state next to a profile.
StationaryState settled_on(const RimRecord& row, int elements, double grading) {
  const Material material = paper_material(row.L);
  const NewtonResult r = solve_stationary(
      material, Model::SBEH, target_of(row.reduced_volume),
      guess_from(material, Model::SBEH, redistribute(row.state, grading, elements)));
  EXPECT_EQ(r.status, NewtonStatus::converged) << name(row.kind) << ", L = " << row.L;
  return r.state;
}

TEST(RimBasis, integrates_the_sphere_exactly) {
  const spectral::RimProblem problem({}, 0.9, spectral::Rim::smooth, {});
  const VectorXd sigma = spectral::rim_nodes(problem.mesh);
  const VectorXd y =
      problem.unknowns(pi, pi * sigma, VectorXd::Constant(sigma.size(), model::full_order));
  const auto e = spectral::expand(problem.at(0.05), y);
  ASSERT_TRUE(e);
  EXPECT_NEAR(e->measures[0], 4 * pi, 1e-12);
  EXPECT_NEAR(e->measures[1], 4 * pi / 3, 1e-12);
  EXPECT_NEAR(e->energy, 4 * pi * (9 * 0.05 / 4 * 2 * 4 / 9 - 1), 1e-12);  // (9L/4)β²|B|² − 1
}

TEST(RimBasis, that_makes_no_sense_is_refused) {
  using spectral::RimMesh;
  for (const RimMesh& mesh : {RimMesh{.elements = 3}, RimMesh{.degree = 1}, RimMesh{.ratio = 1}})
    EXPECT_THROW(spectral::rim_basis(spectral::Rim::smooth, mesh), std::invalid_argument);
}

TEST(BeyondFold, is_refused_where_oblates_touch_themselves_and_empty_without_a_fold) {
  EXPECT_THROW(beyond(0.5, {0.05}), std::invalid_argument);
  EXPECT_THROW(beyond(1, {0.05}), std::invalid_argument);
}

// Both discretisations resolve these states; the finite elements' energies converge with order 6.
TEST(BeyondFold, agrees_with_the_finite_elements_on_energy_rim_and_stability) {
  struct Case {
    double reduced_volume;
    RimKind kind;
    double L;
  };
  for (const Case& c : {Case{0.6, RimKind::saddle, 0.05},
                        {0.6, RimKind::sharp, 0.3},
                        {0.75, RimKind::saddle, 0.07},
                        {0.75, RimKind::sharp, 0.07},
                        {0.75, RimKind::sharp, 0.15},
                        {0.8, RimKind::sharp, 0.15}}) {
    SCOPED_TRACE(testing::Message() << name(c.kind) << " " << c.reduced_volume << " " << c.L);
    const auto rows = beyond(c.reduced_volume, {c.L});
    const RimRecord* row = find(rows, c.kind, c.L);
    if (!row) continue;
    const StationaryState s = settled_on(*row, 192, 2);
    const Diagnostics d = diagnose(paper_material(c.L), s);
    const double U = energy_of(paper_material(c.L), s).total();
    std::printf("  V_r %.2f L %.2f %-6s: U = %.9f, elements %+.1e; rim: order %.6f, H %.3f\n",
                c.reduced_volume, c.L, name(c.kind), row->energy, U - row->energy, row->order_rim,
                row->H_rim);
    EXPECT_NEAR(U, row->energy, 1e-8);
    EXPECT_NEAR(d.order_min / row->order_rim, 1, 1e-4);
    EXPECT_NEAR(d.H_rim / row->H_rim, 1, 1e-3);  // the discrete H is of lower order
    EXPECT_LT(d.resolution, largest_resolution);
    EXPECT_LT(row->resolution, largest_resolution);
    EXPECT_EQ(row->negative_directions, negative_directions(paper_material(c.L), Model::SBEH, s));
  }
}

TEST(BeyondFold, has_the_folds_that_the_finite_elements_find_from_either_side) {
  const auto rows = beyond(0.8, {0.15});
  const RimRecord *fold = find(rows, RimKind::fold), *second = find(rows, RimKind::second_fold),
                  *sharp = find(rows, RimKind::sharp, 0.15);
  ASSERT_TRUE(fold && second && sharp);
  Numerics numerics;
  numerics.elements = 96;
  numerics.grading = 2;
  const FollowResult up = follow(paper_material(0.05), Model::SBEH,
                                 oblate(Model::SBEH, {0.8, 0.1}, 96), {0.8, 0.3}, numerics);
  ASSERT_EQ(up.arrival, Arrival::fold);
  EXPECT_NEAR(up.state.at.L, fold->L, 1e-7);
  const StationaryState s = settled_on(*sharp, 96, 2);
  const FollowResult down =
      follow(paper_material(0.05), Model::SBEH, {s, {0.8, 0.15}}, {0.8, 0.05}, numerics);
  ASSERT_EQ(down.arrival, Arrival::fold);
  EXPECT_NEAR(down.state.at.L, second->L, 1e-7);
  EXPECT_EQ(fold->negative_directions, 0);
  EXPECT_EQ(second->negative_directions, 0);
}

TEST(SharpRim, is_lower_than_the_smooth_one_beyond_the_L_of_equal_energy) {
  const auto rows = beyond(0.6, {0.02, 0.03, 0.05, 0.07});
  const RimRecord* equal = find(rows, RimKind::equal_energy);
  ASSERT_TRUE(equal);
  EXPECT_NEAR(equal->L, 0.0437915, 1e-6);  // below the paper's L = 0.05
  BranchState smooth = oblate(Model::SBEH, {0.6, equal->L}, 48);
  EXPECT_NEAR(energy_of(paper_material(equal->L), smooth).total(), equal->energy, 1e-8);
  for (const double L : {0.02, 0.03, 0.05, 0.07}) {
    const RimRecord *sharp = find(rows, RimKind::sharp, L),
                    *saddle = find(rows, RimKind::saddle, L);
    ASSERT_TRUE(sharp && saddle);
    smooth = reach(Model::SBEH, smooth, {0.6, L});
    const double U = energy_of(paper_material(L), smooth).total();
    EXPECT_EQ(sharp->energy<U, L> equal->L) << "L = " << L;
    EXPECT_GT(saddle->energy, std::max(U, sharp->energy)) << "L = " << L;
    EXPECT_EQ(sharp->order_rim, 0) << "L = " << L;
    EXPECT_GT(sharp->jump, pi / std::numbers::sqrt3) << "L = " << L;  // or the kink would open
  }
}

// The kink at V_r = 0.6, from two cones.
spectral::RimState kink_at(const spectral::RimProblem& problem, double L) {
  const VectorXd sigma = spectral::rim_nodes(problem.mesh);
  const VectorXd beta = model::full_order * (20 * (0.5 - sigma.array())).tanh();
  const auto s = spectral::minimise(problem, L, problem.unknowns(2.8, 1.2 * sigma, beta));
  EXPECT_TRUE(s) << "L = " << L;
  return s ? *s : spectral::RimState{};
}
double energy_at(const spectral::RimProblem& problem, const spectral::RimState& s) {
  return spectral::expand(problem.at(s.L), s.y)->energy;
}

// The creeping of its angle costs the energy nothing that counts.
TEST(Kink, has_an_energy_that_does_not_depend_on_the_mesh) {
  const auto rows = beyond(0.6, {0.05});
  const RimRecord* sharp = find(rows, RimKind::sharp, 0.05);
  ASSERT_TRUE(sharp);
  for (const spectral::RimMesh& mesh :
       {spectral::RimMesh{.elements = 7, .degree = 16, .ratio = 0.15},
        spectral::RimMesh{.elements = 16, .degree = 8, .ratio = 0.4}}) {
    const spectral::RimProblem problem({}, 0.6, spectral::Rim::sharp, mesh);
    EXPECT_NEAR(energy_at(problem, kink_at(problem, 0.05)), sharp->energy, 3e-8);
  }
}

// s ∂_s ψ = −(P r/12E) cos ψ with E = Σ + u(0) − (P r/2) sin ψ, see "Sharp rims" in model/equations.md. It
// holds where the distance s is small against the width √L of the layer.
TEST(Kink, creeps_with_the_logarithm_of_the_distance_as_pressure_and_tension_say) {
  const spectral::RimProblem problem({}, 0.6, spectral::Rim::sharp,
                                     {.elements = 10, .degree = 14, .ratio = 0.2});
  const spectral::RimState kink = kink_at(problem, 0.07);
  const VectorXd psi = problem.angles_at_nodes(kink.y),
                 s = kink.y[0] * (0.5 - spectral::rim_nodes(problem.mesh).array());
  const double r = spectral::profile_of(problem, kink.y).X.row(0).maxCoeff();
  const double P = -kink.multipliers[1], tension = kink.multipliers[0];
  // Over the three elements next to the last, the joints being exact nodes of the solution.
  const Eigen::Index joint = 14 * 9, far = 14 * 6;
  const double slope = (psi[joint] - psi[far]) / std::log(s[joint] / s[far]);
  const double middle = (psi[joint] + psi[far]) / 2;
  const double E = tension - P * r / 2 * std::sin(middle);
  const double predicted = -P * r / (12 * E) * std::cos(middle);
  std::printf("  s from %.0e to %.0e: slope %.6f, predicted %.6f\n", s[far], s[joint], slope,
              predicted);
  EXPECT_NEAR(slope / predicted, 1, 0.02);
}

TEST(Kink, obeys_the_derivative_of_the_energy_by_L) {
  const spectral::RimProblem problem({}, 0.6, spectral::Rim::sharp, {});
  const double L = 0.05;
  const auto parts = spectral::energy_parts(problem.at(L), kink_at(problem, L).y);
  const double slope = (parts.distortion + parts.bending + parts.gaussian) / L;
  OrderTable table("central difference of U by L against U_EL/L", "h");
  for (const double h : {4e-3, 2e-3, 1e-3})
    table.add(h, (energy_at(problem, kink_at(problem, L + h))
                  - energy_at(problem, kink_at(problem, L - h)))
                         / (2 * h)
                     - slope);
  EXPECT_NEAR(table.print(), 2, 0.05);
}

// The finite elements cannot hold a kink, but every k₀ > 0 rounds it. Near it the stiffness and the width
// of the rounding balance: U − U_kink ∝ √k₀.
TEST(Kink, is_the_limit_of_a_vanishing_residual_stiffness) {
  const double L = 0.05;
  const spectral::RimProblem kinks({}, 0.6, spectral::Rim::sharp, {});
  const spectral::RimState kink = kink_at(kinks, L);
  // Rounded: past w = 0 at a distance of 0.01.
  const VectorXd beta = kinks.order_at_nodes(kink.y), psi = kinks.angles_at_nodes(kink.y);
  const VectorXd round = pi / 2 - (pi / 2 - psi.array()) * (beta.array() / 0.01).atan() * 2 / pi;
  const VectorXd filled = (beta.array().square() + 1e-4).sqrt();
  OrderTable table("U - U_kink with a residual stiffness", "k0");
  for (const double k0 : {1e-5, 1e-6, 1e-7}) {
    Material material = paper_material(L);
    material.residual_stiffness = k0;
    const spectral::RimProblem problem(material, 0.6, spectral::Rim::smooth, {});
    const auto guess = spectral::minimise(problem, L, problem.unknowns(kink.y[0], round, filled));
    ASSERT_TRUE(guess) << k0;
    const State state = redistribute(spectral::profile_of(problem, guess->y), 2, 192);
    const NewtonResult r =
        solve_stationary(material, Model::SBEH, target_of(0.6),
                         guess_from(material, Model::SBEH, state), {.most_iterations = 30});
    ASSERT_EQ(r.status, NewtonStatus::converged) << k0;
    table.add(k0, energy_of(material, r.state).total() - energy_at(kinks, kink));
  }
  EXPECT_NEAR(table.print(), 0.5, 0.05);
}

TEST(SharpRim, is_what_an_evolution_beyond_the_fold_comes_to_rest_at) {
  const auto rows = beyond(0.8, {0.15});
  const RimRecord* sharp = find(rows, RimKind::sharp, 0.15);
  ASSERT_TRUE(sharp);
  Numerics numerics;
  numerics.elements = 40;
  numerics.grading = 2;
  numerics.tolerance = 1e-3;
  const FlowResult run = run_flow(paper_material(0.15), Model::SBEH, ordered_spheroid(0.8, 40),
                                  target_of(0.8), numerics, {.end_time = 10, .output_times = {}});
  const double U = energy_of(paper_material(0.15), run.state).total();
  std::printf("  at t = %.3g U = %.8f, sharp state %.8f\n", run.last.time, U, sharp->energy);
  EXPECT_NEAR(U, sharp->energy, 1e-4);  // it still creeps
}

}  // namespace
}  // namespace sbeh::axisym
