// Curved triangles as a file has them, and how they become a closed surface.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/names.h"

#include <string>
#include <vector>

namespace sbeh::meshing {

/// Each cell has its points in the order of CurvedMesh; points are numbered at will.
struct CurvedCells {
  Eigen::Matrix3Xd points;
  Eigen::MatrixXi cells;  ///< 6 or 10 points x cells, in range
  Names names = {};       ///< of points and cells

  int order() const { return cells.rows() == 10 ? 3 : 2; }
};

/// The corners alone, points that belong to a corner, and what these are called.
struct CellCorners {
  TriangleMesh mesh;
  std::vector<int> points;  ///< of the cells, by those of the mesh
  Names names;
};
CellCorners corners(const CurvedCells& cells);

struct JoinedCells {
  CurvedMesh mesh;
  std::vector<int> points;  ///< of the cells, by the nodes of the mesh
};
/// Numbers the nodes as CurvedMesh says. Throws std::invalid_argument where neighbours have different points on
/// their edge, and unless the corners make a closed, oriented surface of the topology of a sphere.
JoinedCells joined(const CurvedCells& cells);

struct CellRepair {
  CurvedCells cells;
  std::vector<std::string> done;
};
/// Joins points that are equal, or near at open edges, and gives all cells one orientation, outward.
CellRepair repaired(const CurvedCells& cells);

}  // namespace sbeh::meshing
