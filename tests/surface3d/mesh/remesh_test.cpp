// New triangles for a surface: what they keep and what they improve.
#include "surface3d/mesh/remesh.h"

#include "surface3d/diagnostics.h"
#include "surface3d/mesh/resolution.h"
#include "tests/surface3d/cases.h"
#include "tests/surface3d/sheared.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

// An order that changes smoothly over the directions, 0.25 … 0.65.
double smooth_order(const Eigen::Vector3d& x) {
  const Eigen::Vector3d d = x.normalized();
  return 0.45 + 0.2 * std::sin(2 * d.x() + d.y()) * std::cos(1.5 * d.z());
}

Surface ordered_surface(const meshing::CurvedMesh& mesh) {
  Surface s = surface_of(mesh);
  for (int i = 0; i < mesh.node_count(); ++i) s.state.beta[i] = smooth_order(mesh.nodes.col(i));
  return s;
}

RemeshResult remesh(const Surface& s, const RemeshOptions& options = {}) {
  return surface3d::remesh(*s.mesh, s.state, Material{}, options);
}

double total_order(const Triangulation& mesh, const State& state) {
  const Diagnostics d = diagnose(mesh, Material{}, state);
  return d.order_mean * d.area;
}
// Relative, of ∫β dS.
double order_change(const Surface& old, const RemeshResult& fresh) {
  return total_order(*fresh.mesh, fresh.state) / total_order(*old.mesh, old.state) - 1;
}

Indicators indicators_of(const Triangulation& mesh, const Nodes& X) {
  const auto curvature = curvature_of(mesh, X);
  EXPECT_TRUE(curvature.has_value());
  return surface3d::indicators_of(mesh, X, *curvature);
}

TEST(Remesh, turns_thin_triangles_into_good_ones_and_keeps_area_volume_and_energy) {
  struct Case {
    std::string name;
    meshing::RadialFunction radius;
    double shear;
  };
  const std::vector<Case> cases{{"sphere", spheroid_radius(1), 1},
                                {"oblate 1:0.4", spheroid_radius(0.4), 1},
                                {"prolate 1:2", spheroid_radius(2), 0.6},
                                {"0.3 Y53", y53_radius(0.3), 0.6},
                                {"0.5 Y53", y53_radius(0.5), 0.6}};
  std::printf(
      "1280 triangles, grading 0 and 1: count, angle, quality, |B|h, gap before and after;"
      " change of U, A, V, order; distance\n");
  for (const auto& [name, radius, shear] : cases) {
    const Surface old = ordered_surface(sheared(radius, shear, 1280));
    const RemeshResult fresh = remesh(old);
    ASSERT_TRUE(fresh.mesh) << name << ": " << fresh.refusal;
    const RemeshReport& r = fresh.report;
    const Indicators before = indicators_of(*old.mesh, old.state.X),
                     after = indicators_of(*fresh.mesh, fresh.state.X);
    std::printf(
        "%-14s %d %d  %.0f° %.0f°  %.2f %.2f  %.2f %.2f  %.3f %.3f  %8.1e %8.1e %8.1e "
        "%8.1e  %.1e\n",
        name.c_str(), r.triangles_before, r.triangles_after, r.min_angle_before, r.min_angle_after,
        r.quality_before, r.quality_after, before.resolution, after.resolution,
        before.curvature_gap, after.curvature_gap, r.energy_change, r.area_change, r.volume_change,
        order_change(old, fresh), r.distance);
    EXPECT_LT(r.min_angle_before, 33) << name;
    EXPECT_GT(r.min_angle_after, 30) << name;
    EXPECT_GT(r.quality_after, 0.6) << name;
    EXPECT_NEAR(r.triangles_after, r.triangles_before, 0.06 * r.triangles_before) << name;
    EXPECT_TRUE(resolved(after)) << name;
    const Target kept = old.target();
    EXPECT_NEAR(area(*fresh.mesh, fresh.state.X) / kept.area, 1, 1e-11) << name;
    EXPECT_NEAR(volume(*fresh.mesh, fresh.state.X) / kept.volume, 1, 1e-11) << name;
    EXPECT_LT(std::abs(r.energy_change), RemeshOptions{}.largest_energy_change) << name;
    EXPECT_NEAR(r.energy_before, energy_of(*old.mesh, Material{}, old.state), 1e-12);
    EXPECT_NEAR(r.energy_after, energy_of(*fresh.mesh, Material{}, fresh.state), 1e-12);
  }
}

