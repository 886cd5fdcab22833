#include "meshing/intersections.h"

#include "meshing/half_edge_mesh.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <algorithm>
#include <utility>

namespace sbeh::meshing {

std::vector<std::array<int, 2>> self_intersections(const TriangleMesh& mesh) {
  const HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  std::vector<std::pair<OpenMesh::FaceHandle, OpenMesh::FaceHandle>> found;
  CGAL::Polygon_mesh_processing::self_intersections(half_edges, std::back_inserter(found));
  std::vector<std::array<int, 2>> pairs;
  for (const auto& [a, b] : found) {
    pairs.push_back({std::min(a.idx(), b.idx()), std::max(a.idx(), b.idx())});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace sbeh::meshing
