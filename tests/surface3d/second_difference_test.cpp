// Eigenvalues of the second variation by cos mφ against second differences of the 3D energy.
#include "axisym/modes/eigenmodes.h"
#include "meshing/revolution.h"
#include "surface3d/diagnostics.h"
#include "tests/axisym/cases.h"
#include "tests/surface3d/cases.h"

#include <cmath>

namespace sbeh::surface3d {
namespace {

using namespace test;
using axisym::Eigenmode;
using axisym::StationaryState;

// A field of the meridian at the nodes of the revolved mesh.
Field on_surface(const StationaryState& state, const axisym::Field& f, const Nodes& X) {
  const meshing::ProfileCurve curve({.X = state.X, .beta = f});
  Field values(X.cols());
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    values[i] = curve.beta_at(curve.nearest({X.col(i).head<2>().norm(), X(2, i)}));
  return values;
}

// A revolved state and a direction away from it: u cos mφ along the normals of the meridian's nodes, b cos mφ.
struct Direction {
  Triangulation mesh;
  State state;
  Nodes motion;
  Field order;
};

Direction direction_of(const StationaryState& state, const Eigenmode& mode,
                       const meshing::Resolution& resolution) {
  meshing::RevolvedMesh revolved = meshing::revolved(state, resolution);
  const Nodes& X = revolved.mesh.nodes;
  const axisym::Nodes n = axisym::node_normals(state.X);
  const Field r = on_surface(state, n.row(0).transpose().cwiseProduct(mode.u), X),
              z = on_surface(state, n.row(1).transpose().cwiseProduct(mode.u), X),
              b = on_surface(state, mode.b, X);
  Direction d{
      Triangulation(revolved.mesh), {X, revolved.beta}, Nodes(3, X.cols()), Field(X.cols())};
  for (Eigen::Index i = 0; i < X.cols(); ++i) {
    const double phi = std::atan2(X(1, i), X(0, i)), wave = std::cos(mode.m * phi);
    d.motion.col(i) = wave * Eigen::Vector3d(r[i] * std::cos(phi), r[i] * std::sin(phi), z[i]);
    d.order[i] = wave * b[i];
  }
  return d;
}

// ∫((d·ν)² + b²) dS.
double square_of(const Direction& d) {
  double sum = 0;
  for_each_point(d.mesh, d.state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& p) {
                   const double u = value_at(on_element(d.mesh, e, d.motion), s).dot(p.nu()),
                                b = value_at(on_element(d.mesh, e, d.order), s);
                   sum += (u * u + b * b) * p.dS;
                 });
  return sum;
}

// U + ΣA − PV of the 3D solver.
double lagrangian(const Material& material, const StationaryState& of, const Direction& d,
                  double epsilon) {
  const State moved{d.state.X + epsilon * d.motion, d.state.beta + epsilon * d.order};
  const auto curvature = curvature_of(d.mesh, moved.X);
  EXPECT_TRUE(curvature);
  const Target size = area_and_volume(d.mesh, moved.X);
  return energy(d.mesh, material, moved, *curvature).total() + of.tension * size.area
       - of.pressure * size.volume;
}

// By differences of fourth order.
double second_difference(const Material& material, const StationaryState& of, const Direction& d,
                         double epsilon) {
  const auto at = [&](int k) { return lagrangian(material, of, d, k * epsilon); };
  return (16 * (at(-1) + at(1)) - at(-2) - at(2) - 30 * at(0)) / (12 * epsilon * epsilon);
}

// The area of the surface, its normals, curvature and order are interpolated: fourth order, as the energy.
void expect_eigenvalues(Model model, axisym::PlanePoint at, double epsilon = 4e-3,
                        double grading = 0) {
  const Material material = paper_material(at.L);
  const StationaryState state = axisym::test::oblate(model, at, 96);
  const auto second = axisym::second_variation(material, model, state);
  for (const int m : {1, 2, 3}) {
    const auto spectrum = axisym::lowest_modes(second, m, 1);
    ASSERT_TRUE(spectrum);
    const Eigenmode& mode = spectrum->modes.front();
    OrderTable table(std::string(sbeh::name(model)) + ", m = " + std::to_string(m), "h");
    for (const int triangles : {320, 1280, 5120}) {
      const Direction d = direction_of(state, mode, {.triangles = triangles, .grading = grading});
      const double eigenvalue = second_difference(material, state, d, epsilon) / square_of(d);
      table.add(std::sqrt(20. / triangles), eigenvalue - mode.eigenvalue);
    }
    EXPECT_GT(table.print(), 3);
  }
}

TEST(SecondDifference, of_the_SSH_oblate_is_its_eigenvalue) {
  expect_eigenvalues(Model::SSH, {0.8, 0.05});
}
TEST(SecondDifference, of_the_ordered_oblate_is_its_eigenvalue) {
  expect_eigenvalues(Model::SBEH, {0.8, 0.05});
}

// Where m = 1 and m = 2 are negative, next to the fold, triangles being smaller at the rim; and where m = 2 is positive again.
TEST(SecondDifference, next_to_a_fold_is_the_eigenvalue) {
  expect_eigenvalues(Model::SBEH, {0.6, 0.07}, 1e-3, 1);
}
TEST(SecondDifference, of_the_oblate_that_is_a_minimum_again_is_its_eigenvalue) {
  expect_eigenvalues(Model::SBEH, {0.8, 0.122}, 1e-3);
}

}  // namespace
}  // namespace sbeh::surface3d
