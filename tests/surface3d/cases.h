// Meshes, start shapes and equal-step runs which the tests of surface3d share.
#pragma once

#include "meshing/shapes.h"
#include "surface3d/flow.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <ostream>
#include <string>

namespace sbeh::surface3d {

// Words instead of bytes in GoogleTest's messages.
inline void PrintTo(FlowStop stop, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << describe(stop);
}

}  // namespace sbeh::surface3d

namespace sbeh::surface3d::test {

using model::Material;
using model::Model;
using sbeh::test::OrderTable;
using std::numbers::pi;

/// The one-constant material of the paper.
inline Material paper_material(double L) { return Material{}.with_L(L); }

/// A state together with its triangulation.
struct Surface {
  std::shared_ptr<const Triangulation> mesh;
  State state;
  Target target() const { return area_and_volume(*mesh, state.X); }
  FlowMoment moment() const { return {.mesh = mesh, .state = state, .target = target()}; }
};

inline Surface surface_of(const meshing::CurvedMesh& mesh, double order = model::full_order) {
  return {std::make_shared<const Triangulation>(mesh),
          {mesh.nodes, Field::Constant(mesh.node_count(), order)}};
}

/// Fully ordered oblate spheroid of area 4π: where the paper's runs start.
inline Surface ordered_spheroid(double reduced_volume, int triangles) {
  return surface_of(meshing::ellipsoid(reduced_volume, false, {.triangles = triangles}));
}

/// The unit sphere with uniform order.
inline Surface uniform_sphere(double order, int triangles) {
  return surface_of(meshing::sphere({.triangles = triangles}), order);
}

inline double energy_of(const Triangulation& mesh, const Material& material, const State& state) {
  const auto curvature = curvature_of(mesh, state.X);
  EXPECT_TRUE(curvature.has_value());
  return energy(mesh, material, state, *curvature).total();
}

inline Numerics numerics_of(Scheme scheme, Factorisation factorisation = Factorisation::lagged,
                            double solver_tolerance = Numerics().solver_tolerance) {
  Numerics numerics;
  numerics.scheme = scheme;
  numerics.factorisation = factorisation;
  numerics.solver_tolerance = solver_tolerance;
  return numerics;
}

/// How a run steps in time: two_step and step_doubling with and without extrapolation.
enum class Method { two_step, extrapolated, two_halves };

/// A run of equal steps, none rejected.
inline FlowResult run_of_equal_steps(const Surface& start, const Material& material, Model model,
                                     double duration, int steps, Method method,
                                     const FlowObserver& observe = {}) {
  Numerics numerics;
  numerics.tolerance = 0.1;
  numerics.first_step = numerics.largest_step = duration / steps;
  numerics.integrator =
      method == Method::two_step ? Integrator::two_step : Integrator::step_doubling;
  numerics.extrapolate = method == Method::extrapolated;
  FlowResult run =
      run_flow(material, model, start.moment(), numerics,
               {.end_time = duration, .output_times = {}, .stop_at_rest = false}, observe);
  EXPECT_EQ(run.stop, FlowStop::end_time);
  EXPECT_EQ(run.steps, steps);
  EXPECT_EQ(run.last.rejected, 0);
  return run;
}

/// A mildly relaxed oblate of V_r = 0.8: the violent first moments are over, it still moves.
inline Surface relaxed_oblate(const Material& material, Model model, int triangles) {
  Surface s = ordered_spheroid(0.8, triangles);
  s.state = run_of_equal_steps(s, material, model, 0.03, 15, Method::extrapolated).state;
  return s;
}

}  // namespace sbeh::surface3d::test
