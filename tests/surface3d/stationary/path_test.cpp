// Branches of rest states in 3D: where others leave, folds, and what the energy does along them.
#include "surface3d/stationary/path.h"

#include "axisym/modes/eigenmodes.h"
#include "surface3d/mesh/remesh.h"
#include "surface3d/stationary/symmetry_class.h"
#include "tests/surface3d/stationary/places.h"

#include <functional>

namespace sbeh::surface3d {
namespace {

using namespace test;

// The oblate gives way to m = 2: on either side of its branch the same triaxial states leave, towards smaller volumes.
TEST(PathIn3d, finds_where_the_oblate_branches_and_goes_on_to_what_leaves_it) {
  const Place first{Model::SSH, Branch::oblate, 0.76, 0.05};
  const Material material = paper_material(first.L);
  const auto volume_at = [&](double mu) { return 0.76 - 0.02 * mu; };
  const Surface start = revolved(with_axis(first), 320);
  const Path path(
      *start.mesh, first.model, [&](double) { return paper_material(first.L); },
      [&](double mu) {
        return Target{4 * pi, volume_at(mu) * 4 * pi / 3};
      });
  const auto before = settled(path, guess_from(*start.mesh, material, first.model, start.state), 0);
  ASSERT_TRUE(before);
  double ds = 0.8;
  const auto beyond = advance(path, *before, ds, 0.1);
  ASSERT_TRUE(beyond);
  EXPECT_EQ(before->negative_directions, 2);
  EXPECT_EQ(beyond->negative_directions, 0);
  const auto found = locate_branching(path, *before, *beyond, ds);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->modes.size(), 2u);
  // The axisymmetric solver's eigenvalue of m = 2 is 0 there: those of 320 triangles are some 1e-4 off.
  Place there = first;
  there.reduced_volume = volume_at(found->at.mu);
  const auto modes =
      axisym::lowest_modes(axisym::second_variation(material, there.model, with_axis(there)), 2, 1);
  ASSERT_TRUE(modes);
  EXPECT_NEAR(modes->modes.front().eigenvalue, 0, 5e-4);
  std::vector<double> volumes;
  for (const double amplitude : {0.03, -0.03}) {
    const auto left = switched(path, *found, amplitude);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->negative_directions, 1);
    EXPECT_EQ(path.system->rigid_count(), 6);
    EXPECT_EQ(symmetry_class(*start.mesh, *left), "D2h");
    volumes.push_back(volume_at(left->mu));
    EXPECT_LT(volumes.back(), there.reduced_volume - 1e-3);  // subcritical
  }
  EXPECT_NEAR(volumes[0], volumes[1], 1e-6);  // the mesh does not know the two apart
}

// The stomatocytes' largest volume, by shooting at a tolerance of 1e-16: V_r = 0.66085032652, F/8πκ = 1.9630527849.
TEST(PathIn3d, turns_back_where_the_stomatocytes_end) {
  const Place first{Model::SSH, Branch::stomatocyte, 0.655, 0.05};
  const Material material = paper_material(first.L);
  const auto volume_at = [&](double mu) { return 0.655 + 0.07 * mu; };
  const axisym::BranchState exact = with_axis(first);
  OrderTable volumes("reduced volume of the fold", "h"), energies("energy there", "h");
  for (const int triangles : {720, 2880}) {
    const Surface start = revolved(exact, triangles);
    const Path path(
        *start.mesh, first.model, [&](double) { return paper_material(first.L); },
        [&](double mu) {
          return Target{4 * pi, volume_at(mu) * 4 * pi / 3};
        });
    auto at = settled(path, guess_from(*start.mesh, material, first.model, start.state), 0);
    ASSERT_TRUE(at);
    double ds = 0.05;
    std::optional<PathPoint> next = advance(path, *at, ds, 1e-4);
    for (int steps = 0; steps < 20 && next && next->slope() > 0; ++steps) {
      at = next;
      ds *= 1.5;
      next = advance(path, *at, ds, 1e-4);
    }
    ASSERT_TRUE(next && next->slope() < 0);
    EXPECT_EQ(next->negative_directions, at->negative_directions + 1);
    const PathPoint fold = locate_fold(path, *at, *next, ds);
    EXPECT_LT(std::abs(fold.slope()), 1e-4);
    const Energy e = energy(material, *start.mesh, fold);
    const double reduced = (e.bending - 4 * pi * material.kappa_gauss(model::full_order))
                         / (8 * pi * material.kappa(model::full_order));
    const double h = 1 / std::sqrt(start.mesh->count());
    volumes.add(h, volume_at(fold.mu) - 0.66085032652);
    EXPECT_NEAR(volume_at(fold.mu), 0.66085032652, 5e-4);
    EXPECT_NEAR(reduced, 1.9630527849, triangles == 720 ? 1e-4 : 1e-6);
    energies.add(h, reduced - 1.9630527849);
  }
  // The triangulations are no refinements of each other, so that the order scatters; from 320 to 720 the neck is hardly resolved.
  EXPECT_GT(volumes.print(), 3.5);
  EXPECT_GT(energies.print(), 3.5);
}

