#include "meshing/half_edge_mesh.h"

#include <OpenMesh/Core/Utils/Property.hh>
#include <fmt/format.h>

#include <stdexcept>

namespace sbeh::meshing {

HalfEdgeMesh half_edge_mesh(const TriangleMesh& mesh) {
  omerr().disable();  // its own words on a face that cannot be added
  HalfEdgeMesh result;
  result.reserve(mesh.point_count(), 3 * mesh.triangle_count() / 2, mesh.triangle_count());
  std::vector<OpenMesh::VertexHandle> vertices;
  vertices.reserve(mesh.point_count());
  for (int i = 0; i < mesh.point_count(); ++i)
    vertices.push_back(
        result.add_vertex({mesh.points(0, i), mesh.points(1, i), mesh.points(2, i)}));
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3i c = mesh.triangles.col(t);
    if (!result.add_face(vertices[c[0]], vertices[c[1]], vertices[c[2]]).is_valid())
      throw std::invalid_argument(fmt::format(
          "triangle {} ({} {} {}): does not fit the triangles before it: an edge of it belongs to "
          "more than two, or to two that run along it in the same direction",
          t, c[0], c[1], c[2]));
  }
  return result;
}

TriangleMesh triangle_mesh(const HalfEdgeMesh& mesh) {
  TriangleMesh result{Eigen::Matrix3Xd(3, mesh.n_vertices()), Eigen::Matrix3Xi(3, mesh.n_faces())};
  for (const auto vertex : mesh.vertices()) result.points.col(vertex.idx()) = point(mesh, vertex);
  for (const auto face : mesh.faces()) {
    int k = 0;
    for (const auto vertex : face.vertices()) result.triangles(k++, face.idx()) = vertex.idx();
  }
  return result;
}

}  // namespace sbeh::meshing
