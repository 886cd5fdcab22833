// How good the meshes of the shapes are at every size: the table of meshing/README.md.
#include "meshing/quality.h"

#include "meshing/curving.h"
#include "meshing/defects.h"
#include "meshing/revolution.h"
#include "tests/meshing/cases.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace sbeh::meshing {
namespace {

using namespace test;

struct Family {
  const char* name;
  CurvedMesh (*make)(const Resolution&);
  double least_angle;   ///< degrees, from so many triangles on
  int least_triangles;  ///< with fewer the shape may bend too sharply and be refused
};

CurvedMesh modes(std::initializer_list<Harmonic> list, const Resolution& r) {
  return harmonic_sphere(std::span(list.begin(), list.size()), r);
}

// Where CGAL's remeshing has a part, triangles differ from version to version. At 30° the constant of the
// interpolation error, 1/sin, is √3 times that of equilateral triangles.
constexpr double remeshed = 30;

const std::array<Family, 12> families{{
    {"sphere", sphere, 52, 80},
    {"oblate, V_r = 0.9", [](const Resolution& r) { return ellipsoid(0.9, false, r); }, 45, 80},
    {"oblate, V_r = 0.6", [](const Resolution& r) { return ellipsoid(0.6, false, r); }, 45, 80},
    {"oblate, V_r = 0.3", [](const Resolution& r) { return ellipsoid(0.3, false, r); }, 30, 20480},
    {"prolate, V_r = 0.9", [](const Resolution& r) { return ellipsoid(0.9, true, r); }, 40, 80},
    {"prolate, V_r = 0.8", [](const Resolution& r) { return ellipsoid(0.8, true, r); }, remeshed,
     80},
    {"prolate, V_r = 0.6", [](const Resolution& r) { return ellipsoid(0.6, true, r); }, remeshed,
     1280},
    {"prolate, V_r = 0.5", [](const Resolution& r) { return ellipsoid(0.5, true, r); }, remeshed,
     5120},
    {"ellipsoid 1:2:3",
     [](const Resolution& r) {
       return ellipsoid({1, 2, 3}, r);
     },
     40, 80},
    {"0.5 Y_53", y53, 40, 320},
    {"0.8 Y_20 + 0.3 Y_32",
     [](const Resolution& r) {
       return modes({{2, 0, 0.8}, {3, 2, 0.3}}, r);
     },
     40, 80},
    {"0.2 Y_30 + 0.1 Y_4-3",
     [](const Resolution& r) {
       return modes({{3, 0, 0.2}, {4, -3, 0.1}}, r);
     },
     45, 80},
}};

TEST(Quality, of_all_shapes_at_all_sizes_is_in_the_table) {
  std::printf("%-24s %6s %6s %6s %6s %6s %6s\n", "shape", "F", "min", "max", "edges", "J min",
              "J max");
  for (const Family& family : families)
    for (const int count : {80, 320, 1280, 1620, 5120, 20480}) {
      CurvedMesh mesh;
      try {
        mesh = family.make({.triangles = count});
      } catch (const std::invalid_argument&) {
        std::printf("%-24s %6d refused\n", family.name, count);
        EXPECT_LT(count, family.least_triangles) << family.name;
        continue;
      }
      const Quality q = quality_of(mesh);
      std::printf("%-24s %6d %6.1f %6.1f %6.2f %6.2f %6.2f\n", family.name, q.triangles,
                  q.min_angle, q.max_angle, q.edge_ratio, q.min_jacobian, q.max_jacobian);
      EXPECT_NEAR(q.triangles, count, 0.15 * count) << family.name;
      if (count >= family.least_triangles) {
        EXPECT_GT(q.min_angle, family.least_angle) << family.name << ' ' << count;
        EXPECT_GT(q.min_jacobian, 0.2) << family.name << ' ' << count;
      }
      EXPECT_EQ(q.euler, 2);
      EXPECT_GT(q.volume, 0);
      EXPECT_EQ(q.self_intersections, 0) << family.name << ' ' << count;
      EXPECT_GT(q.min_jacobian, 0) << family.name << ' ' << count;
      EXPECT_FALSE(find_defect(corners(mesh))) << family.name << ' ' << count;
    }
}

TEST(Quality, of_the_sphere_knows_its_numbers) {
  const Quality q = quality_of(sphere({.triangles = 80, .order = 1}));
  EXPECT_EQ(q.triangles, 80);
  EXPECT_EQ(q.valences, (std::map<int, int>{{5, 12}, {6, 30}}));
  EXPECT_DOUBLE_EQ(q.min_jacobian, 1);  // plain triangles
  EXPECT_DOUBLE_EQ(q.max_jacobian, 1);
  EXPECT_EQ(q.reduced_volume, reduced_volume(q.area, q.volume));
}

TEST(Quality, sees_triangles_that_fold_over_and_pass_through_each_other) {
  CurvedMesh mesh = sphere({.triangles = 80});
  const int node = mesh.triangles(9, 17);
  mesh.nodes.col(node) += 1.5 * (mesh.nodes.col(mesh.triangles(0, 17)) - mesh.nodes.col(node));
  const Quality folded = quality_of(mesh);
  EXPECT_LE(folded.min_jacobian, 0);
  EXPECT_EQ(folded.worst_triangle, 17);
  CurvedMesh dented = sphere({.triangles = 320});
  dented.nodes.col(0)[2] = -1.5;  // the north pole drawn out through the south
  EXPECT_GT(quality_of(dented).self_intersections, 0);
}

}  // namespace
}  // namespace sbeh::meshing