// The smooth ordered oblate loses its stability to m = 1 before m = 2 and before its fold: of the two, which lie next to each other,
// the first leaves subcritically, with a little of m = 2 in it; then it is a pass with one negative direction, the order thinned on
// one side of the rim.
TEST(PathIn3d, finds_the_pass_over_which_the_order_thins_on_one_side) {
  const Place first{Model::SBEH, Branch::oblate, 0.65, 0.0765};
  const auto L_at = [&](double mu) { return 0.0765 + 0.0005 * mu; };
  const Surface start = revolved(with_axis(first), 320);
  const Path path(
      *start.mesh, first.model, [&](double mu) { return paper_material(L_at(mu)); },
      [&](double) { return first.target(); });
  const auto before =
      settled(path, guess_from(*start.mesh, path.material(0), first.model, start.state), 0);
  ASSERT_TRUE(before);
  double ds = 0.65;
  const auto beyond = advance(path, *before, ds, 0.1);
  ASSERT_TRUE(beyond);
  EXPECT_EQ(before->negative_directions, 0);
  ASSERT_EQ(beyond->negative_directions, 2);
  const auto found = locate_branching(path, *before, *beyond, ds);
  ASSERT_TRUE(found);
  // By the axisymmetric solver's modes; 320 triangles are 1.6e-4 off, 720 1e-5.
  EXPECT_NEAR(L_at(found->at.mu), 0.0766253, 2.5e-4);
  // Far from it other states have as much of the mode.
  EXPECT_FALSE(switched(path, *found, 0.03));
  auto at = switched(path, *found, 3e-4);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->negative_directions, 1);
  EXPECT_EQ(path.system->rigid_count(), 6);
  ds = 0.02;
  for (int steps = 0; steps < 12 && at->mu > -1; ++steps) {
    const auto next = advance(path, *at, ds, 1e-3);
    ASSERT_TRUE(next);
    at = next;
    ds *= 1.5;
    EXPECT_EQ(at->negative_directions, 1);
  }
  EXPECT_LT(L_at(at->mu), 0.0765);
  EXPECT_EQ(symmetry_class(*start.mesh, *at), "C2v");
  // A pass lies above the minimum that it leads out of.
  const auto oblate = settled(path, *before, at->mu);
  ASSERT_TRUE(oblate);
  EXPECT_EQ(oblate->negative_directions, 0);
  const Material material = path.material(at->mu);
  EXPECT_GT(energy(material, *start.mesh, *at).total(),
            energy(material, *start.mesh, *oblate).total());
  EXPECT_LT(at->beta.minCoeff(), oblate->beta.minCoeff());
}

// The same state within what either mesh makes, pointing the same way along the branch.
TEST(PathIn3d, goes_on_with_other_triangles) {
  const Place first{Model::SBEH, Branch::oblate, 0.7, 0.05};
  const auto L_at = [&](double mu) { return 0.05 + 0.01 * mu; };
  const auto path_on = [&](const Triangulation& mesh) {
    return Path(
        mesh, first.model, [&](double mu) { return paper_material(L_at(mu)); },
        [&](double) { return first.target(); });
  };
  const Surface start = revolved(with_axis(first), 320);
  const Path path = path_on(*start.mesh);
  auto from = settled(path, guess_from(*start.mesh, path.material(0), first.model, start.state), 0);
  ASSERT_TRUE(from);
  const RemeshResult made = remesh(*start.mesh, *from, path.material(0), {.triangles = 640});
  ASSERT_TRUE(made.mesh) << made.refusal;
  const Path other = path_on(*made.mesh);
  for (const double sign : {1., -1.}) {
    auto turned = *from;
    turned.tangent.mu *= sign;
    turned.tangent.tension *= sign;
    turned.tangent.pressure *= sign;
    const auto there = on_other_triangles(other, made.state, turned, 0.03);
    ASSERT_TRUE(there);
    EXPECT_EQ(there->mu, from->mu);
    EXPECT_GT(there->tangent.mu * sign, 0);
    // As the lengths of directions, means over the nodes, on both.
    EXPECT_NEAR(there->tangent.mu, turned.tangent.mu, 0.1);
    // 320 triangles are 2e-6 off at V_r = 0.8, and more where the rim is sharper.
    EXPECT_NEAR(energy(path.material(0), *made.mesh, *there).total(),
                energy(path.material(0), *start.mesh, *from).total(), 1e-4);
  }
  EXPECT_FALSE(on_other_triangles(other, made.state, *from, 1e-9));
}

