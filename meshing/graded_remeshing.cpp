#include "meshing/half_edge_mesh.h"
#include "meshing/remeshing.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstdlib>

namespace sbeh::meshing {

using Eigen::Vector3d;

namespace {

// Sizes are kept at the points while the triangles change.
class Grading {
 public:
  Grading(const TriangleMesh& mesh, const SizeField& size, const Projection& onto_surface)
      : mesh_(half_edge_mesh(mesh)), wanted_(size), onto_surface_(onto_surface) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_halfedge_status();
    mesh_.request_face_status();
    mesh_.add_property(size_);
    for (const auto v : mesh_.vertices()) mesh_.property(size_, v) = wanted_(point(mesh_, v));
  }

  void split_long();
  void collapse_short();
  void even_valences();
  TriangleMesh result() {
    mesh_.garbage_collection();
    return triangle_mesh(mesh_);
  }

 private:
  static constexpr double longest = 4. / 3, shortest = 4. / 5;  // of the wanted length

  double relative_length(OpenMesh::VertexHandle a, OpenMesh::VertexHandle b) const {
    return (point(mesh_, a) - point(mesh_, b)).norm() * 2
         / (mesh_.property(size_, a) + mesh_.property(size_, b));
  }
  bool may_collapse(OpenMesh::SmartHalfedgeHandle h);
  bool turns_over(OpenMesh::SmartVertexHandle vertex, OpenMesh::SmartVertexHandle to) const;

  HalfEdgeMesh mesh_;
  OpenMesh::VPropHandleT<double> size_;
  SizeField wanted_;
  Projection onto_surface_;
};

void Grading::split_long() {
  const std::size_t before = mesh_.n_edges();  // new ones wait for the next round
  for (std::size_t k = 0; k < before; ++k) {
    const auto edge = OpenMesh::make_smart(mesh_.edge_handle(unsigned(k)), mesh_);
    if (relative_length(edge.v0(), edge.v1()) <= longest) continue;
    const Vector3d x = onto_surface_((point(mesh_, edge.v0()) + point(mesh_, edge.v1())) / 2);
    const auto middle = mesh_.add_vertex({x[0], x[1], x[2]});
    mesh_.property(size_, middle) = wanted_(x);
    mesh_.split(edge, middle);
  }
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

bool Grading::may_collapse(OpenMesh::SmartHalfedgeHandle h) {
  if (!mesh_.is_collapse_ok(h)) return false;
  // Both points opposite to the edge lose a triangle.
  if (h.next().to().valence() < 5 || h.opp().next().to().valence() < 5) return false;
  for (const auto neighbour : mesh_.vv_range(h.from()))
    if (neighbour != h.to() && relative_length(neighbour, h.to()) > longest) return false;
  return !turns_over(h.from(), h.to());
}

void Grading::collapse_short() {
  for (const auto edge : mesh_.edges()) {
    if (edge.deleted() || relative_length(edge.v0(), edge.v1()) >= shortest) continue;
    for (const auto h : {edge.h0(), edge.h1()})
      if (may_collapse(h)) {
        mesh_.collapse(h);
        break;
      }
  }
  mesh_.garbage_collection();
}

void Grading::even_valences() {
  const auto excess = [](OpenMesh::SmartVertexHandle v, int change) {
    return std::abs(int(v.valence()) + change - 6);
  };
  for (const auto edge : mesh_.edges()) {
    const auto h = edge.h0();
    const auto a = h.from(), b = h.to(), c = h.next().to(), d = h.opp().next().to();
    const int before = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0);
    const int after = excess(a, -1) + excess(b, -1) + excess(c, 1) + excess(d, 1);
    if (after >= before || !mesh_.is_flip_ok(edge)) continue;
    const Vector3d xa = point(mesh_, a), xb = point(mesh_, b), xc = point(mesh_, c),
                   xd = point(mesh_, d);
    const Vector3d outward = (xb - xa).cross(xc - xa) + (xd - xa).cross(xb - xa);
    if ((xd - xc).cross(xb - xc).dot(outward) > 0 && (xa - xc).cross(xd - xc).dot(outward) > 0)
      mesh_.flip(edge);
  }
}

}  // namespace

TriangleMesh graded(const TriangleMesh& mesh, const SizeField& size,
                    const Projection& onto_surface) {
  constexpr int rounds = 10, sweeps = 5, last_sweeps = 40;
  const Smoothing aim{.size = size, .evenness = 0.25};
  TriangleMesh result = mesh;
  for (int round = 0; round < rounds; ++round) {
    Grading grading(result, size, onto_surface);
    grading.split_long();
    grading.collapse_short();
    grading.even_valences();
    result = grading.result();
    smooth(result, onto_surface, aim, round + 1 < rounds ? sweeps : last_sweeps);
  }
  return result;
}

}  // namespace sbeh::meshing
