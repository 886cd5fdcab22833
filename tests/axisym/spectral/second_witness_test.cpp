// Finite elements against spectral curves beyond the classical shapes: with H₀, area difference, flexoelectric coupling,
// conserved order and area per lipid; minima, saddles, losses of symmetry and folds.
#include "axisym/modes/eigenmodes.h"
#include "axisym/spectral/minimiser.h"
#include "axisym/spectral/special.h"
#include "axisym/stationary/ssh_branch.h"
#include "axisym/stationary/stability.h"
#include "model/numerics/constrained_newton.h"
#include "tests/axisym/diagram/traced.h"
#include "tests/model/two_phases.h"

#include <Eigen/Eigenvalues>

namespace sbeh::axisym::test {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using spectral::basis, spectral::Basis, spectral::Critical, spectral::Problem, spectral::Symmetry;

constexpr int elements = 96;
constexpr double infinite = std::numeric_limits<double>::infinity();
const TraceOptions no_modes{.largest_m = 0};

// --- from the finite elements to spectral curves

// Unknowns of a problem near the elements' state: to the square of the distance of its nodes.
VectorXd near(const Problem& problem, const State& state) {
  const Basis& B = *problem.basis;
  VectorXd curve = pack(curve_through(state.X, problem.basis));
  if (!problem.with_order) return curve;
  VectorXd s = VectorXd::Zero(state.X.cols()), order(B.points());
  for (Index i = 1; i < s.size(); ++i)
    s[i] = s[i - 1] + (state.X.col(i) - state.X.col(i - 1)).norm();
  s /= s[s.size() - 1];
  for (Index j = 0, i = 1; j < B.points(); ++j) {
    const double sigma = B.grading.sigma(B.x[j]);
    while (i + 1 < s.size() && s[i] < sigma) ++i;
    const double share = (sigma - s[i - 1]) / (s[i] - s[i - 1]);
    order[j] = (1 - share) * state.beta[i - 1] + share * state.beta[i];
  }
  VectorXd c = B.C.transpose() * order * 2 / B.points();
  c[0] /= 2;
  VectorXd y(problem.unknowns());
  y << curve, c;
  return y;
}

Critical critical_near(const Problem& problem, double reduced_volume, const State& state) {
  const auto found =
      critical_point(problem, target_of(problem, reduced_volume), near(problem, state));
  EXPECT_TRUE(found) << reduced_volume;
  return found.value_or(Critical{});
}

double difference(const char* what, double by_elements, double by_curves) {
  std::printf("  %-12s %.12f by elements, %.12f by curves: %.1e\n", what, by_elements, by_curves,
              by_elements - by_curves);
  std::fflush(stdout);
  return std::abs(by_elements - by_curves);
}

// --- where the symmetry is lost

struct Loss {
  Line line;
  SpecialState state;
  double reduced_volume() const { return volume_of(line, state); }
};

Loss loss_of(const Line& line, const PathState& from) {
  const auto lost =
      of_kind(trace(line, from, with_elements(elements), no_modes), Special::symmetry_loss);
  EXPECT_EQ(lost.size(), 1U);
  return {line, lost.at(0)};
}
Loss uniform_loss(double c0) {
  const Line line = down_to(0.72, bare(-c0), true);
  return loss_of(line, round(line, c0 > 0, elements));
}
// With an area difference, from a state of `near` at V_r larger by 0.003.
Loss loss_with(const model::AreaDifference& ad, const Loss& near) {
  const double v = near.reduced_volume();
  Line line{
      .material = bare(0, ad), .model = Model::SSH, .from = {v + 0.003, 0}, .to = {v - 0.003, 0}};
  line.from.L = line.to.L = line.material.L1;
  line.symmetric = true;
  StationaryState guess = near.state.state;
  guess.moment = -near.line.material.spontaneous_curvature;
  const auto there =
      solve_at(line.material, line.model, {v, line.from.L}, guess, {.symmetric = true});
  EXPECT_TRUE(there);
  const auto begin = follow(line.material, line.model, *there, line.from, with_elements(elements));
  EXPECT_EQ(begin.arrival, Arrival::reached);
  const auto path = with_tangent(line, {symmetric_part(begin.state), 0});
  EXPECT_TRUE(path);
  return loss_of(line, *path);
}

double loss_by_curves(const Loss& of, int cutoff) {
  const double v = of.reduced_volume();
  const Problem problem =
      Problem::of(of.line.material, of.line.model, basis(Symmetry::top_bottom, cutoff, {.a = 0.5}));
  spectral::Branchlet branch(problem, near(problem, of.state.state));
  const auto found = symmetry_loss(branch, v + 2e-3, v + 1e-3);
  EXPECT_TRUE(found);
  return found ? found->reduced_volume : 0;
}
void expect_loss(const Loss& of) {
  const double v = loss_by_curves(of, 60);
  EXPECT_NEAR(loss_by_curves(of, 84), v, 1e-11);
  EXPECT_LT(difference("loss", of.reduced_volume(), v), 1e-9);
}

TEST(SecondWitness, loses_the_symmetry_where_another_spectral_calculation_does) {
  for (const auto& [c0, v] : {std::pair{3., 0.752601896165}, {-2.4, 0.731398942384}}) {
    const Loss of = uniform_loss(c0);
    expect_loss(of);
    EXPECT_NEAR(loss_by_curves(of, 60), v, 2e-12) << c0;
  }
}

// α = 1.4, and the bilayer couple.
TEST(SecondWitness, loses_the_symmetry_with_an_area_difference_where_the_elements_do) {
  for (const double c0 : {3., -2.4}) {
    const Loss curved = uniform_loss(c0);
    const double W2 = diagnose(curved.line.material, curved.state.state).W2;
    for (const double stiffness : {1.4, infinite}) {
      // A little off what has the moment c₀.
      const double first_W2 = std::round(1e4 * (W2 - 4 * c0 / stiffness)) / 1e4;
      std::printf("c0 = %g, stiffness %g, W2 = %.4f\n", c0, stiffness, first_W2);
      const Loss of = loss_with({stiffness, first_W2}, curved);
      expect_loss(of);
      EXPECT_GT(std::abs(of.reduced_volume() - curved.reduced_volume()), 1e-7);
    }
  }
}

// --- folds, pears

// The branch that leaves where the symmetry is lost.
struct Further {
  Line line;
  Trace trace;
  double volume(double mu) const { return line.at(mu).reduced_volume; }
  // The first point beyond the fold.
  std::vector<TracePoint>::const_iterator beyond() const {
    return std::ranges::find(trace.points, 1, &TracePoint::leg);
  }
};
// Necks below `narrowest` are not followed: with a free order they melt, and the branch goes on for long.
Further branch_from(const Loss& loss, double narrowest = 0.02, int most_steps = 60) {
  Line line = loss.line;
  line.symmetric = false;
  const Numerics numerics = with_elements(elements);
  const auto start = leaving(line, loss.state, numerics);
  EXPECT_TRUE(start);
  return {line, trace(line, start.value(), numerics,
                      {.largest_m = 0, .narrowest = narrowest, .most_steps = most_steps})};
}

double fold_by_curves(const Further& branch, int cutoff) {
  const TracePoint &before = *(branch.beyond() - 1), &after = *branch.beyond();
  const Problem problem =
      Problem::of(branch.line.material, branch.line.model, basis(Symmetry::none, cutoff));
  const auto found =
      fold(problem, critical_near(problem, branch.volume(before.state.mu), before.state),
           critical_near(problem, branch.volume(after.state.mu), after.state));
  EXPECT_TRUE(found);
  return found ? found->reduced_volume : 0;
}
void expect_fold(const Further& branch) {
  const auto folds = of_kind(branch.trace, Special::fold);
  ASSERT_FALSE(folds.empty());
  ASSERT_NE(branch.beyond(), branch.trace.points.end());
  const double v = fold_by_curves(branch, 192);
  EXPECT_NEAR(fold_by_curves(branch, 240), v, 2e-10);
  EXPECT_LT(difference("fold", branch.volume(folds[0].state.mu), v), 1e-9);
}

TEST(SecondWitness, has_the_folds_of_pears_and_stomatocytes) {
  for (const double c0 : {3., -2.4}) expect_fold(branch_from(uniform_loss(c0)));
}

// SBEH with H₀ = −3, L = 0.001.
Loss loss_of_ordered_prolates() {
  Material material = paper_material(0.001);
  material.spontaneous_curvature = -3;
  Line line{.material = material, .model = Model::SBEH, .from = {0.98, 0.001}, .to = {0.7, 0.001}};
  line.symmetric = true;
  return loss_of(line, round(line, true, elements));
}

// ∂(normal displacement) and ∂(order at fixed s) by the unknowns of a curve without grading, where z is moved so that
// translations along the axis count nothing.
MatrixXd mass_of(const Problem& problem, const VectorXd& y) {
  const Basis& B = *problem.basis;
  const Index N = B.points(), n = B.modes(), c = problem.order_modes();
  const spectral::Angles at = angles(curve_of(problem, y));
  const VectorXd sine = at.psi.array().sin(), cosine = at.psi.array().cos();
  MatrixXd integral = MatrixXd::Zero(N, N);  // of odd functions, up to a constant
  for (Index m = 1; m < N; ++m)
    integral -= (double(m) * pi * B.x.array()).cos().matrix()
              * (double(m) * pi * B.x.array()).sin().matrix().transpose() * 2
              / (double(N) * double(m) * pi);
  MatrixXd dr = MatrixXd::Zero(N, y.size()), dz = dr;
  dr.col(0) = at.r, dz.col(0) = -integral * sine;
  dr.middleCols(1, n) = y[0] * radius_jacobian(B, at);
  dz.middleCols(1, n) = -y[0] * integral * (cosine.asDiagonal() * B.S);
  const MatrixXd u = sine.asDiagonal() * dr + cosine.asDiagonal() * dz,
                 along = cosine.asDiagonal() * dr - sine.asDiagonal() * dz;
  const VectorXd slope =
      problem.with_order ? VectorXd(B.dC * order_of(problem, y) / y[0]) : VectorXd::Zero(N);
  MatrixXd b = -(slope.asDiagonal() * along);
  if (c > 0) b.rightCols(c) += B.C;
  const VectorXd dS = 2 * pi * y[0] * y[0] * B.odd.array() * at.r.array();
  const VectorXd shift = slope.cwiseProduct(sine);  // what a translation makes of the order
  const VectorXd mixed =
      u.transpose() * dS.cwiseProduct(cosine) + b.transpose() * dS.cwiseProduct(shift);
  const double square = dS.dot(cosine.cwiseAbs2() + shift.cwiseAbs2());
  return u.transpose() * dS.asDiagonal() * u + b.transpose() * dS.asDiagonal() * b
       - mixed * mixed.transpose() / square;
}
double lowest_eigenvalue(const Problem& problem, const Critical& state) {
  const auto e = expand(problem, state.y);
  const model::TangentSplit split(e->jacobian.transpose());
  const Index free = state.y.size() - problem.constraints();
  const MatrixXd H = split.rotated(hessian(problem, state.y, state.multipliers)),
                 M = split.rotated(mass_of(problem, state.y));
  return Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd>(H.bottomRightCorner(free, free),
                                                            M.bottomRightCorner(free, free),
                                                            Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

// A pear by Newton's method from the elements' state, minimum or saddle, and its lowest mode of m = 0.
void expect_pear(const Further& branch, const PathState& s, int falls) {
  const Material& material = branch.line.material;
  const Model model = branch.line.model;
  const double v = branch.volume(s.mu);
  const Problem problem = Problem::of(material, model, basis(Symmetry::none, 192));
  const Critical found = critical_near(problem, v, s);
  const double gaussian =
      has_free_order(model) ? 0 : 4 * pi * material.kappa_gauss(model::full_order);
  std::printf("pear at V_r = %.6f: last coefficient %.1e, order %.4f to %.4f\n", v,
              found.y.tail(3).cwiseAbs().maxCoeff(), s.beta.minCoeff(), s.beta.maxCoeff());
  EXPECT_LT(difference("energy", energy_of(material, s).total(), found.energy + gaussian), 1e-8);
  EXPECT_LT(difference("pressure", s.pressure, -found.multipliers[1]),
            1e-7 * std::max(1., std::abs(s.pressure)));
  EXPECT_EQ(found.negative_directions, falls);
  EXPECT_EQ(negative_directions(material, model, s), falls);
  const auto modes = lowest_modes(second_variation(material, model, s), 0, 1);
  ASSERT_TRUE(modes && !modes->modes.empty());
  const double lowest = lowest_eigenvalue(problem, found);
  EXPECT_LT(difference("eigenvalue", modes->modes[0].eigenvalue, lowest), 2e-6 * std::abs(lowest));
}

TEST(SecondWitness, has_the_pears_on_both_legs_and_their_lowest_eigenvalues) {
  const Further branch = branch_from(uniform_loss(3));
  expect_pear(branch, (branch.beyond() - 2)->state, 1);
  expect_pear(branch, (branch.beyond() + 1)->state, 0);
}

TEST(SecondWitness, has_the_ordered_pears) {
  const Loss lost = loss_of_ordered_prolates();
  expect_loss(lost);
  const Further branch = branch_from(lost, 0.1, 8);
  for (const std::size_t k : {3, 6}) expect_pear(branch, branch.trace.points.at(k).state, 1);
}

// --- single states

void expect_same(const Material& material, double v, const StationaryState& s,
                 const Critical& found) {
  EXPECT_LT(difference("energy", energy_of(material, s).total(), found.energy),
            1e-9 * std::abs(found.energy));
  EXPECT_LT(difference("pressure", s.pressure, -found.multipliers[1]), 1e-7) << v;
  EXPECT_LT(difference("tension", s.tension, found.multipliers[0]), 1e-7) << v;
}
void expect_same(const Material& material, const StationaryState& s,
                 const std::optional<EnergyMinimum>& found) {
  ASSERT_TRUE(found);
  EXPECT_LT(difference("energy", energy_of(material, s).total(), found->energy),
            1e-9 * std::abs(found->energy));
  EXPECT_LT(difference("pressure", s.pressure, found->pressure), 1e-7);
  EXPECT_LT(difference("tension", s.tension, found->tension), 1e-7);
  EXPECT_LT(difference("moment", s.moment, found->moment), 1e-7);
}

BranchState uniform_state(Branch branch, const Material& material, double v) {
  const auto ssh = SshBranch(branch, material, with_elements(elements)).at(v);
  EXPECT_TRUE(ssh && ssh->arrival == Arrival::reached);
  return ssh.value().state;
}
BranchState ordered_state(Branch branch, const Material& material, double v) {
  const auto found =
      solve_at(material, Model::SBEH, {v, material.L1}, uniform_state(branch, material, v),
               {.most_iterations = 30, .symmetric = is_symmetric(branch)});
  EXPECT_TRUE(found);
  return found.value();
}

TEST(SecondWitness, has_the_shapes_with_H0_and_with_an_area_difference) {
  Material curved = paper_material(0.05), strained = curved, stiff = curved;
  curved.spontaneous_curvature = -1;
  strained.area_difference = {0.14, -8 * pi * 1.05};
  for (const Branch branch : {Branch::oblate, Branch::prolate}) {
    // Of the classical shapes −8π times 1.0342 and 1.1273.
    stiff.area_difference = {infinite, -8 * pi * (branch == Branch::oblate ? 1.036 : 1.13)};
    for (const Material& material : {curved, strained, stiff}) {
      std::printf("%s\n", name(branch));
      expect_same(material, uniform_state(branch, material, 0.8),
                  minimise_energy(material, Model::SSH, 0.8, branch));
    }
  }
  Material cup = paper_material(0.05);
  cup.spontaneous_curvature = 0.4;
  expect_same(cup, uniform_state(Branch::stomatocyte, cup, 0.6),
              minimise_energy(cup, Model::SSH, 0.6, Branch::stomatocyte));
}

TEST(SecondWitness, has_the_flexoelectric_shapes) {
  Material material = paper_material(0.05);
  material.flexoelectric = model::Polynomial({0, -0.1});
  for (const Branch branch : {Branch::oblate, Branch::prolate})
    expect_same(material, ordered_state(branch, material, 0.8),
                minimise_energy(material, Model::SBEH, 0.8, branch));
}

TEST(SecondWitness, has_the_shapes_whose_lipids_have_other_areas) {
  Material material = paper_material(0.05);
  material.lipid_density = model::Polynomial({1 / 1.3, 1.2 * (1 - 1 / 1.3), 0.2});
  for (const Branch branch : {Branch::oblate, Branch::prolate})
    expect_same(material, ordered_state(branch, material, 0.8),
                minimise_energy(material, Model::SBEH, 0.8, branch));
}

// Two phases: a rich cap, at rest after a flow.
TEST(SecondWitness, has_the_two_phases_of_a_conserved_order) {
  State start = ordered_spheroid(0.9, 48);
  for (Index i = 0; i < start.beta.size(); ++i)
    start.beta[i] = 0.35 + 0.25 * std::tanh((start.X(1, i) - 0.3) / 0.2);
  const double mean = diagnose({}, start).order_mean;
  const Material material = model::test::two_phases(0.02, 6, mean, model::OrderDynamics::conserved);
  const FlowResult run = run_flow(material, Model::SBEH, start, target_of(0.9), {},
                                  {.end_time = 400, .output_times = {}});
  ASSERT_EQ(run.stop, FlowStop::at_rest);
  const StationaryState guess =
      redistribute(guess_from(material, Model::SBEH, run.state), Numerics{}.grading, elements);
  const NewtonResult rest = solve_stationary(material, Model::SBEH, target_of(0.9), guess);
  ASSERT_EQ(rest.status, NewtonStatus::converged);
  const Problem problem = Problem::of(material, Model::SBEH, basis(Symmetry::none, 128));
  const Critical found = critical_near(problem, 0.9, rest.state);
  std::printf("last coefficient %.1e\n", found.y.tail(3).cwiseAbs().maxCoeff());
  expect_same(material, 0.9, rest.state, found);
  EXPECT_LT(difference("mu", rest.state.chemical_potential, -found.multipliers[3]), 1e-7);
  EXPECT_EQ(found.negative_directions, 0);
}

}  // namespace
}  // namespace sbeh::axisym::test