TEST(PathIn3d, predicts_to_third_order_from_two_points_and_to_second_from_one) {
  const Place first{Model::SBEH, Branch::oblate, 0.7, 0.05};
  const Surface start = revolved(with_axis(first), 320);
  const Path path(
      *start.mesh, first.model, [](double mu) { return paper_material(0.05 + 0.01 * mu); },
      [&](double) { return first.target(); });
  const auto from =
      settled(path, guess_from(*start.mesh, path.material(0), first.model, start.state), 0);
  ASSERT_TRUE(from);
  OrderTable one("predicted from one point", "ds"), two("from two points", "ds");
  for (const double ds : {0.8, 0.4, 0.2}) {
    auto next = arc_step(path, *from, ds);
    ASSERT_TRUE(next);
    for (OrderTable* errors : {&one, &two}) {
      if (errors == &two) next->before = std::make_shared<const PathPoint>(*from);
      const auto guess = predicted(path, *next, ds);
      const auto there = arc_step(path, *next, ds);
      ASSERT_TRUE(guess && there);
      errors->add(ds, std::max((guess->X - there->X).cwiseAbs().maxCoeff(),
                               (guess->beta - there->beta).cwiseAbs().maxCoeff()));
    }
  }
  EXPECT_GT(one.print(), 1.8);
  EXPECT_LT(one.orders().back(), 2.4);
  EXPECT_GT(two.print(), 2.7);
}

struct ParameterCase {
  const char* name;
  std::function<Material(double)> material;
  double volume;  // V_r per μ
};
void PrintTo(const ParameterCase& c, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << c.name;
}

Material with_order_squared(double change) {
  Material material = paper_material(0.05);
  auto powers = material.potential.coefficients();
  powers[2] += change;
  material.potential = model::Potential(powers);
  return material;
}

Material with(double Material::*parameter, double value) {
  Material material = paper_material(0.05);
  material.*parameter = value;
  return material;
}

class EnergyAlongPaths : public testing::TestWithParam<ParameterCase> {};
INSTANTIATE_TEST_SUITE_P(
    all, EnergyAlongPaths,
    testing::Values(
        ParameterCase{"reduced_volume", [](double) { return paper_material(0.05); }, 1},
        ParameterCase{"L", [](double mu) { return paper_material(0.05 + mu); }, 0},
        ParameterCase{"H0", [](double mu) { return with(&Material::spontaneous_curvature, mu); },
                      0},
        ParameterCase{"k0",
                      [](double mu) { return with(&Material::residual_stiffness, 0.01 + mu); }, 0},
        ParameterCase{"potential_2", with_order_squared, 0}),
    [](const auto& test) { return test.param.name; });

// dU/dμ = ∂U/∂μ + P dV/dμ; of L, U_EL/L. Normals turn with the surface, which the Lagrangian's derivatives leave out.
TEST_P(EnergyAlongPaths, changes_as_the_parameter_and_the_pressure_say) {
  const ParameterCase& c = GetParam();
  const axisym::BranchState exact = with_axis(ordered_oblate);
  OrderTable table(c.name, "h");
  for (const int triangles : {80, 180, 320}) {
    const Surface start = revolved(exact, triangles);
    const auto volume_at = [&](double mu) { return (0.8 + c.volume * mu) * 4 * pi / 3; };
    const Path path(*start.mesh, Model::SBEH, c.material, [&](double mu) {
      return Target{4 * pi, volume_at(mu)};
    });
    const auto here =
        settled(path, guess_from(*start.mesh, c.material(0), Model::SBEH, start.state), 0);
    ASSERT_TRUE(here);
    const auto energy_at = [&](double mu, const StationaryState& state) {
      return energy(c.material(mu), *start.mesh, state).total();
    };
    const auto settled_at = [&](double mu) {
      const auto there = settled(path, *here, mu);
      EXPECT_TRUE(there);
      return there ? energy_at(mu, *there) : 0;
    };
    // Differences without their term of second order; energies are polynomials of degree 2 in what the material has.
    constexpr double h = 2e-3;
    const double change =
        (8 * (settled_at(h) - settled_at(-h)) - (settled_at(2 * h) - settled_at(-2 * h)))
        / (12 * h);
    const double expected = (energy_at(h, *here) - energy_at(-h, *here)) / (2 * h)
                          + here->pressure * (volume_at(h) - volume_at(-h)) / (2 * h);
    if (c.name == std::string("L")) {
      const Energy parts = energy(c.material(0), *start.mesh, *here);
      EXPECT_NEAR(expected, (parts.distortion + parts.bending) / 0.05, 1e-9);
    }
    table.add(1 / std::sqrt(start.mesh->count()), change - expected);
  }
  EXPECT_GT(table.print(), 3.5);
}

}  // namespace
}  // namespace sbeh::surface3d
