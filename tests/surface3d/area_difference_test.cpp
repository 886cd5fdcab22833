// Membranes whose leaflets have an area difference, in 3D: their states against the axisymmetric solver, and by all
// integrators.
#include "axisym/diagnostics.h"
#include "axisym/flow.h"
#include "axisym/modes/eigenmodes.h"
#include "axisym/modes/growth_rates.h"
#include "axisym/start_shapes.h"
#include "surface3d/stationary/path.h"
#include "surface3d/variational/growth_rates.h"
#include "tests/surface3d/stationary/places.h"

#include <algorithm>
#include <limits>

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr double infinite = std::numeric_limits<double>::infinity();
const Target target = ordered_oblate.target();

Material with_areas(double stiffness, double W2) {
  Material material = paper_material(0.05);
  material.area_difference = {stiffness, W2};
  return material;
}

// A prolate with another spontaneous curvature, at rest.
axisym::StationaryState curved(Model model, double H0) {
  const axisym::BranchState free = with_axis({model, Branch::prolate, 0.8, 0.05});
  Material material = paper_material(0.05);
  material.spontaneous_curvature = H0;
  const axisym::NewtonResult found =
      axisym::solve_stationary(material, model, target, axisym::guess_from(material, model, free));
  EXPECT_EQ(found.status, axisym::NewtonStatus::converged);
  return found.state;
}

// A prolate whose leaflets want another W₂ than its own, at rest; `shift`: by how much, of a couple the H₀ whose W₂ it has.
struct Strained {
  Material material;
  axisym::StationaryState state;
  double energy;
};
Strained strained(Model model, double stiffness, double shift) {
  const bool is_couple = stiffness == infinite;
  const axisym::BranchState free{curved(model, is_couple ? shift : 0), {0.8, 0.05}};
  const double W2 = axisym::diagnose({}, free).W2;
  axisym::Line line{.material = with_areas(stiffness, W2 + (is_couple ? 0 : shift)),
                    .model = model,
                    .from = free.at,
                    .to = free.at,
                    .first_H0 = is_couple ? shift : 0,
                    .first_W2 = W2,
                    .symmetric = true};
  axisym::Numerics numerics;
  numerics.elements = 96;
  const axisym::FollowResult found = axisym::follow(line, free, numerics);
  EXPECT_EQ(found.arrival, axisym::Arrival::reached);
  const axisym::StationaryState& state = found.state;
  return {line.material, state, axisym::diagnose(line.material, state).energy.total()};
}

// With the area and the volume of the target.
Surface placed(const axisym::State& profile, int triangles) {
  Surface s = revolved(profile, triangles);
  EXPECT_TRUE(correct_area_volume(*s.mesh, s.state.X, target.area, target.volume));
  return s;
}

struct Found {
  Surface start;
  std::unique_ptr<NewtonSystem> system;
  NewtonResult result;
};
Found found_by_newton(const Material& material, Model model, const Surface& start) {
  auto system = std::make_unique<NewtonSystem>(*start.mesh, material, model);
  NewtonResult result =
      solve_stationary(*system, target, guess_from(*start.mesh, material, model, start.state));
  EXPECT_EQ(result.status, NewtonStatus::converged);
  EXPECT_TRUE(system->linearise(result.state, result.normals));
  return {start, std::move(system), std::move(result)};
}

