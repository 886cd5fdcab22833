// Minimisation over spherical harmonics without an axis: against the axisymmetric minimiser, which knows the
// energies to 1e-12.
#include "surface3d/harmonic/minimiser.h"

#include "axisym/spectral/minimiser.h"
#include "meshing/shapes.h"
#include "surface3d/harmonic/energy.h"
#include "tests/surface3d/cases.h"

#include <Eigen/Geometry>

#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;
using axisym::Branch;

axisym::ClassicalShape exact_shape(Branch branch, double reduced_volume) {
  return axisym::minimise_classical(branch, reduced_volume).value();
}

HarmonicSurface spheroid(Branch branch, double reduced_volume, int degree = 16) {
  return harmonic_spheroid(reduced_volume, branch == Branch::prolate, degree);
}

// Σ a_lm Y_lm added along T ω.
HarmonicSurface perturbed(HarmonicSurface surface, std::span<const meshing::Harmonic> modes) {
  for (const auto& [l, m, amplitude] : modes)
    surface.coefficients[Eigen::Index(l) * l + l + m] += amplitude;
  return surface;
}
const std::vector<meshing::Harmonic> lobes{{2, 2, 0.1}, {3, 3, 0.1}, {4, -3, 0.05}, {3, 1, 0.05}};

void expect_shape(const HarmonicState& shape, const axisym::ClassicalShape& exact,
                  double tolerance) {
  const Axis axis = axis_of(shape.surface);
  std::printf(
      "%s: F/(8πκ) = %.12f, error %.1e, of P %.1e, of Σ %.1e; %d negative, deviation from its axis "
      "%.1e\n",
      describe(shape.stop).c_str(), shape.energy, shape.energy / exact.energy - 1,
      shape.pressure / exact.pressure - 1, shape.tension / exact.tension - 1,
      shape.negative_directions, axis.deviation);
  ASSERT_EQ(shape.stop, HarmonicStop::stationary);
  EXPECT_NEAR(shape.energy / exact.energy, 1, tolerance);
  // First-order in the error of the shape, where the energy is second-order.
  EXPECT_NEAR(shape.pressure / exact.pressure, 1, std::sqrt(tolerance));
  EXPECT_NEAR(shape.tension / exact.tension, 1, std::sqrt(tolerance));
  const auto at = HarmonicEnergy(shape.surface).expand(shape.surface.coefficients);
  EXPECT_NEAR(at->measures[1] / (4 * pi), 1, 1e-12);
  EXPECT_NEAR(model::reduced_volume(at->measures[1], at->measures[2]), exact.reduced_volume, 1e-12);
  EXPECT_LT(axis.deviation, std::sqrt(tolerance));
}

// ---- against one dimension --------------------------------------------------------------------------

TEST(Harmonics, converge_geometrically_to_the_axisymmetric_energies) {
  struct Row {
    Branch branch;
    double reduced_volume;
    std::vector<int> degrees;
    double last;  // error of the last
  };
  const Row rows[] = {{Branch::oblate, 0.8, {8, 12, 16, 20}, 1e-9},
                      {Branch::prolate, 0.8, {8, 12, 16, 20}, 1e-9},
                      {Branch::oblate, 0.65, {8, 12, 16, 20}, 3e-7},
                      {Branch::prolate, 0.65, {8, 12, 16, 20}, 3e-7}};
  for (const Row& row : rows) {
    const auto exact = exact_shape(row.branch, row.reduced_volume);
    std::printf("%-8s %.2f", sbeh::name(row.branch), row.reduced_volume);
    double before = 0;
    for (const int degree : row.degrees) {
      const HarmonicState shape = minimise_harmonics(
          spheroid(row.branch, row.reduced_volume, degree), row.reduced_volume, degree);
      ASSERT_EQ(shape.stop, HarmonicStop::stationary);
      const double error = shape.energy / exact.energy - 1;
      std::printf("  l <= %d: %.1e", degree, error);
      EXPECT_GT(error, -1e-11);  // a minimum over fewer surfaces is higher
      EXPECT_TRUE(before == 0 || error < before / 5);
      before = error;
    }
    std::printf("\n");
    EXPECT_LT(before, row.last);
  }
}

TEST(Harmonics, of_the_oblate_have_the_energy_of_newtons_method) {
  const HarmonicState shape = minimise_harmonics(spheroid(Branch::oblate, 0.8), 0.8);
  const Material material = paper_material(0.05);
  const double beta = model::full_order, kappa = material.kappa(beta);
  const double U = 8 * pi * kappa * shape.energy + 4 * pi * material.kappa_gauss(beta)
                 + 4 * pi * material.potential.value(beta);
  std::printf("U = %.10f\n", U);
  EXPECT_NEAR(U, -10.172379928, 1e-7);
}

TEST(Harmonics, count_the_two_directions_in_which_the_oblate_falls) {
  EXPECT_EQ(minimise_harmonics(spheroid(Branch::oblate, 0.8), 0.8).negative_directions, 2);
  EXPECT_EQ(minimise_harmonics(spheroid(Branch::oblate, 0.65), 0.65).negative_directions, 0);
  EXPECT_EQ(minimise_harmonics(spheroid(Branch::prolate, 0.8), 0.8).negative_directions, 0);
}

// ---- other starts -----------------------------------------------------------------------------------

TEST(PerturbedStart, without_any_symmetry_returns_to_the_minimum) {
  for (const auto& [branch, v] : {std::pair{Branch::oblate, 0.65}, {Branch::prolate, 0.8}}) {
    const HarmonicSurface start = perturbed(spheroid(branch, v), lobes);
    EXPECT_GT(axis_of(start).deviation, 0.05);
    const HarmonicState shape = minimise_harmonics(start, v);
    expect_shape(shape, exact_shape(branch, v), 1e-5);
    EXPECT_EQ(shape.negative_directions, 0);
  }
}

TEST(TiltedStart, has_the_same_energy_as_an_upright_one) {
  HarmonicSurface start = spheroid(Branch::oblate, 0.65);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  start.ellipsoid = turn * start.ellipsoid * turn.transpose();
  start.centre << 0.3, -0.2, 0.1;
  const HarmonicState shape = minimise_harmonics(start, 0.65);
  expect_shape(shape, exact_shape(Branch::oblate, 0.65), 1e-5);
  const HarmonicState upright = minimise_harmonics(spheroid(Branch::oblate, 0.65), 0.65);
  EXPECT_NEAR(shape.energy, upright.energy, 1e-6);
}

TEST(MeshedStart, of_a_P3_surface_has_its_shape) {
  const meshing::CurvedMesh mesh = meshing::ellipsoid(0.8, false, {.triangles = 320});
  const HarmonicSurface surface = fit_harmonics(Triangulation(mesh), mesh.nodes, 12);
  double largest = 0;
  for (const auto x : mesh.nodes.colwise()) {
    const auto [omega, u] = coordinates_of(surface, x);
    largest = std::max(largest, (surface.at(omega) - x).norm());
  }
  std::printf("largest distance of a node %.1e\n", largest);
  EXPECT_LT(largest, 1e-3);
  expect_shape(minimise_harmonics(surface, 0.8), exact_shape(Branch::oblate, 0.8), 1e-7);
}

}  // namespace
}  // namespace sbeh::surface3d
