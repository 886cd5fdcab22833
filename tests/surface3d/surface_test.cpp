// Geometry at a point of the surface, and what is integrated over it.
#include "surface3d/surface.h"

#include "meshing/measures.h"
#include "model/numerics/lagrange.h"
#include "tests/surface3d/cases.h"

#include <Eigen/LU>

#include <limits>
#include <stdexcept>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double rounding = 100 * epsilon;  // of sums of a few dozen numbers O(1)

// A surface without symmetry whose triangles are all different.
Surface bumpy(int triangles) {
  const std::vector<meshing::Harmonic> modes{{2, 1, 0.1}, {3, -2, 0.15}, {5, 3, 0.1}, {1, 0, 0.1}};
  return surface_of(meshing::harmonic_sphere(modes, {.triangles = triangles}));
}

TEST(SurfacePoint, has_an_orthonormal_right_handed_frame_whose_third_axis_points_outward) {
  const Surface s = bumpy(80);
  for (const auto points : {assembly_points(), diagnostic_points()})
    for_each_point(*s.mesh, s.state.X, points, [](int, const ShapeValues&, const SurfacePoint& p) {
      EXPECT_LT((p.frame.transpose() * p.frame - Eigen::Matrix3d::Identity()).norm(), rounding);
      EXPECT_NEAR(p.frame.determinant(), 1, rounding);
      EXPECT_GT(p.nu().dot(p.x), 0);  // star-shaped
      EXPECT_GT(p.dS, 0);
    });
}

TEST(SurfacePoint, differentiates_linear_fields_exactly) {
  // ∇f = P g of f(x) = g·x, ∇_C W = G P of W(x) = G x.
  const Surface s = bumpy(80);
  const Eigen::RowVector3d g(0.3, -1.1, 0.7);
  Eigen::Matrix3d G;
  G << 0.2, 0.5, -0.3, 1.1, -0.4, 0.6, 0.1, 0.8, -0.9;
  const Field f = (g * s.state.X).transpose();
  const Nodes W = G * s.state.X;
  // Division by the derivatives of the position, not below 0.1 here.
  for_each_point(
      *s.mesh, s.state.X, assembly_points(),
      [&](int e, const ShapeValues& v, const SurfacePoint& p) {
        const auto tangents = p.frame.leftCols<2>();
        EXPECT_LT((gradient_at(on_element(*s.mesh, e, f), p).transpose() - g * tangents).norm(),
                  10 * rounding);
        EXPECT_LT((gradient_at(on_element(*s.mesh, e, W), p) - G * tangents).norm(), 10 * rounding);
        EXPECT_LT((value_at(on_element(*s.mesh, e, W), v) - G * p.x).norm(), rounding);
      });
}

TEST(SurfacePoint, has_shape_functions_that_sum_to_one_and_gradients_that_sum_to_zero) {
  const Surface s = bumpy(80);
  for_each_point(*s.mesh, s.state.X, assembly_points(),
                 [](int, const ShapeValues& v, const SurfacePoint& p) {
                   EXPECT_NEAR(Shapes(v.phi.data()).sum(), 1, rounding);
                   EXPECT_NEAR(Shapes(v.quadratic.data()).sum(), 1, rounding);
                   for (const auto& grad : p.grad)
                     EXPECT_NEAR(Shapes(grad.data()).sum(), 0, 100 * rounding);
                 });
}

TEST(Area, and_volume_of_a_polyhedron_are_exact) {
  meshing::CurvedMesh mesh = meshing::sphere({.triangles = 20});
  Nodes flat = mesh.nodes;
  for (int e = 0; e < mesh.triangle_count(); ++e) {
    // The corners as linear functions at the ten nodes.
    for (int a = 0; a < 10; ++a) {
      const Eigen::Vector2d at = model::TriangleElement(3).nodes().col(a);
      flat.col(mesh.triangles(a, e)) = (1 - at.sum()) * mesh.nodes.col(mesh.triangles(0, e))
                                     + at[0] * mesh.nodes.col(mesh.triangles(1, e))
                                     + at[1] * mesh.nodes.col(mesh.triangles(2, e));
    }
  }
  const Triangulation icosahedron(mesh);
  // Inscribed in the unit sphere, of side a = 4/√(10 + 2√5): 5√3 a², (5/12)(3 + √5) a³
  const double root = std::sqrt(5.), side = 4 / std::sqrt(10 + 2 * root);
  // Of a sum of a thousand points.
  EXPECT_NEAR(area(icosahedron, flat) / (5 * std::sqrt(3.) * side * side), 1, 32 * epsilon);
  EXPECT_NEAR(volume(icosahedron, flat) / (5. / 12 * (3 + root) * std::pow(side, 3)), 1,
              32 * epsilon);
}

