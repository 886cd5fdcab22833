#include "meshing/polygon_mesh.h"

#include <algorithm>
#include <cassert>

namespace sbeh::meshing {

PolygonMesh polygon_mesh(const TriangleMesh& mesh) {
  PolygonMesh result{mesh.points, {}, own_numbers(mesh)};
  for (const auto c : mesh.triangles.colwise()) result.faces.push_back({c[0], c[1], c[2]});
  return result;
}

int first_polygon(const PolygonMesh& mesh) {
  const auto found = std::ranges::find_if(mesh.faces, [](const auto& f) { return f.size() != 3; });
  return found == mesh.faces.end() ? -1 : int(found - mesh.faces.begin());
}

TriangleMesh triangle_mesh(const PolygonMesh& mesh) {
  assert(first_polygon(mesh) < 0);
  TriangleMesh result{mesh.points, Eigen::Matrix3Xi(3, mesh.face_count())};
  for (int t = 0; t < mesh.face_count(); ++t)
    result.triangles.col(t) = Eigen::Map<const Eigen::Vector3i>(mesh.faces[std::size_t(t)].data());
  return result;
}

}  // namespace sbeh::meshing
