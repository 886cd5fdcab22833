#include "meshing/edge_orbits.h"
#include "meshing/remeshing.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

namespace sbeh::meshing {

using Eigen::Vector3d;

namespace {

// One round of changes to a mesh, whose points are numbered anew after each of them. Sizes are kept at the points.
class Grading {
 public:
  Grading(const TriangleMesh& mesh, const SizeField& size, const Projection& onto_surface,
          const PointGroup& symmetry)
      : symmetry_(symmetry_of_triangles(mesh, symmetry)),
        mesh_(half_edge_mesh({symmetry_.symmetric_part(mesh.points), mesh.triangles})),
        onto_surface_(onto_surface) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_halfedge_status();
    mesh_.request_face_status();
    mesh_.add_property(size_);
    for (const auto v : mesh_.vertices()) mesh_.property(size_, v) = size(point(mesh_, v));
  }

  TriangleMesh with_long_ones_split();
  TriangleMesh with_short_ones_collapsed();
  TriangleMesh with_even_valences();

 private:
  static constexpr double longest = 4. / 3, shortest = 4. / 5;  // of the wanted length

  TriangleMesh result() {
    mesh_.garbage_collection();
    return triangle_mesh(mesh_);
  }
  double relative_length(OpenMesh::VertexHandle a, OpenMesh::VertexHandle b) const {
    return (point(mesh_, a) - point(mesh_, b)).norm() * 2
         / (mesh_.property(size_, a) + mesh_.property(size_, b));
  }
  bool may_collapse(SmartHalfEdge h);
  bool may_collapse(const std::vector<SmartHalfEdge>& orbit);
  bool turns_over(OpenMesh::SmartVertexHandle vertex, OpenMesh::SmartVertexHandle to) const;

  MeshSymmetry symmetry_;
  HalfEdgeMesh mesh_;
  OpenMesh::VPropHandleT<double> size_;
  Projection onto_surface_;
};

TriangleMesh Grading::with_long_ones_split() {
  const std::size_t edges =
      mesh_.n_edges();  // new ones, and those of new points, wait for the next round
  const int points = int(mesh_.n_vertices());
  const auto is_new = [&](SmartEdge e) { return e.v0().idx() >= points || e.v1().idx() >= points; };
  for (std::size_t k = 0; k < edges; ++k) {
    const auto edge = OpenMesh::make_smart(mesh_.edge_handle(unsigned(k)), mesh_);
    if (is_new(edge) || relative_length(edge.v0(), edge.v1()) <= longest) continue;
    const std::vector<SmartEdge> orbit = orbit_of(mesh_, edge, symmetry_);
    if (!are_apart(orbit)) continue;
    for (const SmartEdge one : orbit) {
      const Vector3d x = onto_surface_((point(mesh_, one.v0()) + point(mesh_, one.v1())) / 2);
      mesh_.split(one, mesh_.add_vertex({x[0], x[1], x[2]}));
    }
  }
  return result();
}

// Whether a triangle around the vertex that does not vanish would face another way.
bool Grading::turns_over(OpenMesh::SmartVertexHandle vertex, OpenMesh::SmartVertexHandle to) const {
  constexpr double steepest = 0.5;  // cosine
  for (const auto h : vertex.outgoing_halfedges()) {
    const auto a = h.to(), b = h.next().to();
    if (a == to || b == to) continue;
    const Vector3d xa = point(mesh_, a), xb = point(mesh_, b);
    const Vector3d now = (xa - point(mesh_, vertex)).cross(xb - point(mesh_, vertex));
    const Vector3d then = (xa - point(mesh_, to)).cross(xb - point(mesh_, to));
    if (!(then.dot(now) > steepest * then.norm() * now.norm())) return true;
  }
  return false;
}

bool Grading::may_collapse(SmartHalfEdge h) {
  if (!mesh_.is_collapse_ok(h)) return false;
  // Both points opposite to the edge lose a triangle.
  if (h.next().to().valence() < 5 || h.opp().next().to().valence() < 5) return false;
  for (const auto neighbour : mesh_.vv_range(h.from()))
    if (neighbour != h.to() && relative_length(neighbour, h.to()) > longest) return false;
  return !turns_over(h.from(), h.to());
}

// All at once: what one of them changes is nothing of another.
bool Grading::may_collapse(const std::vector<SmartHalfEdge>& orbit) {
  std::set<int> around;
  for (const SmartHalfEdge h : orbit) {
    if (!may_collapse(h)) return false;
    if (orbit.size() == 1) return true;
    if (!around.insert(h.from().idx()).second) return false;
    for (const auto neighbour : h.from().vertices())
      if (!around.insert(neighbour.idx()).second) return false;
  }
  return true;
}

TriangleMesh Grading::with_short_ones_collapsed() {
  for (const auto edge : mesh_.edges()) {
    if (edge.deleted() || relative_length(edge.v0(), edge.v1()) >= shortest) continue;
    for (const auto h : {edge.h0(), edge.h1()}) {
      const std::vector<SmartHalfEdge> orbit = orbit_of(mesh_, h, symmetry_);
      if (!may_collapse(orbit)) continue;
      for (const SmartHalfEdge one : orbit) mesh_.collapse(one);
      break;
    }
  }
  return result();
}

TriangleMesh Grading::with_even_valences() {
  const auto excess = [](OpenMesh::SmartVertexHandle v, int change) {
    return std::abs(int(v.valence()) + change - 6);
  };
  for (const auto edge : mesh_.edges()) {
    const auto h = edge.h0();
    const auto a = h.from(), b = h.to(), c = h.next().to(), d = h.opp().next().to();
    const int before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
    const int after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
    if (after >= before) continue;
    const Vector3d xa = point(mesh_, a), xb = point(mesh_, b), xc = point(mesh_, c),
                   xd = point(mesh_, d);
    const Vector3d outward = (xb - xa).cross(xc - xa) + (xd - xa).cross(xb - xa);
    if (!((xd - xc).cross(xb - xc).dot(outward) > 0 && (xa - xc).cross(xd - xc).dot(outward) > 0))
      continue;
    const std::vector<SmartEdge> orbit = orbit_of(mesh_, edge, symmetry_);
    if (!may_flip(mesh_, orbit)) continue;
    for (const SmartEdge one : orbit) mesh_.flip(one);
  }
  return result();
}

}  // namespace

TriangleMesh graded(const TriangleMesh& mesh, const SizeField& size, const Projection& onto_surface,
                    const PointGroup& symmetry) {
  constexpr int rounds = 10, sweeps = 5, last_sweeps = 40;
  const Smoothing aim{.size = size, .evenness = 0.25, .symmetry = symmetry};
  TriangleMesh result = mesh;
  const auto grading = [&] { return Grading(result, size, onto_surface, symmetry); };
  for (int round = 0; round < rounds; ++round) {
    result = grading().with_long_ones_split();
    result = grading().with_short_ones_collapsed();
    result = grading().with_even_valences();
    smooth(result, onto_surface, aim, round + 1 < rounds ? sweeps : last_sweeps);
  }
  return result;
}

}  // namespace sbeh::meshing
