// What files of plain faces have wrong becomes the surface they were meant to be, and keeps the file's numbers.
#include "meshing/repair.h"

#include "meshing/defects.h"
#include "meshing/icosphere.h"
#include "meshing/measures.h"

#include <gtest/gtest.h>

#include <numeric>

namespace sbeh::meshing {
namespace {

using Eigen::Vector3d;

std::string all(const std::vector<std::string>& lines) {
  return std::accumulate(lines.begin(), lines.end(), std::string(),
                         [](const auto& a, const auto& b) { return a + b + '\n'; });
}

bool mentions(const Repair& repair, std::string_view words) {
  return all(repair.done).find(words) != std::string::npos;
}

int add_point(PolygonMesh& mesh, const Vector3d& x) {
  const int index = mesh.point_count();
  mesh.points.conservativeResize(3, index + 1);
  mesh.points.col(index) = x;
  mesh.names.points.push_back(index);
  return index;
}
void add_face(PolygonMesh& mesh, std::vector<int> corners) {
  mesh.names.triangles.push_back(mesh.face_count());
  mesh.faces.push_back(std::move(corners));
}

PolygonMesh sphere(double size = 1, const Vector3d& place = Vector3d::Zero()) {
  PolygonMesh mesh = polygon_mesh(icosphere(3));
  mesh.points = (size * mesh.points).colwise() + place;
  return mesh;
}

void expect_the_sphere(const Repair& repair, const PolygonMesh& whole, double within = 1e-13) {
  const auto defect = find_defect(repair.mesh, repair.names);
  EXPECT_FALSE(defect) << defect->text;
  EXPECT_EQ(repair.mesh.triangle_count(), 180) << all(repair.done);
  EXPECT_EQ(repair.mesh.point_count(), 92) << all(repair.done);
  const double expected = volume(triangle_mesh(whole));
  EXPECT_NEAR(volume(repair.mesh), expected, within * expected);
}

// Each corner a point of its own, the copies of a point so far from each other (of the size).
PolygonMesh loose(const PolygonMesh& whole, double apart) {
  PolygonMesh mesh{{}, {}, {}};
  int n = 0;
  for (const auto& face : whole.faces) {
    std::vector<int> corners;
    for (const int i : face) {
      const double phase = 2.399963 * n++;  // the golden angle: no two the same
      const Vector3d off(std::cos(phase), std::sin(phase), std::cos(2 * phase));
      corners.push_back(add_point(mesh, whole.points.col(i) + apart / 4 * off));
    }
    add_face(mesh, corners);
  }
  return mesh;
}

TEST(Repair, leaves_a_sound_mesh_as_it_is) {
  const Repair repair = repaired(sphere());
  EXPECT_TRUE(repair.done.empty()) << all(repair.done);
  EXPECT_EQ(repair.mesh.points, icosphere(3).points);
  EXPECT_EQ(repair.mesh.triangles, icosphere(3).triangles);
}

TEST(Repair, joins_points_of_equal_coordinates) {
  const Repair repair = repaired(loose(sphere(), 0));
  expect_the_sphere(repair, sphere());
  EXPECT_TRUE(mentions(repair, "points joined with others: 448, of the same coordinates"))
      << all(repair.done);
}

TEST(Repair, joins_points_that_are_near_whatever_the_size_and_place) {
  for (const double size : {1e-6, 1., 1e6})
    for (const double apart : {1e-9, 1e-6, 1e-4}) {
      const PolygonMesh whole = sphere(size, {3 * size, 0, -size});
      const Repair repair = repaired(loose(whole, apart * size));
      expect_the_sphere(repair, whole, 20 * apart);
      EXPECT_TRUE(mentions(repair, "points joined with others: 448, at most ")) << size << apart;
    }
}

TEST(Repair, does_not_join_what_is_farther_apart_nor_two_sheets) {
  EXPECT_TRUE(find_defect(repaired(loose(sphere(), 0.05)).mesh));
  // A thin flask: the wall is nearer to itself than a thousandth of the edges.
  PolygonMesh flat = sphere();
  flat.points.row(2) *= 1e-4;
  EXPECT_EQ(repaired(flat).mesh.point_count(), 92);
}

TEST(Repair, names_the_nearest_pair_of_an_open_surface) {
  PolygonMesh mesh = sphere();
  const int copy = add_point(mesh, mesh.points.col(mesh.faces[7][0]) + Vector3d(1e-6, 0, 0));
  mesh.faces[7][0] = copy;
  const auto defect = find_defect(triangle_mesh(mesh), mesh.names);
  ASSERT_TRUE(defect);
  EXPECT_NE(defect->text.find("point 92 are 1e-06 apart"), std::string::npos) << defect->text;
  expect_the_sphere(repaired(mesh), sphere());
}

TEST(Repair, removes_strays_and_says_which) {
  using Change = void (*)(PolygonMesh&);
  const std::vector<std::pair<const char*, Change>> strays{
      {"a fin with a new point",
       [](PolygonMesh& m) {
         add_face(m, {m.faces[5][0], m.faces[5][1], add_point(m, {0, 0, 3})});
       }},
      {"a wall between three points that are no neighbours",
       [](PolygonMesh& m) {
         add_face(m, {0, 40, 80});
       }},
      {"a triangle somewhere",
       [](PolygonMesh& m) {
         const int a = add_point(m, {2, 0, 0}), b = add_point(m, {3, 0, 0}),
                   c = add_point(m, {2, 1, 0});
         add_face(m, {a, b, c});
       }},
      {"one that hangs on a point",
       [](PolygonMesh& m) {
         const int b = add_point(m, {3, 0, 0}), c = add_point(m, {2, 1, 0});
         add_face(m, {0, b, c});
       }},
  };
  for (const auto& [name, change] : strays) {
    PolygonMesh mesh = sphere();
    change(mesh);
    const Repair repair = repaired(mesh);
    expect_the_sphere(repair, sphere());
    EXPECT_TRUE(mentions(repair, "stray triangles removed: 1, triangle 180")) << all(repair.done);
  }
}

void add_body(PolygonMesh& mesh, const PolygonMesh& body) {
  const int first = mesh.point_count();
  for (const auto x : body.points.colwise()) add_point(mesh, x);
  for (std::vector<int> face : body.faces) {
    for (int& corner : face) corner += first;
    add_face(mesh, face);
  }
}

TEST(Repair, removes_small_closed_bodies_beside_the_surface_and_says_which) {
  for (const double size : {1e-6, 1e-3, 0.05, 0.09})  // of less than 0.81 % of the area
    for (const Vector3d& place : {Vector3d(1.5, 0, 0), Vector3d(0.2, 0.1, -0.3)}) {
      PolygonMesh mesh = sphere(7, Vector3d(3, 0, 0));
      add_body(mesh, sphere(7 * size, 7 * place));
      const Repair repair = repaired(mesh);
      expect_the_sphere(repair, sphere(7));
      EXPECT_TRUE(mentions(repair,
                           "small closed bodies beside the surface removed: 1, of less "
                           "than 1 % of its area, triangles 180, 181, 182, 183, 184, ..."))
          << all(repair.done);
    }
  PolygonMesh mesh = sphere(0.01);  // comes first in the file
  add_body(mesh, sphere());
  add_body(mesh, sphere(0.02, Vector3d(0, 0, 2)));
  expect_the_sphere(repaired(mesh), sphere());
  EXPECT_TRUE(mentions(repaired(mesh), "bodies beside the surface removed: 2, "));
}

TEST(Repair, keeps_bodies_that_are_not_small) {
  for (const double size : {0.11, 0.5, 1.}) {
    PolygonMesh mesh = sphere();
    add_body(mesh, sphere(size, Vector3d(3, 0, 0)));
    EXPECT_EQ(repaired(mesh).mesh.triangle_count(), 360);
  }
}

TEST(Repair, keeps_a_surface_that_is_not_joined_rather_than_taking_it_for_strays) {
  PolygonMesh two = sphere();  // open halves, nothing of which is stray
  std::erase_if(two.faces, [&](const auto& f) { return std::abs(two.points(2, f[0])) < 0.3; });
  two.names.triangles.resize(two.faces.size());
  EXPECT_EQ(repaired(two).mesh.triangle_count(), two.face_count());
}

// A point on an edge, to rounding or nearly, which one of its two triangles does not know of.
PolygonMesh with_points_on_an_edge(int count, double off, PolygonMesh mesh = sphere()) {
  const std::vector<int> face = mesh.faces[20];
  const Vector3d a = mesh.points.col(face[0]), b = mesh.points.col(face[1]);
  std::vector<int> on_edge;
  for (int k = 1; k <= count; ++k)
    on_edge.push_back(add_point(mesh, a + k * (b - a) / (count + 1) + Vector3d(0, 0, off)));
  mesh.faces[20] = {face[0], on_edge[0], face[2]};
  for (int k = 1; k < count; ++k)
    add_face(mesh, {on_edge[std::size_t(k - 1)], on_edge[std::size_t(k)], face[2]});
  add_face(mesh, {on_edge.back(), face[1], face[2]});
  return mesh;
}

TEST(Repair, turns_the_longest_edge_of_flat_triangles) {
  for (const int count : {1, 2, 4})
    for (const double off : {0., 1e-12, 1e-7}) {
      PolygonMesh open = with_points_on_an_edge(count, off);
      PolygonMesh closed = open;  // by flat triangles
      const int from = open.faces[20][0], to = open.faces.back()[1];
      for (int k = 0; k < count; ++k) add_face(closed, {92 + k, from, k + 1 < count ? 93 + k : to});
      for (const PolygonMesh& mesh : {open, closed}) {
        const Repair repair = repaired(mesh);
        const auto defect = find_defect(repair.mesh, repair.names);
        EXPECT_FALSE(defect) << count << ' ' << off << ' ' << defect->text;
        EXPECT_EQ(repair.mesh.triangle_count(), 180 + 2 * count);
        EXPECT_TRUE(mentions(repair, "flat triangles")) << all(repair.done);
        EXPECT_NEAR(volume(repair.mesh), volume(icosphere(3)), 1e-13 + off);
      }
    }
}

// Between halves and quarters of coordinates of ten bits there is no rounding.
TEST(Repair, closes_holes_whose_corners_lie_exactly_on_a_line) {
  PolygonMesh coarse = sphere();
  coarse.points = (1024 * coarse.points).array().round() / 1024;
  for (const int count : {1, 3}) {
    const Repair repair = repaired(with_points_on_an_edge(count, 0, coarse));
    EXPECT_FALSE(find_defect(repair.mesh, repair.names)) << count;
    EXPECT_EQ(repair.mesh.triangle_count(), 180 + 2 * count);
    EXPECT_TRUE(mentions(repair, "holes closed: 1")) << all(repair.done);
  }
}

TEST(Repair, cuts_polygons_flat_or_not) {
  // A prism of n sides whose lids and walls are polygons, dented or not.
  for (const int n : {3, 4, 5, 12})
    for (const double dent : {0., 0.4}) {
      PolygonMesh prism{{}, {}, {}};
      std::vector<int> top, bottom;
      for (int k = 0; k < n; ++k) {
        const double phi = 2 * M_PI * k / n, r = k == 0 ? 1 - dent : 1;
        top.push_back(add_point(prism, {r * std::cos(phi), r * std::sin(phi), 1}));
        bottom.push_back(add_point(prism, {r * std::cos(phi), r * std::sin(phi), 0}));
      }
      for (int k = 0; k < n; ++k) {
        const auto i = std::size_t(k), j = std::size_t((k + 1) % n);
        add_face(prism, {bottom[i], bottom[j], top[j], top[i]});
      }
      add_face(prism, top);
      add_face(prism, {bottom.rbegin(), bottom.rend()});
      const Repair repair = repaired(prism);
      EXPECT_FALSE(find_defect(repair.mesh)) << n;
      EXPECT_EQ(repair.mesh.triangle_count(), 4 * n - 4);
      const double area = n * std::sin(2 * M_PI / n) / 2 - dent * std::sin(2 * M_PI / n);
      EXPECT_NEAR(volume(repair.mesh), area, 1e-14);
      EXPECT_TRUE(mentions(repair, "faces with more than three corners cut into triangles: "));
    }
}

TEST(Repair, keeps_the_numbers_of_the_file) {
  PolygonMesh mesh = sphere();
  add_point(mesh, {5, 5, 5});                           // 92, of no use
  mesh.faces.insert(mesh.faces.begin(), {0, 1, 0});     // face 0: a corner twice
  mesh.faces.insert(mesh.faces.begin(), {40, 41, 40});  // face 0, so that the former is 1
  mesh.names.triangles = counted(mesh.face_count());
  const Repair repair = repaired(mesh);
  ASSERT_EQ(repair.mesh.triangle_count(), 180);
  for (int t = 0; t < 180; ++t) {
    EXPECT_EQ(repair.names.triangles[std::size_t(t)], t + 2);
    const std::vector<int>& face = mesh.faces[std::size_t(t) + 2];
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(repair.names.points[std::size_t(repair.mesh.triangles(k, t))],
                face[std::size_t(k)]);
  }
}

TEST(Repair, tells_places_of_what_has_no_number) {
  PolygonMesh mesh = sphere();
  mesh.names.points.clear();  // as STL
  mesh.faces.pop_back();
  mesh.names.triangles.pop_back();
  const Repair repair = repaired(mesh);
  ASSERT_EQ(repair.mesh.triangle_count(), 180);
  EXPECT_TRUE(triangle_name(repair.mesh, 179, repair.names).starts_with("the triangle at ("));
  EXPECT_EQ(triangle_name(repair.mesh, 178, repair.names), "triangle 178");
  EXPECT_TRUE(edge_name(repair.mesh, 0, 1, repair.names).starts_with("the edge from ("));
}

}  // namespace
}  // namespace sbeh::meshing