TEST(AreaDifference3d, has_the_states_and_modes_of_the_axisymmetric_solver) {
  for (const Model model : {Model::SBEH, Model::SSH})
    for (const double stiffness : {0.5, infinite}) {
      const Strained exact = strained(model, stiffness, stiffness == infinite ? 0.3 : 0.5);
      std::vector<double> expected;
      const auto second = axisym::second_variation(exact.material, model, exact.state);
      for (int m = 0; m <= 4; ++m) {
        const auto spectrum = axisym::lowest_modes(second, m, 3);
        ASSERT_TRUE(spectrum);
        for (const axisym::Eigenmode& mode : spectrum->modes)
          for (int copy = 0; copy < (m == 0 ? 1 : 2); ++copy) expected.push_back(mode.eigenvalue);
      }
      std::ranges::sort(expected);
      constexpr int count = 6;
      OrderTable energies(std::string(name(model)) + ": energy", "h"), moments("moment", "h"),
          eigenvalues("largest error of six eigenvalues", "h");
      double error = 0;
      for (const int triangles : {80, 320, 1280}) {
        const Found f = found_by_newton(exact.material, model, revolved(exact.state, triangles));
        const double h = 1 / std::sqrt(f.start.mesh->count());
        error =
            std::abs(energy(exact.material, *f.start.mesh, f.result.state).total() - exact.energy);
        energies.add(h, error);
        moments.add(h, f.result.state.moment - exact.state.moment);
        if (triangles < 320) continue;
        const auto modes = lowest_modes(*f.system, f.result.state, f.result.normals, count);
        ASSERT_TRUE(modes && int(modes->size()) == count);
        EXPECT_EQ(f.result.negative_directions,
                  std::ranges::count_if(expected, [](double value) { return value < 0; }));
        double worst = 0;
        for (std::size_t k = 0; k < count; ++k)
          worst = std::max(worst, std::abs((*modes)[k].eigenvalue / expected[k] - 1));
        eigenvalues.add(h, worst);
      }
      EXPECT_GT(std::abs(exact.state.moment), 0.01);
      energies.print();
      EXPECT_GT(energies.orders().front(), 4);
      EXPECT_LT(error, 2e-8);  // of 1280 triangles, next to the error of 96 elements
      EXPECT_GT(moments.print(), 3.5);
      EXPECT_GT(eigenvalues.print(), 3.5);
    }
}

TEST(AreaDifference3d, has_the_growth_rates_of_the_axisymmetric_solver) {
  const Strained exact = strained(Model::SBEH, 0.5, 0.5);
  const auto second = axisym::second_variation(exact.material, Model::SBEH, exact.state);
  const axisym::LinearFlow flow(second, exact.material, Model::SBEH);
  std::vector<double> expected;
  for (int m = 0; m <= 4; ++m) {
    const auto rates = axisym::growth_rates(flow, m, 3);
    ASSERT_TRUE(rates);
    for (const axisym::GrowthMode& mode : *rates)
      for (int copy = 0; copy < (m == 0 ? 1 : 2); ++copy) expected.push_back(mode.rate);
  }
  std::ranges::sort(expected, std::greater{});
  constexpr int count = 6;
  const Found f = found_by_newton(exact.material, Model::SBEH, revolved(exact.state, 320));
  const auto modes =
      growth_rates(exact.material, *f.start.mesh, Model::SBEH, f.result.state, count);
  ASSERT_TRUE(modes && int(modes->size()) == count);
  for (std::size_t k = 0; k < count; ++k) {
    std::printf("rate %.6f, axisymmetric %.6f\n", (*modes)[k].rate, expected[k]);
    EXPECT_NEAR((*modes)[k].rate / expected[k], 1, 2e-3) << k;
  }
}

TEST(AreaDifference3d, comes_to_rest_there_by_all_integrators) {
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const Surface start = placed(curved(model, 0.5), 80);
    const double W2 = diagnose(*start.mesh, {}, start.state).W2;
    const Material material = with_areas(0.5, W2 - 0.5);
    const double before = diagnose(*start.mesh, material, start.state).energy.total();
    for (const Integrator integrator :
         {Integrator::two_step, Integrator::step_doubling, Integrator::variational})
      for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
        const bool is_usual = scheme == Scheme::split && integrator == Integrator::two_step;
        if (!is_usual
            && (model == Model::SSH
                || (scheme == Scheme::monolithic && integrator != Integrator::two_step)))
          continue;
        Numerics numerics;
        numerics.tolerance = 1e-3;
        numerics.integrator = integrator;
        numerics.scheme = scheme;
        const FlowResult run = run_flow(material, model, start.moment(), numerics,
                                        {.end_time = 60, .output_times = {}});
        EXPECT_EQ(run.stop, FlowStop::at_rest) << name(integrator);
        // From there, since the mesh has moved along itself.
        const Found newton = found_by_newton(material, model, {start.mesh, run.state});
        EXPECT_EQ(newton.result.negative_directions, 0);
        EXPECT_LT((newton.result.state.X - run.state.X).cwiseAbs().maxCoeff(), 3e-3);
        const double rest = diagnose(*start.mesh, material, run.state).energy.total(),
                     U = diagnose(*start.mesh, material, newton.result.state).energy.total();
        std::printf("%s, %s, %s: %d steps, U = %.9f, Newton's %.9f, the start's %.6f\n",
                    name(model), name(integrator), name(scheme), run.steps, rest, U, before);
        EXPECT_LT(rest, before);
        EXPECT_NEAR(rest, U, 1e-5) << name(integrator);
      }
  }
}

