// What old factors do to the history of a run.
#include "surface3d/lagged_solver.h"

#include "meshing/shapes.h"
#include "meshing/spherical_harmonics.h"
#include "tests/surface3d/cases.h"

namespace sbeh::surface3d {
namespace {

using namespace test;

// Energies after equal steps.
std::vector<double> history(const Surface& s, Scheme scheme, Factorisation factorisation,
                            double solver_tolerance, double time_step = 2e-3) {
  Numerics numerics = numerics_of(scheme, factorisation, solver_tolerance);
  numerics.tolerance = 0.1;
  numerics.first_step = numerics.largest_step = time_step;
  std::vector<double> energies;
  const FlowResult end =
      run_flow(paper_material(0.05), Model::SSH, s.moment(), numerics,
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
  const double default_tolerance = Numerics().solver_tolerance;
  const std::vector<meshing::Harmonic> modes{{5, 3, 0.3}};
  const Surface s = surface_of(meshing::harmonic_sphere(modes, {.triangles = 80}));
  for (const Scheme scheme : {Scheme::monolithic, Scheme::split}) {
    const auto exact = [&](double time_step) {
      return history(s, scheme, Factorisation::every_step, default_tolerance, time_step);
    };
    const auto lagged = [&](double tolerance) {
      return history(s, scheme, Factorisation::lagged, tolerance);
    };
    const auto reference = exact(2e-3);
    EXPECT_LT(largest_difference(lagged(1e-10), reference), 1e-8) << name(scheme);
    if (scheme == Scheme::monolithic) continue;
    const double error_in_time = std::abs(exact(1e-3).back() - reference.back());
    const double default_error = largest_difference(lagged(default_tolerance), reference);
    std::printf("error of the energy in time %.1e, by the default tolerance %.1e\n", error_in_time,
                default_error);
    EXPECT_LT(default_error, 0.1 * error_in_time);
  }
}

}  // namespace
}  // namespace sbeh::surface3d
