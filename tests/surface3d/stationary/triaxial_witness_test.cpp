// The classical triaxial branch that leaves the oblate at V_r = 0.7497: elements against spherical harmonics, which share
// nothing but the energy per area, both by Newton's method from one reduced volume to the next.
#include "axisym/stationary/ssh_branch.h"
#include "meshing/revolution.h"
#include "surface3d/harmonic/minimiser.h"
#include "surface3d/stationary/stationary.h"
#include "tests/surface3d/cases.h"

namespace sbeh::surface3d {
namespace {

using namespace test;

// Of the oblate with two lobes.
HarmonicState triaxial_harmonics(double reduced_volume, int degree) {
  HarmonicSurface start =
      minimise_harmonics(harmonic_spheroid(reduced_volume, false, degree), reduced_volume, degree)
          .surface;
  start.coefficients[2 * 2 + 2 + 2] += 0.15;
  return stationary_harmonics(start, reduced_volume, degree);
}

// F/8πκ.
double scaled(const Material& material, const Triangulation& mesh, const StationaryState& state) {
  const Energy e = energy(material, mesh, state);
  return (e.bending - 4 * pi * material.kappa_gauss(model::full_order))
       / (8 * pi * material.kappa(model::full_order));
}

// The value of an independent spectral calculation.
TEST(TriaxialWitness, has_the_energy_of_the_literature_at_0_74) {
  double before = 0;
  for (const int degree : {12, 16, 20}) {
    const HarmonicState saddle = triaxial_harmonics(0.74, degree);
    ASSERT_EQ(saddle.stop, HarmonicStop::stationary);
    EXPECT_EQ(saddle.negative_directions, 1);
    const double error = saddle.energy - 1.5996134933;
    std::printf("l <= %d: error %.1e\n", degree, error);
    EXPECT_GT(error, -1e-10);  // that of the value's last digit
    EXPECT_TRUE(before == 0 || error < before / 5);
    before = error;
  }
  EXPECT_LT(before, 1e-8);
}

TEST(TriaxialWitness, follows_the_branch_as_elements_do) {
  constexpr int degree = 20;
  const Material material = paper_material(0.05);
  HarmonicState witness = triaxial_harmonics(0.74, degree);
  axisym::SshBranch oblates(axisym::Branch::oblate, {}, {});
  const meshing::RevolvedMesh oblate =
      meshing::revolved(oblates.at(0.74)->state, {.triangles = 1280});
  const Triangulation mesh(oblate.mesh);
  for (const double v : {0.74, 0.735, 0.73}) {
    witness = stationary_harmonics(witness.surface, v, degree);
    ASSERT_EQ(witness.stop, HarmonicStop::stationary) << v;
    State start{oblate.mesh.nodes, oblate.beta};
    for (auto x : start.X.colwise())
      x = witness.surface.at(coordinates_of(witness.surface, x).omega);
    NewtonSystem system(mesh, material, Model::SSH);
    const NewtonResult found = solve_stationary(system, {4 * pi, v * 4 * pi / 3},
                                                guess_from(mesh, material, Model::SSH, start));
    ASSERT_EQ(found.status, NewtonStatus::converged) << v;
    const double energy = scaled(material, mesh, found.state);
    std::printf("V_r = %.3f: F/8πκ = %.10f, elements %+.1e, %d and %d negative directions\n", v,
                witness.energy, energy - witness.energy, witness.negative_directions,
                found.negative_directions);
    EXPECT_NEAR(energy, witness.energy, 1e-7) << v;
    EXPECT_EQ(found.negative_directions, witness.negative_directions) << v;
    EXPECT_EQ(found.rigid_motions, 6) << v;
  }
}

}  // namespace
}  // namespace sbeh::surface3d
