// Curved cells of a file become the surface they were meant to be.
#include "meshing/curved_cells.h"
#include "meshing/curving.h"
#include "meshing/measures.h"
#include "meshing/shapes.h"

#include <gtest/gtest.h>

namespace sbeh::meshing {
namespace {

CurvedMesh example(int order) {
  return ellipsoid({1, 1.3, 0.7}, {.triangles = 80, .order = order});
}

CurvedCells cells_of(const CurvedMesh& mesh) {
  return {mesh.nodes, mesh.triangles, {counted(mesh.node_count()), counted(mesh.triangle_count())}};
}

void turn(CurvedCells& cells, int t) {
  Eigen::VectorXi cell = cells.cells.col(t);
  std::swap(cell[1], cell[2]);
  cell.segment(3, cell.size() == 10 ? 6 : 3).reverseInPlace();
  cells.cells.col(t) = cell;
}

void expect_the_same(const CellRepair& repair, const CurvedMesh& mesh, double within = 1e-14) {
  const CurvedMesh result = joined(repair.cells).mesh;
  EXPECT_EQ(result.node_count(), mesh.node_count());
  EXPECT_NEAR(volume(result), volume(mesh), within);
  EXPECT_NEAR(area(result), area(mesh), within);
}

TEST(CellRepair, leaves_sound_cells_as_they_are) {
  for (const int order : {2, 3}) {
    const CellRepair repair = repaired(cells_of(example(order)));
    EXPECT_TRUE(repair.done.empty());
    EXPECT_EQ(repair.cells.cells, example(order).triangles);
  }
}

TEST(CellRepair, turns_one_or_many_or_all_cells) {
  for (const int order : {2, 3})
    for (const auto& [from, to] : {std::pair(5, 6), {0, 30}, {0, 80}, {10, 80}}) {
      const CurvedMesh mesh = example(order);
      CurvedCells cells = cells_of(mesh);
      for (int t = from; t < to; ++t) turn(cells, t);
      const CellRepair repair = repaired(cells);
      expect_the_same(repair, mesh, 1e-13);
      EXPECT_FALSE(repair.done.empty());
    }
}

TEST(CellRepair, joins_points_that_are_equal_or_near) {
  for (const int order : {2, 3})
    for (const double apart : {0., 1e-7, 1e-5}) {
      const CurvedMesh mesh = example(order);
      const auto size = mesh.triangles.rows();
      CurvedCells cells{Eigen::Matrix3Xd(3, mesh.triangles.size()),
                        Eigen::MatrixXi(size, mesh.triangle_count()),
                        {}};
      int n = 0;
      for (int t = 0; t < mesh.triangle_count(); ++t)
        for (Eigen::Index k = 0; k < size; ++k, ++n) {
          const Eigen::Vector3d off(std::cos(2.4 * n), std::sin(2.4 * n), std::cos(4.8 * n));
          cells.points.col(n) = mesh.nodes.col(mesh.triangles(k, t)) + apart / 4 * off;
          cells.cells(k, t) = n;
        }
      cells.names = {counted(n), counted(mesh.triangle_count())};
      expect_the_same(repaired(cells), mesh, 1e-13 + 20 * apart);
    }
}

TEST(Curving, keeps_the_surface_when_the_order_is_raised) {
  for (const int order : {1, 2}) {
    const CurvedMesh mesh = example(order), raised = of_order(mesh, 3);
    EXPECT_EQ(raised.order, 3);
    EXPECT_NEAR(volume(raised), volume(mesh), 1e-14);
    EXPECT_NEAR(area(raised), area(mesh), 1e-13);
  }
  EXPECT_TRUE(of_order(example(3), 3).nodes == example(3).nodes);
}

}  // namespace
}  // namespace sbeh::meshing
