// Numbers and places of the nodes of curved meshes.
#include "meshing/curving.h"
#include "meshing/icosphere.h"
#include "meshing/quality.h"
#include "model/numerics/lagrange.h"
#include "tests/meshing/cases.h"

#include <gtest/gtest.h>

#include <map>

namespace sbeh::meshing {
namespace {

using namespace test;

TEST(Icosphere, has_20_n_squared_triangles_on_the_unit_sphere) {
  for (const int n : {1, 2, 3, 7, 16}) {
    const TriangleMesh mesh = icosphere(n);
    EXPECT_EQ(mesh.triangle_count(), 20 * n * n);
    EXPECT_EQ(mesh.point_count(), 10 * n * n + 2);
    EXPECT_LT((mesh.points.colwise().norm().array() - 1).abs().maxCoeff(), 4e-16) << n;
    EXPECT_GT(volume(mesh), 2.5);
  }
}

TEST(Octasphere, has_8_n_squared_triangles_none_of_which_crosses_a_plane_of_coordinates) {
  for (const int n : {1, 2, 3, 7, 16}) {
    const TriangleMesh mesh = octasphere(n);
    EXPECT_EQ(mesh.triangle_count(), 8 * n * n);
    EXPECT_EQ(mesh.point_count(), 4 * n * n + 2);
    EXPECT_LT((mesh.points.colwise().norm().array() - 1).abs().maxCoeff(), 4e-16) << n;
    EXPECT_GT(volume(mesh), 1.3);
    for (const auto t : mesh.triangles.colwise())
      for (const int c : {0, 1, 2}) {
        const auto x = mesh.points(c, t).array();
        EXPECT_GE(x.minCoeff() * x.maxCoeff(), -1e-17) << n;
      }
  }
}

/// Largest distance from a turned point to the nearest point of the mesh.
double turned_away(const TriangleMesh& mesh, double angle) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  double worst = 0;
  for (int i = 0; i < mesh.point_count(); ++i)
    worst = std::max(
        worst, (mesh.points.colwise() - turn * mesh.points.col(i)).colwise().norm().minCoeff());
  return worst;
}

TEST(Icosphere, has_a_five_fold_axis_along_z_and_no_two_fold_one) {
  for (const int n : {1, 4, 5}) {
    const TriangleMesh mesh = icosphere(n);
    EXPECT_LT(turned_away(mesh, 2 * pi / 5), 1e-15);
    EXPECT_GT(turned_away(mesh, pi), 0.1 / n);
  }
}

TEST(EllipsoidMesh, keeps_the_five_fold_axis_under_smoothing) {
  const CurvedMesh mesh = ellipsoid(0.7, false, {.triangles = 1280});
  // Rounding grows by the smoothing's own instability of long waves, hardly at all.
  EXPECT_LT(turned_away(corners(mesh), 2 * pi / 5), 1e-10);
  EXPECT_GT(turned_away(corners(mesh), pi), 1e-2);
}

TEST(Numbering, counts_vertices_then_edge_nodes_then_interiors) {
  for (const int order : {1, 2, 3}) {
    const CurvedMesh mesh = y53({.triangles = 320, .order = order});
    const int V = mesh.vertex_count(), E = mesh.edge_count(), F = mesh.triangle_count();
    const int inside = (order - 1) * (order - 2) / 2;
    EXPECT_EQ(V - E + F, 2);
    EXPECT_EQ(mesh.node_count(), V + (order - 1) * E + inside * F);
    EXPECT_LT(mesh.triangles.topRows(3).maxCoeff(), V);
    for (int row = 3; row < mesh.triangles.rows(); ++row) {
      const bool on_edge = row < 3 * order;
      EXPECT_GE(mesh.triangles.row(row).minCoeff(), on_edge ? V : V + (order - 1) * E);
      if (on_edge) {
        EXPECT_LT(mesh.triangles.row(row).maxCoeff(), V + (order - 1) * E);
      }
    }
    // Every node is used: edge nodes twice, interior ones once.
    std::vector<int> uses(std::size_t(mesh.node_count()), 0);
    for (const int node : mesh.triangles.reshaped()) ++uses[std::size_t(node)];
    for (int i = V; i < mesh.node_count(); ++i)
      EXPECT_EQ(uses[std::size_t(i)], i < V + (order - 1) * E ? 2 : 1);
  }
}

TEST(Numbering, makes_neighbours_agree_bit_for_bit_on_their_edge) {
  for (const int order : {1, 2, 3}) {
    const CurvedMesh mesh = y53({.triangles = 1280, .order = order});
    std::map<std::pair<int, int>, std::vector<int>> seen;  // (from, to) → nodes between
    for (const auto c : mesh.triangles.colwise())
      for (int side = 0; side < 3; ++side) {
        std::vector<int> between;
        between.reserve(std::size_t(order - 1));
        for (int k = 0; k < order - 1; ++k) between.push_back(c[3 + side * (order - 1) + k]);
        EXPECT_TRUE(seen.try_emplace({c[side], c[(side + 1) % 3]}, between).second);
      }
    EXPECT_EQ(int(seen.size()), 2 * mesh.edge_count());
    for (const auto& [ends, between] : seen) {
      auto other = seen.at({ends.second, ends.first});
      std::reverse(other.begin(), other.end());
      EXPECT_EQ(between, other);  // the same nodes, hence the same positions
    }
  }
}

TEST(Numbering, is_a_function_of_the_triangles) {
  const CurvedMesh mesh = y53({.triangles = 320});
  EXPECT_EQ(numbered_nodes(corners(mesh), 3), mesh.triangles);
}

TEST(Nodes, lie_over_their_places_on_the_plain_triangle) {
  // In the direction of the normals of the corners, which differ from the radial one by O(h²).
  const CurvedMesh mesh = sphere({.triangles = 1280});
  const Eigen::Matrix2Xd at = model::TriangleElement(3).nodes();
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, c);
    const Vector3d u = X.col(1) - X.col(0), v = X.col(2) - X.col(0);
    const double h = u.norm();
    for (int k = 3; k < 10; ++k) {
      const Vector3d foot = X.col(0) + at(0, k) * u + at(1, k) * v;
      EXPECT_LT((X.col(k) - foot.normalized()).norm(), std::pow(h, 4));
    }
  }
}

TEST(Nodes, lie_on_the_shape_to_rounding) {
  for (const int order : {1, 2, 3}) {
    const Resolution resolution{.triangles = 1280, .order = order};
    const CurvedMesh harmonic = y53(resolution);
    const double c = 0.5 * std::sqrt(770 / pi) / 32;
    for (const auto x : harmonic.nodes.colwise()) {
      const Vector3d d = x.normalized();
      const double r = 1 + c * d[0] * (d[0] * d[0] - 3 * d[1] * d[1]) * (9 * d[2] * d[2] - 1);
      EXPECT_NEAR(x.norm(), r, 4e-15);
    }
    const CurvedMesh e = ellipsoid({1, 2, 3}, resolution);
    for (const auto x : e.nodes.colwise())
      EXPECT_NEAR(x.cwiseQuotient(Vector3d(1, 2, 3)).norm(), 1, 1e-15);
  }
}

TEST(Curving, refuses_what_is_no_closed_surface) {
  TriangleMesh open = icosphere(2);
  open.triangles.conservativeResize(3, open.triangle_count() - 1);
  const Projection stay = [](const Vector3d& x) { return x; };
  EXPECT_THROW(curved(open, 3, stay), std::invalid_argument);
  EXPECT_THROW(curved(icosphere(2), 4, stay), std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::meshing
