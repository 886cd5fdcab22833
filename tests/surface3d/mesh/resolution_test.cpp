// What the resolution indicator says of meshes whose energy is known.
#include "surface3d/mesh/resolution.h"

#include "surface3d/diagnostics.h"
#include "tests/surface3d/cases.h"
#include "tests/surface3d/sheared.h"

#include <functional>
#include <string>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

using Shape = std::function<meshing::CurvedMesh(int triangles)>;
struct NamedShape {
  std::string name;
  Shape mesh;
};

Shape spheroid(double reduced_volume, bool prolate) {
  return [=](int triangles) {
    return meshing::ellipsoid(reduced_volume, prolate, {.triangles = triangles});
  };
}
Shape y53(double amplitude) {
  return [=](int triangles) { return sheared(y53_radius(amplitude), 0, triangles); };
}
// The common part of two unit balls at z = ±0.4; its edge is rounded over a width of about 0.4 `edge`,
// sharp for 0.
Shape lens(double edge) {
  return [=](int triangles) {
    const auto radius = [=](const Eigen::Vector3d& d) {
      const double z = 0.4 * d.z();
      return std::sqrt(1 - 0.16 + z * z) - std::hypot(z, 0.4 * edge);
    };
    return meshing::star_shaped(radius, {.triangles = triangles});
  };
}

struct Measured {
  Indicators indicators;
  double bending;
};
Measured measured(const meshing::CurvedMesh& mesh) {
  const Surface s = surface_of(mesh);
  const auto curvature = curvature_of(*s.mesh, s.state.X);
  EXPECT_TRUE(curvature.has_value());
  return {indicators_of(*s.mesh, s.state.X, *curvature),
          energy(*s.mesh, Material{}, s.state, *curvature).bending};
}

TEST(Resolution, is_what_closed_forms_say_of_the_sphere) {
  const double h = std::sqrt(4 * pi * 4 / std::sqrt(3.) / 1280) / 3;  // equilateral triangles
  const Indicators r = measured(meshing::sphere({.triangles = 1280})).indicators;
  // The longest side is within the edge ratio of 1.3 of the mean one, |H| = 2, |B| = √2.
  EXPECT_GT(r.mean_curvature, 2 * h);
  EXPECT_LT(r.mean_curvature, 1.3 * 2 * h);
  EXPECT_NEAR(r.resolution * std::sqrt(2.), r.mean_curvature, 0.01 * r.mean_curvature);
  EXPECT_GT(r.min_angle, 54);
  EXPECT_LT(r.min_angle, 60);
  EXPECT_TRUE(resolved(r));
}

TEST(Resolution, has_a_gap_between_the_two_curvatures_of_second_order_on_smooth_surfaces) {
  for (const auto& [name, shape] :
       {NamedShape{"sphere", spheroid(1, false)}, NamedShape{"oblate", spheroid(0.8, false)}}) {
    OrderTable gap(name + ": curvature gap", "h");
    for (const int triangles : {1280, 5120, 20480})
      gap.add(1 / std::sqrt(triangles), measured(shape(triangles)).indicators.curvature_gap);
    EXPECT_NEAR(gap.print(), 2, 0.2) << name;
  }
}

TEST(Resolution, within_its_limits_means_a_bending_energy_within_one_percent) {
  const std::vector<NamedShape> shapes{{"oblate 0.8", spheroid(0.8, false)},
                                       {"prolate 0.8", spheroid(0.8, true)},
                                       {"oblate 0.65", spheroid(0.65, false)},
                                       {"prolate 0.65", spheroid(0.65, true)},
                                       {"0.5 Y53", y53(0.5)},
                                       {"lens 0.1", lens(0.1)},
                                       {"lens 0.05", lens(0.05)}};
  int within = 0, beyond = 0;
  std::printf("%-14s triangles |H|h    |B|h    gap      error of the bending energy\n", "");
  for (const auto& [name, shape] : shapes) {
    const double exact = measured(shape(11520)).bending;
    for (const int triangles : {180, 320, 720, 1280, 5120}) {
      const auto [r, bending] = measured(shape(triangles));
      const double error = bending / exact - 1;
      std::printf("%-14s %-9d %-7.3f %-7.3f %-8.4f %9.1e %s\n", name.c_str(), triangles,
                  r.mean_curvature, r.resolution, r.curvature_gap, error,
                  resolved(r) ? "" : "unresolved");
      ++(resolved(r) ? within : beyond);
      if (resolved(r)) {
        EXPECT_LT(std::abs(error), 1e-2) << name << ", " << triangles;
      }
    }
    EXPECT_TRUE(resolved(measured(shape(5120)).indicators)) << name;
  }
  EXPECT_GT(within, 15);
  EXPECT_GT(beyond, 5);
}

TEST(Resolution, of_a_sharp_edge_is_never_enough) {
  for (const int triangles : {320, 1280, 5120}) {
    const Indicators r = measured(lens(0)(triangles)).indicators;
    EXPECT_GT(r.resolution, 2 * largest_resolution);
    EXPECT_GT(r.curvature_gap, 4 * largest_curvature_gap);
    EXPECT_FALSE(resolved(r));
  }
}

TEST(Resolution, of_a_ridge_between_the_nodes_shows_in_the_gap_alone) {
  const auto [r, bending] = measured(lens(0.05)(180));
  EXPECT_GT(std::abs(bending / measured(lens(0.05)(5120)).bending - 1), 0.05);
  EXPECT_LT(r.resolution, largest_resolution);
  EXPECT_GT(r.curvature_gap, 2 * largest_curvature_gap);
  EXPECT_FALSE(resolved(r));
}

TEST(Resolution, of_thin_triangles_is_refused_by_their_angle_before_the_energy_errs) {
  const double exact = 8 * pi * Material{}.kappa(model::full_order)
                     + 4 * pi * Material{}.kappa_gauss(model::full_order);
  std::printf("sheared sphere, 1280 triangles: angle, quality, |B|h, gap, error of the energy\n");
  for (const double shear : {0.6, 1., 1.5, 2.}) {
    const auto [r, bending] = measured(sheared(spheroid_radius(1), shear, 1280));
    const double error = bending / exact - 1;
    std::printf("  %.0f  %.2f  %.2f  %.4f  %.1e\n", r.min_angle, r.mesh_quality, r.resolution,
                r.curvature_gap, error);
    EXPECT_EQ(resolved(r), r.min_angle >= smallest_angle);
    EXPECT_LT(r.resolution, largest_resolution);
    EXPECT_LT(r.curvature_gap, largest_curvature_gap);
    EXPECT_EQ(r.min_angle<10, std::abs(error)> 5e-3);
  }
}

}  // namespace
}  // namespace sbeh::surface3d
