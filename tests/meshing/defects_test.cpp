// What is no closed outward surface of sphere topology is named; what can be mended is.
#include "meshing/defects.h"

#include "meshing/icosphere.h"
#include "meshing/repair.h"
#include "tests/meshing/cases.h"

#include <gtest/gtest.h>

#include <limits>

namespace sbeh::meshing {
namespace {

using namespace test;
using Change = void (*)(TriangleMesh&);

void add_triangle(TriangleMesh& m, int a, int b, int c) {
  m.triangles.conservativeResize(3, m.triangle_count() + 1);
  m.triangles.col(m.triangle_count() - 1) << a, b, c;
}
void add_point(TriangleMesh& m, double x, double y, double z) {
  m.points.conservativeResize(3, m.point_count() + 1);
  m.points.col(m.point_count() - 1) << x, y, z;
}
void add_mesh(TriangleMesh& m, const TriangleMesh& other) {
  const int points = m.point_count(), triangles = m.triangle_count();
  m.points.conservativeResize(3, points + other.point_count());
  m.points.rightCols(other.point_count()) = other.points;
  m.triangles.conservativeResize(3, triangles + other.triangle_count());
  m.triangles.rightCols(other.triangle_count()) = other.triangles.array() + points;
}
TriangleMesh torus() {
  constexpr int n = 24, k = 12;
  TriangleMesh m{Eigen::Matrix3Xd(3, n * k), Eigen::Matrix3Xi(3, 2 * n * k)};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < k; ++j) {
      const double a = 2 * pi * i / n, b = 2 * pi * j / k, r = 2 + std::cos(b);
      m.points.col(i * k + j) << r * std::cos(a), r * std::sin(a), std::sin(b);
      const int right = (i + 1) % n * k, up = (j + 1) % k;
      m.triangles.col(2 * (i * k + j)) << i * k + j, right + j, right + up;
      m.triangles.col(2 * (i * k + j) + 1) << i * k + j, right + up, i * k + up;
    }
  return m;
}

struct Case {
  DefectKind kind;
  const char* text;  ///< how the sentence starts
  Change change;     ///< of icosphere(3): 92 points, 180 triangles
  bool mendable;
};

const double nan = std::numeric_limits<double>::quiet_NaN();

const std::vector<Case> cases{
    {DefectKind::empty, "there are no triangles", [](TriangleMesh& m) { m.triangles.resize(3, 0); },
     false},
    {DefectKind::not_finite, "point 7 (nan, ", [](TriangleMesh& m) { m.points(0, 7) = nan; },
     false},
    {DefectKind::no_such_point, "triangle 180 (points 0, 1, 92): there are only 92 points",
     [](TriangleMesh& m) { add_triangle(m, 0, 1, 92); }, false},
    {DefectKind::degenerate, "triangle 180 (points 3, 3, 4): has no area",
     [](TriangleMesh& m) { add_triangle(m, 3, 3, 4); }, true},
    {DefectKind::degenerate, "triangle 180 (points 92, 93, 94): has no area",
     [](TriangleMesh& m) {
       for (const double x : {0., 1., 2.}) add_point(m, x, x, x);
       add_triangle(m, 92, 93, 94);
     },
     true},
    {DefectKind::repeated, "triangle 180 (points ",
     [](TriangleMesh& m) {
       add_triangle(m, m.triangles(1, 5), m.triangles(2, 5), m.triangles(0, 5));
     },
     true},
    {DefectKind::unused_point, "point 92: belongs to no triangle",
     [](TriangleMesh& m) { add_point(m, 5, 5, 5); }, true},
    {DefectKind::not_manifold_edge, "edge ",
     [](TriangleMesh& m) {
       add_point(m, 0, 0, 3);
       add_triangle(m, m.triangles(0, 5), m.triangles(1, 5), 92);
     },
     true},
    {DefectKind::orientation_differs, "edge ",
     [](TriangleMesh& m) { m.triangles.col(9).reverseInPlace(); }, true},
    {DefectKind::open, "edge ", [](TriangleMesh& m) { m.triangles.conservativeResize(3, 179); },
     true},
    {DefectKind::not_manifold_point, "point ",
     [](TriangleMesh& m) {  // a second sphere hangs on one point of the first
       TriangleMesh other = icosphere(1);
       other.points.colwise() += Vector3d(0, 0, 2);
       const int south = 92 + 11, north = 0;
       add_mesh(m, other);
       for (int& corner : m.triangles.reshaped())
         if (corner == south) corner = north;
       m.points.col(south) = m.points.col(m.point_count() - 1);
       for (int& corner : m.triangles.reshaped())
         if (corner == m.point_count() - 1) corner = south;
       m.points.conservativeResize(3, m.point_count() - 1);
     },
     false},
    {DefectKind::several_pieces, "triangle 180 (points ",
     [](TriangleMesh& m) {
       TriangleMesh other = icosphere(1);
       other.points.colwise() += Vector3d(0, 0, 3);
       add_mesh(m, other);
     },
     false},
    {DefectKind::wrong_genus, "the surface has 1 handle(s)", [](TriangleMesh& m) { m = torus(); },
     false},
    {DefectKind::inward, "triangle 0 (points ",
     [](TriangleMesh& m) { m.triangles.colwise().reverseInPlace(); }, true},
    {DefectKind::self_intersecting, "triangle ", [](TriangleMesh& m) { m.points(2, 0) = -1.5; },
     false},
};

TEST(Defects, are_found_and_named) {
  EXPECT_FALSE(find_defect(icosphere(3)));
  for (const Case& wrong : cases) {
    TriangleMesh mesh = icosphere(3);
    wrong.change(mesh);
    const auto defect = find_defect(mesh);
    ASSERT_TRUE(defect) << wrong.text;
    EXPECT_EQ(int(defect->kind), int(wrong.kind)) << defect->text;
    EXPECT_TRUE(defect->text.starts_with(wrong.text)) << defect->text;
  }
}

TEST(Repair, mends_what_it_can_and_says_what_it_did) {
  for (const Case& wrong : cases) {
    if (wrong.kind <= DefectKind::no_such_point) continue;
    TriangleMesh mesh = icosphere(3);
    wrong.change(mesh);
    const Repair repair = repaired(polygon_mesh(mesh));
    EXPECT_EQ(!find_defect(repair.mesh), wrong.mendable) << wrong.text;
    if (!wrong.mendable) continue;
    EXPECT_FALSE(repair.done.empty()) << wrong.text;
    EXPECT_EQ(repair.mesh.triangle_count(), 180) << wrong.text;
    EXPECT_NEAR(volume(repair.mesh), volume(icosphere(3)), 1e-14) << wrong.text;
  }
}

}  // namespace
}  // namespace sbeh::meshing
