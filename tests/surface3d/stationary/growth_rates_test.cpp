// Modes of the linearised flow in 3D against those of the axisymmetric solver, and against the flow itself.
#include "surface3d/variational/growth_rates.h"

#include "axisym/modes/growth_rates.h"
#include "surface3d/stationary/stationary.h"
#include "surface3d/variational/variational_stepper.h"
#include "tests/surface3d/stationary/places.h"

#include <algorithm>

namespace sbeh::surface3d {
namespace {

using namespace test;

// All dissipations count.
Material with_friction(double L) {
  Material material = paper_material(L);
  material.viscosity = 0.7;
  material.friction_normal = 0.4;
  material.friction_tangential = 0.2;
  material.immobility = 0.6;
  return material;
}

NewtonResult at_rest(const Surface& start, const Place& place, const Material& material) {
  NewtonSystem system(*start.mesh, material, place.model);
  NewtonResult found = solve_stationary(
      system, place.target(), guess_from(*start.mesh, material, place.model, start.state));
  EXPECT_EQ(found.status, NewtonStatus::converged);
  return found;
}

class GrowthRates : public testing::TestWithParam<Model> {};
INSTANTIATE_TEST_SUITE_P(all, GrowthRates, testing::Values(Model::SSH, Model::SBEH));

TEST_P(GrowthRates, are_those_of_the_axisymmetric_solver) {
  const Place place{GetParam(), Branch::oblate, 0.8, 0.05};
  const Material material = with_friction(place.L);
  const axisym::BranchState exact = with_axis(place);
  const auto second = axisym::second_variation(material, place.model, exact);
  const axisym::LinearFlow flow(second, material, place.model);
  std::vector<double> expected;
  for (int m = 0; m <= 6; ++m) {
    const auto modes = axisym::growth_rates(flow, m, 3);
    ASSERT_TRUE(modes);
    for (const axisym::GrowthMode& mode : *modes)
      for (int copy = 0; copy < (m == 0 ? 1 : 2); ++copy) expected.push_back(mode.rate);
  }
  std::ranges::sort(expected, std::greater{});
  ASSERT_GT(expected.front(), 0);  // the oblate leaves along m = 2
  constexpr int count = 8;
  OrderTable table("largest error of eight rates", "h");
  for (const int triangles : {80, 320, 1280}) {
    const Surface start = revolved(exact, triangles);
    const NewtonResult found = at_rest(start, place, material);
    const auto modes = growth_rates(material, *start.mesh, place.model, found.state, count);
    ASSERT_TRUE(modes && int(modes->size()) == count);
    double error = 0;
    for (std::size_t k = 0; k < count; ++k)
      error = std::max(error, std::abs((*modes)[k].rate / expected[k] - 1));
    table.add(1 / std::sqrt(start.mesh->count()), error);
  }
  EXPECT_GT(table.print(), 3.5);
}

// All that resists a hundredth: rates a hundred times as large, among them such as are above 1.
TEST(GrowthModes3d, are_as_much_faster_as_less_resists) {
  const Surface start = revolved(with_axis(ordered_oblate), 80);
  Material material = with_friction(ordered_oblate.L);
  const NewtonResult found = at_rest(start, ordered_oblate, material);
  constexpr int count = 8;
  const auto slow = growth_rates(material, *start.mesh, ordered_oblate.model, found.state, count);
  for (double* resistance : {&material.viscosity, &material.immobility,
                             &material.friction_tangential, &material.friction_normal})
    *resistance /= 100;
  const auto fast = growth_rates(material, *start.mesh, ordered_oblate.model, found.state, count);
  ASSERT_TRUE(slow && fast);
  EXPECT_GT(fast->front().rate, 1);
  // Rigid motions of these triangles are modes but for 3e-3, the square of which the shift sees.
  for (std::size_t k = 0; k < count; ++k)
    EXPECT_NEAR((*fast)[k].rate / (100 * (*slow)[k].rate), 1, 1e-5);
}

// A step of the flow from states displaced along modes, in which each is multiplied by 1/(1 − στ).
TEST(GrowthModes3d, are_how_displaced_states_move) {
  const Material material = with_friction(ordered_oblate.L);
  const Surface start = revolved(with_axis(ordered_oblate), 320);
  const NewtonResult found = at_rest(start, ordered_oblate, material);
  const auto modes = growth_rates(material, *start.mesh, ordered_oblate.model, found.state, 6);
  ASSERT_TRUE(modes);
  const Nodes normals = node_normals(*start.mesh, found.state.X);
  constexpr double tau = 0.05, amplitude = 1e-3;
  VariationalStepper stepper(start.mesh, material, ordered_oblate.model, {});
  // The pair of σ = 0.03 is nearer to the triangles' own errors.
  for (const GrowthMode& mode : {(*modes)[2], (*modes)[4]}) {
    Eigen::Index node = 0;
    mode.u.cwiseAbs().maxCoeff(&node);
    // The velocity there along the normal; that of the state itself is an error of its triangles.
    const auto speed_from = [&](double distance) {
      State displaced = found.state;
      displaced.X += normals * Field(distance * mode.u).asDiagonal();
      displaced.beta += distance * mode.b;
      EXPECT_EQ(stepper.step(displaced, ordered_oblate.target(), tau).fault,
                model::FlowFault::none);
      return stepper.fields().V.col(node).dot(normals.col(node));
    };
    const double speed = (speed_from(amplitude) - speed_from(-amplitude)) / 2,
                 expected = amplitude * mode.u[node] * mode.rate / (1 - mode.rate * tau);
    EXPECT_LT(mode.rate, -0.1);
    EXPECT_NEAR(speed / expected, 1, 0.01);
  }
}

}  // namespace
}  // namespace sbeh::surface3d