// What a transfer loses, with nodes on a spheroid before.
void expect_transfer_orders(double shear) {
  const double q = 0.6;
  OrderTable distance("distance of the new surface from the old one", "h"),
      X("  of its nodes from the spheroid", "h"), beta("  β at the nodes", "h"), order("  ∫β", "h"),
      U("  energy", "h");
  for (const int triangles : {320, 1280, 5120}) {
    const Surface old = ordered_surface(sheared(spheroid_radius(q), shear, triangles));
    const RemeshResult fresh = remesh(old, {.largest_energy_change = 1});
    ASSERT_TRUE(fresh.mesh) << fresh.refusal;
    double off = 0, wrong = 0;
    for (int i = 0; i < fresh.mesh->nodes; ++i) {
      const Eigen::Vector3d x = fresh.state.X.col(i);
      off = std::max(off, std::abs(x.norm() / spheroid_radius(q)(x.normalized()) - 1));
      const double value = fresh.state.beta[i];
      // At a maximum between the old nodes it is cut off at the largest of these.
      if (value > old.state.beta.minCoeff() && value < old.state.beta.maxCoeff())
        wrong = std::max(wrong, std::abs(value - smooth_order(x)));
    }
    const double h = 1 / std::sqrt(triangles);
    distance.add(h, fresh.report.distance);
    X.add(h, off);
    beta.add(h, wrong);
    order.add(h, order_change(old, fresh));
    U.add(h, fresh.report.energy_change);
  }
  // Interpolation in P3; the energy sees the square of the error of H, which is of second order. The
  // meshes are no refinements of each other: with edges that are up to √2 longer than the count tells, an
  // error changes by up to 4, and the mean order over 4 : 1 in h by up to 1.
  for (OrderTable* table : {&distance, &X, &beta, &order, &U}) {
    table->print();
    const auto orders = table->orders();
    EXPECT_GT((orders.front() + orders.back()) / 2, 4 - 1);
  }
}

TEST(Remesh, transfers_an_even_mesh_to_fourth_order) { expect_transfer_orders(0); }
TEST(Remesh, transfers_a_sheared_mesh_to_fourth_order) { expect_transfer_orders(0.6); }

TEST(Remesh, keeps_the_order_within_its_range_where_the_cubics_leave_it) {
  Surface s = surface_of(sheared(spheroid_radius(0.6), 0.6, 320));
  for (int i = 0; i < s.mesh->nodes; ++i) s.state.beta[i] = s.state.X(0, i) > 0.1 ? 0.65 : 0.05;
  double largest = 0;
  for_each_point(*s.mesh, s.state.X, assembly_points(),
                 [&](int e, const ShapeValues& v, const SurfacePoint&) {
                   largest = std::max(largest, value_at(on_element(*s.mesh, e, s.state.beta), v));
                 });
  EXPECT_GT(largest, 0.68);
  const RemeshResult fresh = remesh(s, {.largest_energy_change = 1});
  ASSERT_TRUE(fresh.mesh) << fresh.refusal;
  EXPECT_GE(fresh.state.beta.minCoeff(), 0.05);
  EXPECT_LE(fresh.state.beta.maxCoeff(), 0.65);
  EXPECT_GT(fresh.state.beta.maxCoeff() - fresh.state.beta.minCoeff(), 0.59);
}

