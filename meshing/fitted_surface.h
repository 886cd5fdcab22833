// A smooth surface through the points of a plain triangle mesh.
#pragma once

#include "meshing/names.h"
#include "meshing/smoothing.h"
#include "meshing/triangle_mesh.h"

#include <memory>
#include <vector>

namespace sbeh::meshing {

/// Throws std::invalid_argument unless the mesh is closed and oriented, and where triangles meet at more than
/// 60 degrees: they describe no smooth surface.
void require_smooth(const TriangleMesh& mesh, const Names& names = {});

/// At every point of the mesh a polynomial graph of degree 4 over the tangent plane goes through
/// it and, by weighted least squares, near the points around (of lower degree where a coarse mesh
/// has too few). A place on a triangle is moved onto the graphs of its corners and takes the mean
/// of the three, weighted with its barycentric coordinates. For points on a smooth surface, at
/// distances h, the result is within O(h⁵) of it.
class FittedSurface {
 public:
  /// Throws as `require_smooth` does.
  explicit FittedSurface(const TriangleMesh& mesh, const Names& names = {});

  /// The place on the smooth surface for barycentric coordinates in a triangle.
  Eigen::Vector3d at(int triangle, const Eigen::Vector3d& barycentric) const;

  const TriangleMesh& mesh() const { return mesh_; }

  /// How far the points scatter about it, as the curvature of the shortest waves that the triangles can show,
  /// of two edges' length, over its own; both root of the mean square. Next to nothing for points on a
  /// smooth surface that is resolved.
  double roughness() const { return roughness_; }

 private:
  struct Graph {
    Eigen::Matrix3d frame;         // columns: two tangents, normal
    int degree = 0;                // 1 … 4
    Eigen::VectorXd coefficients;  // of u, v, u², uv, v², … by degree; u, v in units of `scale`
    double scale = 1;
    double scatter =
        0;  // root of the mean square distance of the points around, in units of `scale`
  };
  Graph graph_at(int point, const std::vector<int>& around, const Eigen::Vector3d& normal,
                 double edge_length) const;
  Eigen::Vector3d onto_graph(int point, const Eigen::Vector3d& x) const;

  TriangleMesh mesh_;
  std::vector<Graph> graphs_;
  double roughness_ = 0;
};

/// From here on the scatter of the points makes more than a hundredth of the bending energy.
inline constexpr double largest_roughness = 0.1;
/// With fewer the fit reaches round the surface, and what is coarse cannot be told from what is rough.
inline constexpr int fewest_for_roughness = 100;  // triangles

/// Takes a point to the nearest place on the plain triangles (CGAL) and from there to the smooth
/// surface. Keeps the surface alive.
Projection onto(std::shared_ptr<const FittedSurface> surface);

}  // namespace sbeh::meshing
