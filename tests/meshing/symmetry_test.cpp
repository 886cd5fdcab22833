// Point groups, and meshes that have them.
#include "meshing/curving.h"
#include "meshing/icosphere.h"
#include "meshing/measures.h"
#include "meshing/mesh_symmetry.h"
#include "meshing/quality.h"
#include "meshing/remeshing.h"
#include "meshing/shapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::meshing {
namespace {

using Eigen::Vector3d;

const std::vector<std::pair<std::string, std::size_t>> orders{
    {"C1", 1},  {"Cs", 2},   {"Ci", 2},   {"C2", 2},    {"C7", 7},   {"C12", 12},
    {"C2v", 4}, {"C3v", 6},  {"C5h", 10}, {"S4", 4},    {"S6", 6},   {"S24", 24},
    {"D2", 4},  {"D3", 6},   {"D2h", 8},  {"D3h", 12},  {"D6h", 24}, {"D12h", 48},
    {"D2d", 8}, {"D3d", 12}, {"D4d", 16}, {"D12d", 48}, {"T", 12},   {"Td", 24},
    {"Th", 24}, {"O", 24},   {"Oh", 48},  {"I", 60},    {"Ih", 120}};

TEST(PointGroup, has_as_many_operations_as_the_tables_say) {
  for (const auto& [symbol, order] : orders) {
    const PointGroup group(symbol);
    EXPECT_EQ(group.operations().size(), order) << symbol;
    EXPECT_EQ(group.symbol(), symbol);
    for (const Operation& a : group.operations()) {
      EXPECT_LT((a * a.transpose() - Operation::Identity()).norm(), 1e-14);
      for (const Operation& b : group.operations()) EXPECT_TRUE(group.has(a * b)) << symbol;
    }
  }
}

TEST(PointGroup, contains_its_parts) {
  const PointGroup whole("D3h");
  for (const char* part : {"C1", "Cs", "C3", "C3v", "C3h", "D3", "C2v", "D3h"})
    EXPECT_EQ(whole.contains(PointGroup(part)), std::string(part) != "C2v") << part;  // about z
  EXPECT_FALSE(whole.contains(PointGroup("Ci")));
  EXPECT_TRUE(PointGroup("Oh").contains(PointGroup("Td")));
  EXPECT_TRUE(PointGroup("mirror") == PointGroup("Cs"));
}

// Parts with other axes than those of their symbols too.
TEST(PointGroup, has_parts_that_are_groups) {
  const PointGroup whole("D4h");
  const Vector3d d = Vector3d(0.3, -0.5, 0.7).normalized();
  const auto part_of = [&](int l, int m) {
    return whole.part([&](const Operation& operation) {
      return std::abs(spherical_harmonic(l, m, operation * d) - spherical_harmonic(l, m, d))
           < 1e-12;
    });
  };
  EXPECT_TRUE(part_of(4, 0) == whole);
  EXPECT_EQ(part_of(2, 2).operations().size(), 8u);
  EXPECT_TRUE(part_of(2, 2).contains(PointGroup("D2h")));
  EXPECT_EQ(part_of(2, -2).operations().size(), 8u);
  EXPECT_FALSE(part_of(2, -2).contains(PointGroup("D2h")));
  EXPECT_EQ(part_of(2, -2).symbol(), "part of D4h");
  EXPECT_TRUE(part_of(1, 0).contains(PointGroup("C4v")));
  const Operation once = whole.operations()[1];
  EXPECT_TRUE(whole.part([&](const Operation& o) { return o == once; }).is_trivial());
  EXPECT_TRUE(
      whole.part([&](const Operation& o) { return o == once || o == Operation::Identity(); })
          .is_trivial());  // a turn by a fourth, without its powers
}

TEST(PointGroup, leaves_harmonics_as_the_conventions_say) {
  const auto is_symmetric = [](const char* symbol, int l, int m) {
    const Vector3d d = Vector3d(0.3, -0.5, 0.7).normalized();
    const PointGroup group(symbol);
    for (const Operation& operation : group.operations())
      if (std::abs(spherical_harmonic(l, m, operation * d) - spherical_harmonic(l, m, d)) > 1e-12)
        return false;
    return true;
  };
  EXPECT_TRUE(is_symmetric("D3h", 5, 3));
  EXPECT_FALSE(is_symmetric("D3h", 4, 3));
  EXPECT_TRUE(is_symmetric("C3v", 4, 3));
  EXPECT_TRUE(is_symmetric("D3d", 4, 3));
  EXPECT_TRUE(is_symmetric("D2h", 2, 2));
  EXPECT_TRUE(is_symmetric("D2d", 3, 2));
  EXPECT_TRUE(is_symmetric("Td", 3, -2));  // xyz
  EXPECT_FALSE(is_symmetric("D3h", 5, -3));
}

TEST(PointGroup, refuses_what_is_none) {
  for (const char* symbol : {"", "D", "C0", "C13", "D3x", "C3d", "D3v", "S3", "S2", "E", "d3h",
                             "C03", "Oh2", "C-3", "D1h"})
    EXPECT_THROW(PointGroup{symbol}, std::invalid_argument) << symbol;
}

TEST(SymmetricMesh, has_every_group_to_rounding) {
  for (const auto& [symbol, order] : orders) {
    const PointGroup group(symbol);
    const CurvedMesh mesh = sphere({.triangles = 320, .symmetry = group});
    const MeshSymmetry symmetry = required_symmetry(mesh, group);
    EXPECT_LT(symmetry.misfit(mesh.nodes), 1e-14) << symbol;
    EXPECT_GT(quality_of(mesh).min_jacobian, 0.9) << symbol;
    EXPECT_NEAR(mesh.triangle_count(), 320, 180) << symbol;  // body times n²
  }
}

TEST(SymmetricMesh, of_a_sharp_shape_is_as_good_as_any) {
  const std::array modes{Harmonic{5, 3, 0.5}};
  for (const double grading : {0., 1.}) {
    const PointGroup group("D3h");
    const CurvedMesh mesh = harmonic_sphere(
        modes, {.triangles = 1280, .grading = grading, .symmetry = group, .fitted = true});
    EXPECT_LT(required_symmetry(mesh, group).misfit(mesh.nodes), 1e-14);
    const Quality quality = quality_of(mesh);
    EXPECT_EQ(quality.triangles, 1296);
    EXPECT_GT(quality.min_angle, 40);
    EXPECT_GT(quality.min_jacobian, 0.85);
    EXPECT_EQ(quality.self_intersections, 0);
  }
}

TEST(SymmetricMesh, is_known_again_after_its_surface_has_lost_the_symmetry) {
  const PointGroup group("D3h");
  CurvedMesh mesh = sphere({.triangles = 320, .symmetry = group});
  const MeshSymmetry before = required_symmetry(mesh, group);
  for (auto x : mesh.nodes.colwise())
    x *= 1 + 0.2 * spherical_harmonic(3, 0, x.normalized())
       + 0.1 * spherical_harmonic(2, 1, x.normalized());
  const auto after = symmetry_of(mesh, group.operations());
  ASSERT_TRUE(after);
  EXPECT_EQ(after->image, before.image);
  EXPECT_GT(after->misfit(mesh.nodes), 0.05);
  EXPECT_THROW(required_symmetry(mesh, group), std::invalid_argument);
}

TEST(SymmetricMesh, its_symmetric_part_is_a_projection) {
  const PointGroup group("D3h");
  const CurvedMesh mesh = sphere({.triangles = 320, .symmetry = group});
  const MeshSymmetry symmetry = required_symmetry(mesh, group);
  Eigen::Matrix3Xd field = mesh.nodes;
  Eigen::VectorXd values(mesh.node_count());
  for (int i = 0; i < mesh.node_count(); ++i) {
    const Vector3d d = mesh.nodes.col(i).normalized();
    field.col(i) += Vector3d(d.x() * d.y(), d.z(), 1);
    values[i] = spherical_harmonic(5, 3, d) + spherical_harmonic(3, 0, d)
              + spherical_harmonic(2, 2, d) + spherical_harmonic(5, -3, d);
  }
  const Eigen::Matrix3Xd part = symmetry.symmetric_part(field);
  EXPECT_LT((symmetry.symmetric_part(part) - part).norm(), 1e-13);
  const Eigen::VectorXd kept = symmetry.symmetric_part(values);
  for (int i = 0; i < mesh.node_count(); ++i)  // of the harmonics the first alone is symmetric
    EXPECT_NEAR(kept[i], spherical_harmonic(5, 3, mesh.nodes.col(i).normalized()), 1e-12);
}

TEST(SymmetricMesh, refuses_shapes_and_triangles_without_the_symmetry) {
  const std::array modes{Harmonic{4, 3, 0.2}};
  EXPECT_THROW(harmonic_sphere(modes, {.triangles = 320, .symmetry = PointGroup("D3h")}),
               std::invalid_argument);
  EXPECT_NO_THROW(harmonic_sphere(modes, {.triangles = 320, .symmetry = PointGroup("C3v")}));
  const CurvedMesh mesh = sphere({.triangles = 320});  // of the icosahedron, five-fold about z
  EXPECT_THROW(required_symmetry(mesh, PointGroup("D3h")), std::invalid_argument);
  EXPECT_NO_THROW(required_symmetry(mesh, PointGroup("C5v")));
}

TEST(SymmetricMesh, keeps_its_symmetry_where_triangles_are_split_collapsed_and_flipped) {
  const PointGroup group("D3h");
  const Projection onto = [](const Vector3d& x) -> Vector3d { return x.normalized(); };
  const TriangleMesh before = corners(sphere({.triangles = 320, .order = 1, .symmetry = group}));
  const SizeField size = [](const Vector3d& x) {
    return 0.15 + 0.1 * x.z() * x.z() + 0.05 * spherical_harmonic(5, 3, x.normalized());
  };
  const TriangleMesh after = graded(before, size, onto, group);
  EXPECT_NE(after.triangle_count(), before.triangle_count());
  EXPECT_TRUE(has_symmetry(after, group));
  EXPECT_GT(min_angle(after), 30);
}

// ½∫H² of r = 1 + 0.5 Y_53 by a spectral calculation; see tests/surface3d for the energy of the scheme.
TEST(Fit, brings_area_and_volume_nearer) {
  const std::array modes{Harmonic{5, 3, 0.5}};
  constexpr double exact_area = 15.99921295, exact_volume = 4.438790205;
  for (const int triangles : {320, 1280, 5120}) {
    const CurvedMesh on = harmonic_sphere(modes, {.triangles = triangles, .grading = 1}),
                     off = harmonic_sphere(modes,
                                           {.triangles = triangles, .grading = 1, .fitted = true});
    EXPECT_LT(std::abs(area(off) / exact_area - 1), std::abs(area(on) / exact_area - 1) / 2);
    EXPECT_LT(std::abs(volume(off) / exact_volume - 1),
              std::abs(volume(on) / exact_volume - 1) / 4);
  }
}

TEST(Fit, keeps_the_reduced_volume_that_is_asked_for) {
  const std::array modes{Harmonic{2, 2, 0.2}, Harmonic{3, 1, 0.1}};
  const CurvedMesh harmonics =
      harmonic_sphere(modes, 0.9, {.triangles = 320, .grading = 1, .fitted = true});
  EXPECT_NEAR(reduced_volume(harmonics), 0.9, 1e-13);
  const CurvedMesh spheroid = ellipsoid(0.7, false, {.triangles = 320, .fitted = true});
  EXPECT_NEAR(reduced_volume(spheroid), 0.7, 1e-13);
  EXPECT_NEAR(area(spheroid), 4 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace sbeh::meshing