TEST(AreaDifference3d, evolves_as_the_axisymmetric_solver_has_it) {
  for (const double stiffness : {0.5, infinite}) {
    const axisym::State profile = curved(Model::SBEH, 0.6);
    const double shift = stiffness == infinite ? 0 : 0.5;
    const auto material_for = [&](double W2) { return with_areas(stiffness, W2 + shift); };
    constexpr double end = 0.1;
    axisym::Numerics fine;
    fine.tolerance = 1e-6;
    const Material of_profile = material_for(axisym::diagnose({}, profile).W2);
    const auto exact = axisym::run_flow(of_profile, Model::SBEH, profile, target, fine,
                                        {.end_time = end, .output_times = {}});
    for (const int triangles : {80, 320}) {
      const Surface start = placed(profile, triangles);
      Numerics numerics;
      numerics.tolerance = 1e-5;
      const Material material = stiffness == infinite
                                  ? material_for(diagnose(*start.mesh, {}, start.state).W2)
                                  : of_profile;
      const FlowResult run = run_flow(material, Model::SBEH, start.moment(), numerics,
                                      {.end_time = end, .output_times = {}});
      EXPECT_NEAR(run.last.time, end, 1e-12) << describe(run.stop);
      if (stiffness == infinite) {
        EXPECT_NEAR(diagnose(*start.mesh, material, run.state).W2, material.area_difference.W2,
                    1e-4);
      }
      // That of the steps, on either mesh.
      const double error = run.last.energy.total() - exact.last.energy.total();
      std::printf("%d triangles: off in energy by %.1e\n", start.mesh->count(), error);
      EXPECT_LT(std::abs(error), 5e-5) << stiffness;
    }
  }
}

TEST(AreaDifference3d, is_followed_in_its_preferred_W2) {
  const Strained exact = strained(Model::SSH, 0.5, 0);
  const Surface start = revolved(exact.state, 180);
  const double W2 = exact.material.area_difference.W2;
  const Path path(
      *start.mesh, Model::SSH, [&](double mu) { return with_areas(0.5, W2 + 0.4 * mu); },
      [&](double) { return target; });
  auto point = settled(path, guess_from(*start.mesh, path.material(0), Model::SSH, start.state), 0);
  ASSERT_TRUE(point);
  // ∂U/∂W₂⁰ = −c along the branch.
  const auto energy_at = [&](const PathPoint& p) {
    return energy(path.material(p.mu), *start.mesh, p).total();
  };
  double ds = 0.2;
  const auto first = advance(path, *point, ds, 1e-3);
  ASSERT_TRUE(first);
  const auto middle = settled(path, *first, first->mu);
  const auto shifted = [&](double mu) { return energy_at(*settled(path, *first, mu)); };
  constexpr double h = 0.02;
  const double slope = (8 * (shifted(first->mu + h) - shifted(first->mu - h))
                        - (shifted(first->mu + 2 * h) - shifted(first->mu - 2 * h)))
                     / (12 * h);
  ASSERT_TRUE(middle);
  EXPECT_GT(std::abs(middle->moment), 1e-3);
  EXPECT_NEAR(slope / 0.4, -middle->moment, 1e-6);
}

}  // namespace
}  // namespace sbeh::surface3d
