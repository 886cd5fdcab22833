// Rest states in 3D by Newton's method: those with an axis against the axisymmetric solver, turned, on the way to it, and
// without an axis against an independent calculation.
#include "surface3d/stationary/stationary.h"

#include "axisym/diagnostics.h"
#include "axisym/modes/eigenmodes.h"
#include "surface3d/stationary/eigenmodes.h"
#include "tests/surface3d/stationary/places.h"

#include <algorithm>

namespace sbeh::surface3d {
namespace {

using namespace test;

// A state found from a surface, with the system linearised at it.
struct Found {
  Surface start;
  std::unique_ptr<NewtonSystem> system;
  NewtonResult result;
  double energy(const Material& material) const {
    return surface3d::energy(material, *start.mesh, result.state).total();
  }
};
Found found_from(const Surface& start, const Place& place, const Target& target,
                 const NewtonOptions& options = {}) {
  const Material material = paper_material(place.L);
  auto system = std::make_unique<NewtonSystem>(*start.mesh, material, place.model);
  const StationaryState guess = guess_from(*start.mesh, material, place.model, start.state);
  NewtonResult result = solve_stationary(*system, target, guess, options);
  EXPECT_EQ(result.status, NewtonStatus::converged);
  return {start, std::move(system), std::move(result)};
}
Found found_at(const Place& place, const axisym::State& state, int triangles) {
  return found_from(revolved(state, triangles), place, place.target());
}

struct AxisCase {
  const char* name;
  Place place;
  int negative;      // directions
  double bounds[2];  // of the energy's error at 320 and 1280 triangles
};
void PrintTo(const AxisCase& c, std::ostream* out) { *out << c.name; }  // NOLINT: GoogleTest's name
class StatesWithAnAxis : public testing::TestWithParam<AxisCase> {};
INSTANTIATE_TEST_SUITE_P(
    all, StatesWithAnAxis,
    testing::Values(
        AxisCase{"ordered_oblate", ordered_oblate, 2, {1e-5, 1e-6}},
        AxisCase{"classical_oblate", {Model::SSH, Branch::oblate, 0.8, 0.05}, 2, {1e-5, 1e-6}},
        AxisCase{"ordered_prolate", {Model::SBEH, Branch::prolate, 0.8, 0.05}, 0, {1e-5, 1e-6}},
        AxisCase{"classical_prolate", {Model::SSH, Branch::prolate, 0.8, 0.05}, 0, {1e-5, 1e-6}}),
    [](const auto& test) { return test.param.name; });

TEST_P(StatesWithAnAxis, are_the_same_with_factors_that_are_kept) {
  const AxisCase& c = GetParam();
  const Surface start = revolved(with_axis(c.place), 320);
  const Found each = found_from(start, c.place, c.place.target()),
              kept = found_from(start, c.place, c.place.target(), {.keeps_factors = true});
  const Material material = paper_material(c.place.L);
  EXPECT_NEAR(kept.energy(material), each.energy(material), 1e-10);
  EXPECT_LT((kept.result.state.beta - each.result.state.beta).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_EQ(kept.result.negative_directions, c.negative);
}

TEST_P(StatesWithAnAxis, have_the_energy_of_the_axisymmetric_solver) {
  const AxisCase& c = GetParam();
  const axisym::BranchState exact = with_axis(c.place);
  const Material material = paper_material(c.place.L);
  const double U = axisym::energy(material, exact, exact.H).total();
  OrderTable energies("energy", "h"), tensions("tension", "h"), pressures("pressure", "h");
  std::vector<double> errors;
  for (const int triangles : {80, 320, 1280}) {
    const Found f = found_at(c.place, exact, triangles);
    const double h = 1 / std::sqrt(f.start.mesh->count());
    errors.push_back(std::abs(f.energy(material) - U));
    energies.add(h, errors.back());
    tensions.add(h, f.result.state.tension - exact.tension);
    pressures.add(h, f.result.state.pressure - exact.pressure);
    EXPECT_EQ(f.result.negative_directions, c.negative);
    EXPECT_EQ(f.result.rigid_motions, 5);
  }
  EXPECT_LT(errors[1], c.bounds[0]);
  EXPECT_LT(errors[2], c.bounds[1]);
  EXPECT_GT(energies.print(), 4);
  EXPECT_GT(tensions.print(), 4);
  EXPECT_GT(pressures.print(), 4);
}

TEST_P(StatesWithAnAxis, have_the_modes_of_the_axisymmetric_solver) {
  const AxisCase& c = GetParam();
  const axisym::BranchState exact = with_axis(c.place);
  const axisym::SecondVariation second =
      axisym::second_variation(paper_material(c.place.L), c.place.model, exact);
  std::vector<double> expected;
  for (int m = 0; m <= 6; ++m) {
    const auto spectrum = axisym::lowest_modes(second, m, 3);
    ASSERT_TRUE(spectrum);
    for (const axisym::Eigenmode& mode : spectrum->modes)
      for (int copy = 0; copy < (m == 0 ? 1 : 2); ++copy) expected.push_back(mode.eigenvalue);
  }
  std::ranges::sort(expected);
  constexpr int count = 10;
  OrderTable table("largest error of ten eigenvalues", "h");
  for (const int triangles : {320, 1280}) {
    const Found f = found_at(c.place, exact, triangles);
    const auto modes = lowest_modes(*f.system, f.result.state, f.result.normals, count);
    ASSERT_TRUE(modes && int(modes->size()) == count);
    double error = 0;
    for (std::size_t k = 0; k < count; ++k)
      error = std::max(error, std::abs((*modes)[k].eigenvalue / expected[k] - 1));
    table.add(1 / std::sqrt(f.start.mesh->count()), error);
  }
  EXPECT_GT(table.print(), 3.5);
}

// Newton's method in the strict sense: with normals that stay, the error is squared.
TEST(NewtonIn3d, converges_quadratically) {
  const Surface start = ordered_spheroid(0.8, 320);
  for (const Model model : {Model::SSH, Model::SBEH}) {
    Place place = ordered_oblate;
    place.model = model;
    const Found f =
        found_from(start, place, place.target(), {.tolerance = 1e-9, .renews_normals = false});
    const std::vector<double>& e = f.result.changes;
    ASSERT_GE(e.size(), 4u);
    // The last change of size: that after it is its square times a constant, which the one before tells within a
    // factor of 10, or rounding.
    const std::size_t n = e.size() - 1;
    EXPECT_LT(e[n],
              10 * e[n - 1] * e[n - 1] * std::max(1., e[n - 1] / (e[n - 2] * e[n - 2])) + 1e-11);
    EXPECT_LT(e[n], 1e-3 * e[n - 1]);
  }
}

TEST(NewtonIn3d, of_a_turned_start_gives_the_turned_state) {
  const axisym::BranchState exact = with_axis(ordered_oblate);
  const Surface start = revolved(exact, 320);
  Surface turned = start;
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(0.3, -0.2, 0.4);
  turned.state.X = (R * start.state.X).colwise() + shift;
  const Found a = found_from(start, ordered_oblate, ordered_oblate.target()),
              b = found_from(turned, ordered_oblate, ordered_oblate.target());
  const Material material = paper_material(ordered_oblate.L);
  // Both are converged to 1e-8.
  EXPECT_NEAR(a.energy(material), b.energy(material), 1e-10);
  EXPECT_LT((((R * a.result.state.X).colwise() + shift) - b.result.state.X).cwiseAbs().maxCoeff(),
            1e-7);
  EXPECT_EQ(a.result.negative_directions, b.result.negative_directions);
}

TEST(Deflation, knows_a_state_turned_mirrored_and_on_other_triangles) {
  const axisym::BranchState exact = with_axis(ordered_oblate);
  const Found here = found_at(ordered_oblate, exact, 320),
              finer = found_at(ordered_oblate, exact, 720);
  const StateMarks marks = marks_of(*here.start.mesh, here.result.state);
  StationaryState turned = here.result.state;
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  turned.X = (R * turned.X).colwise() + Eigen::Vector3d(0.3, -0.2, 0.4);
  EXPECT_LT((marks_of(*here.start.mesh, turned) - marks).norm(), 1e-12);
  turned.X.row(1) *= -1;
  EXPECT_LT((marks_of(*here.start.mesh, turned) - marks).norm(), 1e-12);
  EXPECT_LT((marks_of(*finer.start.mesh, finer.result.state) - marks).norm(), same_marks / 10);
  Place other = ordered_oblate;
  other.branch = Branch::prolate;
  const Found prolate = found_at(other, with_axis(other), 320);
  EXPECT_GT((marks_of(*prolate.start.mesh, prolate.result.state) - marks).norm(), 10 * same_marks);
}

// Next to it a Newton step that leads there is turned round.
TEST(Deflation, turns_back_what_leads_to_a_known_state) {
  const axisym::BranchState exact = with_axis(ordered_oblate);
  const Found oblate = found_at(ordered_oblate, exact, 320);
  const Triangulation& mesh = *oblate.start.mesh;
  const KnownStates known{marks_of(mesh, oblate.result.state)};
  const Nodes& normals = oblate.result.normals;
  // With all symmetries of the state, where its marks change in the first order, and without, in the second.
  Increment away;
  away.beta = away.H = away.Lambda = Field::Zero(mesh.nodes);
  const Nodes& X = oblate.result.state.X;
  const auto factor_at = [&](const Field& d, double distance) {
    away.d = d;
    StationaryState near = oblate.result.state;
    displace(away, distance, normals, near);
    Increment back = away;
    back.d *= -distance;
    return deflation(known, mesh, near, normals, back);
  };
  // m'Δ/m is 2/(1 + q) where q goes like the square of the distance, 4/(1 + q) where it goes like its fourth power.
  constexpr double distance = 1e-3;
  EXPECT_NEAR(factor_at(X.row(2).cwiseAbs2(), distance), -1, 0.01);
  EXPECT_NEAR(factor_at(X.row(0).cwiseProduct(X.row(1)), distance), -1. / 3, 0.01);
  EXPECT_EQ(deflation({}, mesh, oblate.result.state, normals, away), 1);
}

TEST(NewtonIn3d, gives_the_pressure_and_the_tension_with_which_the_energy_changes) {
  const axisym::BranchState exact = with_axis(ordered_oblate);
  const Surface start = revolved(exact, 320);
  const Material material = paper_material(ordered_oblate.L);
  const Target target = ordered_oblate.target();
  const Found here = found_from(start, ordered_oblate, target);
  const auto energy_at = [&](double dA, double dV) {
    return found_from(start, ordered_oblate, {target.area + dA, target.volume + dV})
        .energy(material);
  };
  constexpr double h = 1e-3;  // differences are off by h² U‴/6
  const double by_volume = (energy_at(0, h) - energy_at(0, -h)) / (2 * h),
               by_area = (energy_at(h, 0) - energy_at(-h, 0)) / (2 * h);
  // Normals turn with the surface, which derivatives leave out: so much as 320 triangles are off in P and Σ.
  EXPECT_NEAR(by_volume, here.result.state.pressure, 1e-4);
  EXPECT_NEAR(-by_area, here.result.state.tension, 1e-4);
}

// From an independent spectral calculation: the triaxial saddle that leaves the oblate at V_r = 0.7497 towards smaller V_r,
// F/8πκ = 1.5996134933 at V_r = 0.74; its oblate 1.59919810.
TEST(NewtonIn3d, finds_the_classical_triaxial_saddle) {
  const Place place{Model::SSH, Branch::oblate, 0.74, 0.05};
  const Material material = paper_material(place.L);
  const Found oblate = found_at(place, with_axis(place), 1280);
  const auto scaled = [&](const Found& f) {
    const Energy e = energy(material, *f.start.mesh, f.result.state);
    return (e.bending - 4 * pi * material.kappa_gauss(model::full_order))
         / (8 * pi * material.kappa(model::full_order));
  };
  EXPECT_NEAR(scaled(oblate), 1.59919810, 1e-7);
  EXPECT_EQ(oblate.result.negative_directions, 0);
  const auto modes = lowest_modes(*oblate.system, oblate.result.state, oblate.result.normals, 2);
  ASSERT_TRUE(modes);
  Surface start = oblate.start;
  start.state.X =
      oblate.result.state.X + oblate.result.normals * Field(0.2 * modes->front().u).asDiagonal();
  ASSERT_TRUE(
      correct_area_volume(*start.mesh, start.state.X, place.target().area, place.target().volume));
  const Found saddle = found_from(start, place, place.target());
  EXPECT_NEAR(scaled(saddle), 1.5996134933, 1e-6);
  EXPECT_EQ(saddle.result.negative_directions, 1);
  EXPECT_EQ(saddle.result.rigid_motions, 6);
}

}  // namespace
}  // namespace sbeh::surface3d
