// Nodes off a surface, so that the curved triangles between them are nearest to it.
#pragma once

#include "meshing/curved_mesh.h"

#include <functional>
#include <optional>

namespace sbeh::meshing {

/// Where a line meets a surface: how far along its unit direction, and the unit normal there.
struct LineHit {
  double distance;
  Eigen::Vector3d normal;
};
/// Next to the point; empty where the line misses the surface.
using HitByLine =
    std::function<std::optional<LineHit>(const Eigen::Vector3d& x, const Eigen::Vector3d& along)>;

/// Moves the nodes along their normals by the d that makes ∫ |∇(δ − d)|² + (δ − d)²/R² dS least (δ the distance to the surface along
/// the normal, R = √(A/4π)). Normals and mean curvature, in which interpolation errs most, come out best: area and bending energy of
/// cubic triangles gain one to two digits over nodes that lie on the surface. Returns false, and leaves the mesh as it was, where a normal
/// misses it.
[[nodiscard]] bool fit(CurvedMesh& mesh, const HitByLine& surface);

}  // namespace sbeh::meshing
