#include "meshing/edge_orbits.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace sbeh::meshing {

std::vector<SmartHalfEdge> orbit_of(const HalfEdgeMesh& mesh, SmartHalfEdge h,
                                    const MeshSymmetry& symmetry) {
  std::vector<SmartHalfEdge> orbit;
  for (const auto image : symmetry.image.colwise()) {
    const auto there = mesh.find_halfedge(
        OpenMesh::make_smart(mesh.vertex_handle(unsigned(image[h.from().idx()])), mesh),
        mesh.vertex_handle(unsigned(image[h.to().idx()])));
    if (!there.is_valid()) continue;
    if (std::find(orbit.begin(), orbit.end(), there) == orbit.end())
      orbit.push_back(OpenMesh::make_smart(there, mesh));
  }
  return orbit;
}

std::vector<SmartEdge> orbit_of(const HalfEdgeMesh& mesh, SmartEdge edge,
                                const MeshSymmetry& symmetry) {
  std::vector<SmartEdge> orbit;
  for (const SmartHalfEdge h : orbit_of(mesh, edge.h0(), symmetry))
    if (std::find(orbit.begin(), orbit.end(), h.edge()) == orbit.end()) orbit.push_back(h.edge());
  return orbit;
}

bool are_apart(const std::vector<SmartEdge>& orbit) {
  std::set<int> faces;
  return std::all_of(orbit.begin(), orbit.end(), [&](const SmartEdge edge) {
    return faces.insert(edge.h0().face().idx()).second
        && faces.insert(edge.h1().face().idx()).second;
  });
}

bool may_flip(const HalfEdgeMesh& mesh, const std::vector<SmartEdge>& orbit) {
  std::map<int, int> losses;  // of triangles, by points
  std::set<std::pair<int, int>> new_edges;
  if (!are_apart(orbit)) return false;
  for (const SmartEdge edge : orbit) {
    if (!mesh.is_flip_ok(edge)) return false;
    for (const auto h : {edge.h0(), edge.h1()})
      if (int(h.from().valence()) - ++losses[h.from().idx()] < 3) return false;
    const int c = edge.h0().next().to().idx(), d = edge.h1().next().to().idx();
    if (!new_edges.insert(std::minmax(c, d)).second) return false;
  }
  return true;
}

}  // namespace sbeh::meshing
