// Flows on triangles with the symmetry of their start, and starts that are fitted to their shape.
#include "meshing/measures.h"
#include "surface3d/harmonic/basis.h"
#include "surface3d/harmonic/energy.h"
#include "surface3d/symmetry.h"
#include "tests/surface3d/cases.h"

#include <array>
#include <stdexcept>

namespace sbeh::surface3d {
namespace {

using namespace test;
using meshing::Harmonic, meshing::PointGroup;

constexpr std::array threefold{Harmonic{5, 3, 0.5}};

Surface threefold_start(int triangles) {
  meshing::CurvedMesh mesh = meshing::harmonic_sphere(
      threefold,
      {.triangles = triangles, .grading = 1, .symmetry = PointGroup("D3h"), .fitted = true});
  meshing::scale_to_area(mesh, 4 * pi);
  return surface_of(mesh);
}

FlowMoment with(const Surface& s, const char* kept) {
  FlowMoment moment = s.moment();
  moment.symmetry = {PointGroup("D3h"), PointGroup(kept)};
  return moment;
}

// ½∫H² by the quadrature of products, from the radius alone.
double bending_of_the_shape() {
  HarmonicSurface shape{5, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Identity(),
                        Eigen::VectorXd::Zero(harmonic_count(5))};
  shape.coefficients[5 * 5 + 5 + 3] = threefold[0].amplitude;
  const SphereRule rule = sphere_rule(200);
  const HarmonicBasis basis = harmonic_basis(5, rule.omega);
  const Eigen::VectorXd H = mean_curvature(shape, rule.omega),
                        r = (basis.Y[0] * shape.coefficients).array() + 1,
                        rs = basis.Y[1] * shape.coefficients, rt = basis.Y[2] * shape.coefficients;
  double sum = 0;
  for (Eigen::Index i = 0; i < r.size(); ++i)
    sum += rule.weights[i] * r[i] * std::sqrt(r[i] * r[i] + rs[i] * rs[i] + rt[i] * rt[i]) * H[i]
         * H[i] / 2;
  return sum;
}

double bending_of(const Surface& s) {
  const auto curvature = curvature_of(*s.mesh, s.state.X);
  double sum = 0;
  for_each_point(*s.mesh, s.state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& at, const SurfacePoint& p) {
                   const double H = value_at(on_element(*s.mesh, e, curvature->H), at);
                   sum += p.dS * H * H / 2;
                 });
  return sum;
}

TEST(FittedStart, has_the_energy_of_its_shape_at_the_order_of_the_elements) {
  const double exact = bending_of_the_shape();
  EXPECT_NEAR(exact, 100.2740912, 1e-6);  // an independent spectral calculation's
  OrderTable table("bending energy of 0.5 Y_53", "h");
  double error = 0;
  for (const int triangles : {320, 1280, 5120}) {
    const Surface s = threefold_start(triangles);
    error = bending_of(s) / exact - 1;
    table.add(std::sqrt(20. / s.mesh->count()), error);
  }
  EXPECT_GT(table.print(), 4);
  EXPECT_LT(std::abs(error), 2e-6);
}

// U(0.01) of an independent spectral calculation with the symmetry exact, L = 0.05.
TEST(SymmetricFlow, of_the_sharp_start_has_the_energy_of_a_calculation_without_triangles) {
  OrderTable table("energy of 0.5 Y_53 at t = 0.01", "h");
  double error = 0;
  for (const int triangles : {320, 1280}) {
    const Surface s = threefold_start(triangles);
    Numerics numerics;
    numerics.tolerance = 1e-5;
    const FlowResult run =
        run_flow(paper_material(0.05), Model::SSH, with(s, "D3h"), numerics, {.end_time = 0.01});
    error = run.last.energy.total() / -4.4141382 - 1;
    table.add(std::sqrt(20. / s.mesh->count()), error);
  }
  EXPECT_GT(table.print(), 3);
  EXPECT_LT(std::abs(error), 3e-5);
}

TEST(SymmetricFlow, keeps_its_symmetry_to_rounding) {
  const Surface s = threefold_start(320);
  for (const Model model : {Model::SSH, Model::SBEH}) {
    Numerics numerics;
    numerics.tolerance = 1e-3;
    const FlowMoment start = with(s, "D3h");
    const FlowResult run =
        run_flow(paper_material(0.05), model, start, numerics, {.end_time = 0.05});
    ASSERT_EQ(run.stop, FlowStop::end_time);
    const auto symmetry = symmetry_of(*s.mesh, run.state, start.symmetry.mesh);
    ASSERT_TRUE(symmetry);
    EXPECT_LT(asymmetry(*s.mesh, run.state, *symmetry), 1e-14);
    EXPECT_LT((symmetric_part(*symmetry, run.state).beta - run.state.beta).cwiseAbs().maxCoeff(),
              1e-14);
    EXPECT_NEAR(area(*s.mesh, run.state.X) / start.target.area, 1, 1e-12);
    EXPECT_NEAR(volume(*s.mesh, run.state.X) / start.target.volume, 1, 1e-12);
  }
}

// The points of quadrature have the symmetry of the triangles, and the equations are solved to rounding.
TEST(SymmetricFlow, keeps_its_symmetry_without_being_projected_onto_it) {
  const Surface s = threefold_start(320);
  for (const Model model : {Model::SSH, Model::SBEH}) {
    Numerics numerics;
    numerics.factorisation = Factorisation::every_step;
    numerics.solver_tolerance = 1e-11;
    const FlowResult run =
        run_flow(paper_material(0.05), model, with(s, "C1"), numerics, {.end_time = 1e-4});
    ASSERT_EQ(run.stop, FlowStop::end_time);
    EXPECT_LT(asymmetry(*s.mesh, run.state, *symmetry_of(*s.mesh, run.state, PointGroup("D3h"))),
              1e-13);
  }
}

TEST(SymmetricFlow, keeps_the_part_that_it_is_asked_for_while_another_grows) {
  const Surface s = threefold_start(320);
  State state = s.state;
  constexpr double amplitude = 1e-4;
  const Nodes n = node_normals(*s.mesh, state.X);
  for (int i = 0; i < s.mesh->nodes; ++i) {
    const Eigen::Vector3d d = state.X.col(i).normalized();
    state.X.col(i) += amplitude * meshing::spherical_harmonic(4, 3, d) * n.col(i);
  }
  FlowMoment start = with(s, "C3v");
  start.state = state;
  start.target = area_and_volume(*s.mesh, state.X);
  Numerics numerics;
  const FlowResult run =
      run_flow(paper_material(0.05), Model::SSH, start, numerics, {.end_time = 0.1});
  const auto all = symmetry_of(*s.mesh, run.state, PointGroup("D3h")),
             kept = symmetry_of(*s.mesh, run.state, PointGroup("C3v"));
  ASSERT_TRUE(all && kept);
  EXPECT_LT(asymmetry(*s.mesh, run.state, *kept), 1e-14);
  EXPECT_GT(asymmetry(*s.mesh, run.state, *all), amplitude / 10);
  EXPECT_THROW(run_flow(paper_material(0.05), Model::SSH,
                        {.mesh = s.mesh,
                         .state = state,
                         .target = start.target,
                         .symmetry = {PointGroup("D3h"), PointGroup("D3h")}},
                        numerics, {.end_time = 0.1}),
               std::invalid_argument);
}

TEST(SymmetricFlow, has_new_triangles_with_its_symmetry) {
  const Surface s = threefold_start(320);
  const RemeshResult made =
      remesh(*s.mesh, s.state, paper_material(0.05),
             {.triangles = 640, .largest_energy_change = 1, .symmetry = PointGroup("D3h")});
  ASSERT_TRUE(made.mesh) << made.refusal;
  EXPECT_NEAR(made.mesh->count(), 640, 40);
  const auto symmetry = required_symmetry(*made.mesh, made.state, PointGroup("D3h"));
  EXPECT_LT(symmetry.misfit(made.state.X), 1e-12);
  EXPECT_LT((symmetry.symmetric_part(made.state.beta) - made.state.beta).cwiseAbs().maxCoeff(),
            1e-13);
}

TEST(SymmetricSurface, of_which_a_part_is_left_has_new_triangles_with_that) {
  for (const auto& [mode, order] : {std::pair{Harmonic{2, 2, 0.1}, 8u},
                                    {{2, -2, 0.1}, 8u},
                                    {{4, 4, 0.1}, 16u},
                                    {{3, 1, 0.1}, 4u}}) {
    const PointGroup group("D4h");
    const Surface s =
        surface_of(meshing::sphere({.triangles = 240, .grading = 0, .symmetry = group}));
    State state = s.state;
    for (auto x : state.X.colwise()) x *= 1 + meshing::harmonic_sum({{mode}}, x);
    const PointGroup kept = kept_symmetry(*s.mesh, state, group);
    ASSERT_EQ(kept.operations().size(), order) << mode.l << mode.m;
    const RemeshResult made =
        remesh(*s.mesh, state, paper_material(0.05),
               {.triangles = 400, .largest_energy_change = 1, .symmetry = kept});
    ASSERT_TRUE(made.mesh) << made.refusal;
    EXPECT_LT(required_symmetry(*made.mesh, made.state, kept).misfit(made.state.X), 1e-12);
    EXPECT_TRUE(kept_symmetry(*made.mesh, made.state, kept) == kept);
    for (int i = 0; i < s.mesh->nodes; ++i) state.beta[i] += 1e-3 * i;
    EXPECT_TRUE(kept_symmetry(*s.mesh, state, group).is_trivial());
  }
}

// What has grown beside the symmetry that is kept is not averaged away.
TEST(SymmetricFlow, that_lets_its_symmetry_go_has_new_triangles_without_it) {
  const Surface s = threefold_start(320);
  State state = s.state;
  const Nodes n = node_normals(*s.mesh, state.X);
  for (int i = 0; i < s.mesh->nodes; ++i)
    state.X.col(i) +=
        2e-3 * meshing::spherical_harmonic(3, 0, state.X.col(i).normalized()) * n.col(i);
  const auto unevenness = [](const Triangulation& mesh, const State& at) {  // odd by z → −z
    double sum = 0;
    for_each_point(mesh, at.X, diagnostic_points(),
                   [&](int, const ShapeValues&, const SurfacePoint& p) {
                     sum += p.dS * std::pow(p.x.z(), 3);
                   });
    return sum;
  };
  FlowMoment start = with(s, "C1");
  start.state = state;
  start.target = area_and_volume(*s.mesh, state.X);
  Numerics numerics;
  numerics.remesh = true;
  std::shared_ptr<const Triangulation> mesh;
  const FlowResult run =
      run_flow(paper_material(0.05), Model::SSH, start, numerics, {.end_time = 1e-3},
               [&](const FlowRecord&, const State&, const StepView& view, bool) {
                 mesh = view.mesh;
                 return true;
               });
  ASSERT_NE(mesh->count(), s.mesh->count());  // the start is too sharp for its triangles
  EXPECT_NEAR(unevenness(*mesh, run.state) / unevenness(*s.mesh, state), 1, 0.3);
}

}  // namespace
}  // namespace sbeh::surface3d
