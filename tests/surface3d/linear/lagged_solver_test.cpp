// GMRES with old factors, and what that does to the history of a run.
#include "surface3d/linear/lagged_solver.h"

#include "meshing/shapes.h"
#include "meshing/spherical_harmonics.h"
#include "tests/surface3d/cases.h"

#include <Eigen/LU>

#include <random>

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr int n = 60;

Eigen::MatrixXd random_matrix(unsigned seed) {
  std::mt19937 random(seed);
  return Eigen::MatrixXd::NullaryExpr(
      n, n, [&](Eigen::Index, Eigen::Index) { return double(random() % 2001) / 1000 - 1; });
}

SparseMatrix well_conditioned() {
  const Eigen::MatrixXd A = random_matrix(1) / n + 3 * Eigen::MatrixXd::Identity(n, n);
  return A.sparseView();
}

TEST(LaggedSolver, meets_its_tolerance_in_either_precision) {
  const SparseMatrix old = well_conditioned();
  const SparseMatrix A = (Eigen::MatrixXd(old) + 0.3 * random_matrix(2) / n).sparseView();
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, -1, 2);
  for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10}) {
    LaggedSolver solver(Symmetry::general, tolerance);
    ASSERT_TRUE(solver.factor(old));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    EXPECT_GT(solver.solve(A, A * exact, x), 1);
    // The residual, multiplied by the inverse of a matrix that is 10 % off at most, is the error.
    EXPECT_LT((x - exact).norm(), 1.2 * tolerance * exact.norm()) << tolerance;
  }
}

TEST(LaggedSolver, asks_for_less_than_its_tolerance_where_the_guess_is_better) {
  const SparseMatrix A = well_conditioned();
  const Eigen::VectorXd exact = Eigen::VectorXd::LinSpaced(n, -1, 2);
  LaggedSolver solver(Symmetry::general, 1e-5);
  ASSERT_TRUE(solver.factor(A));
  Eigen::VectorXd x = exact + 1e-7 * Eigen::VectorXd::Ones(n);
  const double before = (x - exact).norm();
  ASSERT_GT(solver.solve(A, A * exact, x), 0);
  EXPECT_LT((x - exact).norm(), 1e-2 * before);
}

TEST(LaggedSolver, needs_fewer_iterations_for_a_matrix_that_is_nearer) {
  const SparseMatrix old = well_conditioned();
  LaggedSolver solver(Symmetry::general, 1e-8);
  ASSERT_TRUE(solver.factor(old));
  int before = 1;
  for (const double change : {0., 0.01, 0.5}) {
    const SparseMatrix A = (Eigen::MatrixXd(old) + change * random_matrix(3) / n).sparseView();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    const int iterations = solver.solve(A, Eigen::VectorXd::Ones(n), x);
    EXPECT_GT(iterations, before) << change;
    before = iterations;
  }
}

TEST(LaggedSolver, leaves_the_guess_alone_when_the_factors_are_too_old) {
  LaggedSolver solver(Symmetry::general, 1e-8);
  ASSERT_TRUE(solver.factor(well_conditioned()));
  Eigen::VectorXd x = Eigen::VectorXd::Ones(n);
  EXPECT_EQ(solver.solve(random_matrix(4).sparseView(), Eigen::VectorXd::Unit(n, 0), x), 0);
  EXPECT_EQ(x, Eigen::VectorXd::Ones(n));
}

// Energies after equal steps.
std::vector<double> history(const Surface& s, Scheme scheme, Factorisation factorisation,
                            double solver_tolerance, double time_step = 2e-3) {
  Numerics numerics;
  numerics.tolerance = 0.1;
  numerics.first_step = numerics.largest_step = time_step;
  numerics.scheme = scheme;
  numerics.factorisation = factorisation;
  numerics.solver_tolerance = solver_tolerance;
  std::vector<double> energies;
  const FlowResult end =
      run_flow(s.mesh, paper_material(0.05), Model::SSH, {.state = s.state}, s.target(), numerics,
               {.end_time = 0.03, .output_times = {}, .stop_at_rest = false},
               [&](const FlowRecord& record, const State&, const StepView&, bool) {
                 energies.push_back(record.energy.total());
                 return true;
               });
  EXPECT_EQ(end.stop, FlowStop::end_time);
  return energies;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(LaggedSolver, follows_the_history_of_the_reference) {
  const std::vector<meshing::Harmonic> modes{{5, 3, 0.3}};
  const Surface s = surface_of(meshing::harmonic_sphere(modes, {.triangles = 80}));
  for (const Scheme scheme : {Scheme::monolithic, Scheme::split}) {
    const auto exact = [&](double time_step) {
      return history(s, scheme, Factorisation::every_step, default_solver_tolerance, time_step);
    };
    const auto lagged = [&](double tolerance) {
      return history(s, scheme, Factorisation::lagged, tolerance);
    };
    const auto reference = exact(2e-3);
    EXPECT_LT(largest_difference(lagged(1e-10), reference), 1e-8) << name(scheme);
    if (scheme == Scheme::monolithic) continue;
    const double error_in_time = std::abs(exact(1e-3).back() - reference.back());
    const double default_error = largest_difference(lagged(default_solver_tolerance), reference);
    std::printf("error of the energy in time %.1e, by the default tolerance %.1e\n", error_in_time,
                default_error);
    EXPECT_LT(default_error, 0.1 * error_in_time);
  }
}

}  // namespace
}  // namespace sbeh::surface3d