TEST(Remesh, makes_triangles_small_where_the_curvature_is_large) {
  const Surface s = surface_of(sheared(y53_radius(0.5), 0, 1280));
  double with_grading = 0, without = 0;
  for (const double grading : {0., 1.}) {
    const RemeshResult fresh = remesh(s, {.grading = grading});
    ASSERT_TRUE(fresh.mesh) << fresh.refusal;
    (grading > 0 ? with_grading : without) = indicators_of(*fresh.mesh, fresh.state.X).resolution;
  }
  EXPECT_LT(with_grading, 0.8 * without);
}

TEST(Remesh, makes_as_many_triangles_as_are_asked_for) {
  const Surface s = surface_of(sheared(y53_radius(0.3), 0, 320));
  for (const int triangles : {240, 640, 1280}) {
    const RemeshResult fresh = remesh(s, {.triangles = triangles, .largest_energy_change = 1});
    ASSERT_TRUE(fresh.mesh) << fresh.refusal;
    EXPECT_NEAR(fresh.report.triangles_after, triangles, 0.06 * triangles);
  }
}

TEST(Remesh, can_be_repeated_without_losing_more_each_time) {
  Surface s = ordered_surface(sheared(spheroid_radius(0.6), 0.6, 320));
  const double start = energy_of(*s.mesh, Material{}, s.state);
  std::vector<double> changes;
  for (int i = 0; i < 5; ++i) {
    RemeshResult fresh = remesh(s, {.triangles = 320, .largest_energy_change = 1});
    ASSERT_TRUE(fresh.mesh) << fresh.refusal;
    changes.push_back(std::abs(fresh.report.energy_change));
    s = {fresh.mesh, fresh.state};
  }
  for (const double change : changes) std::printf("  change of the energy %.1e\n", change);
  EXPECT_LT(changes.back(), 2 * changes.front());
  EXPECT_NEAR(s.mesh->count(), 320, 0.06 * 320);
  EXPECT_LT(std::abs(energy_of(*s.mesh, Material{}, s.state) / start - 1), 5e-3);
}

TEST(Remesh, gives_the_same_bits_each_time) {
  const Surface s = ordered_surface(sheared(y53_radius(0.3), 0.6, 320));
  const RemeshResult a = remesh(s, {.largest_energy_change = 1}),
                     b = remesh(s, {.largest_energy_change = 1});
  ASSERT_TRUE(a.mesh && b.mesh);
  EXPECT_EQ(a.mesh->triangles, b.mesh->triangles);
  EXPECT_EQ(a.state.X, b.state.X);
  EXPECT_EQ(a.state.beta, b.state.beta);
}

TEST(Remesh, is_refused_with_a_reason) {
  const auto expect_refused = [](const RemeshResult& result, const std::string& why) {
    EXPECT_FALSE(result.mesh);
    EXPECT_EQ(result.state.X.size(), 0);
    EXPECT_NE(result.refusal.find(why), std::string::npos) << result.refusal;
  };
  const Surface s = surface_of(sheared(y53_radius(0.3), 0.6, 320));
  const RemeshResult bound = remesh(s, {.largest_energy_change = 1e-5});
  expect_refused(bound, "the energy would change by");
  EXPECT_GT(std::abs(bound.report.energy_change), 1e-5);
  Surface broken = s;
  broken.state.X(0, 5) = std::nan("");
  expect_refused(remesh(broken), "degenerate");
  // Too few triangles for the tips: that is why they are slender.
  expect_refused(remesh(surface_of(sheared(y53_radius(0.5), 0, 1280)), {.triangles = 40}),
                 "the surface is too sharp for ");
}

TEST(Remesh, refuses_options_out_of_range) {
  const Surface s = uniform_sphere(0.5, 80);
  EXPECT_THROW(remesh(s, {.triangles = 19}), std::invalid_argument);
  EXPECT_THROW(remesh(s, {.triangles = -1}), std::invalid_argument);
  EXPECT_THROW(remesh(s, {.grading = 11}), std::invalid_argument);
  EXPECT_THROW(remesh(s, {.largest_energy_change = -1}), std::invalid_argument);
  EXPECT_THROW(remesh(s, {.largest_energy_change = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::surface3d