TEST(Area, and_volume_are_those_of_the_meshing_folder_and_scale) {
  const auto mesh = meshing::ellipsoid({1.2, 0.9, 0.7}, {.triangles = 80});
  const Surface s = surface_of(mesh);
  EXPECT_NEAR(area(*s.mesh, mesh.nodes), meshing::area(mesh), 1000 * epsilon);
  EXPECT_NEAR(volume(*s.mesh, mesh.nodes), meshing::volume(mesh), 1000 * epsilon);
  const Nodes doubled = 2 * mesh.nodes;
  EXPECT_NEAR(area(*s.mesh, doubled), 4 * area(*s.mesh, mesh.nodes), 4000 * epsilon);
  EXPECT_NEAR(volume(*s.mesh, doubled), 8 * volume(*s.mesh, mesh.nodes), 8000 * epsilon);
  // The volume does not depend on the origin: the discrete surface is closed.
  const Nodes shifted = mesh.nodes.colwise() + Eigen::Vector3d(1, -2, 3);
  EXPECT_NEAR(volume(*s.mesh, shifted), volume(*s.mesh, mesh.nodes), 10000 * epsilon);
}

TEST(Area, and_volume_of_an_ellipsoid_converge_to_the_closed_forms) {
  // Prolate, semi-axes a < c, e² = 1 − a²/c²: A = 2πa² (1 + c/(a e) asin e), V = 4πa²c/3
  const double a = 0.8, c = 1.3, e = std::sqrt(1 - a * a / (c * c));
  const double exact_area = 2 * pi * a * a * (1 + c / (a * e) * std::asin(e));
  const double exact_volume = 4 * pi / 3 * a * a * c;
  OrderTable A("area of an ellipsoid, relative", "h"), V("its volume", "h");
  for (const int triangles : {80, 320, 1280}) {
    const Surface s = surface_of(meshing::ellipsoid({a, a, c}, {.triangles = triangles}));
    const double h = 1 / std::sqrt(triangles);
    A.add(h, area(*s.mesh, s.state.X) / exact_area - 1);
    V.add(h, volume(*s.mesh, s.state.X) / exact_volume - 1);
  }
  // Interpolation to fourth order.
  EXPECT_NEAR(A.print(), 4, 0.3);
  EXPECT_NEAR(V.print(), 4, 0.3);
}

TEST(NodeNormals, are_unit_vectors_near_those_of_the_ellipsoid) {
  const Eigen::Vector3d axes(1.2, 0.9, 0.7);
  OrderTable table("largest error of the node normals", "h");
  for (const int triangles : {320, 1280}) {
    const Surface s = surface_of(meshing::ellipsoid(axes, {.triangles = triangles}));
    const Nodes n = node_normals(*s.mesh, s.state.X);
    const Nodes exact =
        (axes.cwiseAbs2().cwiseInverse().asDiagonal() * s.state.X).colwise().normalized();
    EXPECT_LT((n.colwise().norm().array() - 1).abs().maxCoeff(), rounding);
    table.add(1 / std::sqrt(triangles), (n - exact).colwise().norm().maxCoeff());
  }
  EXPECT_GT(table.print(), 2.7);  // the slope of the cubic interpolation
}

TEST(Triangulation, shares_the_pressure_nodes_of_an_edge_between_its_two_triangles) {
  // Both must put the same midpoint between the same corners there.
  const auto mesh = meshing::sphere({.triangles = 80});
  const Triangulation t(mesh);
  EXPECT_EQ(t.quadratic_nodes, mesh.vertex_count() + mesh.edge_count());
  Nodes middle = Nodes::Constant(3, t.quadratic_nodes, std::nan(""));
  const Nodes& X = mesh.nodes;
  for (int e = 0; e < t.count(); ++e)
    for (int k = 0; k < 6; ++k) {
      const int a = t.quadratic(k % 3, e), b = t.quadratic((k + 1) % 3, e);
      const Eigen::Vector3d x = k < 3 ? X.col(a).eval() : ((X.col(a) + X.col(b)) / 2).eval();
      auto known = middle.col(t.quadratic(k, e));
      if (known.allFinite()) {
        EXPECT_LT((known - x).norm(), epsilon);
      }
      known = x;
    }
  EXPECT_TRUE(middle.allFinite());
}

TEST(Triangulation, has_each_triangle_in_one_patch_and_patches_of_a_colour_apart) {
  const Triangulation t(meshing::sphere({.triangles = 500}));
  std::vector<int> met(std::size_t(t.count()), 0);
  for (const auto& patches : t.colours) {
    std::vector<int> patch_of(std::size_t(t.nodes), -1);
    int number = 0;
    for (const auto& patch : patches) {
      for (const int e : patch) {
        ++met[std::size_t(e)];
        for (const int node : t.triangles.col(e)) {
          int& owner = patch_of[std::size_t(node)];
          EXPECT_TRUE(owner == -1 || owner == number);
          owner = number;
        }
      }
      ++number;
    }
  }
  EXPECT_EQ(std::ranges::count(met, 1), t.count());
  EXPECT_LT(t.colours.size(), 15);
}

TEST(Triangulation, refuses_a_mesh_of_another_order) {
  for (const int order : {1, 2})
    EXPECT_THROW(Triangulation(meshing::sphere({.triangles = 20, .order = order})),
                 std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::surface3d
