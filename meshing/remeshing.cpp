#include "meshing/remeshing.h"

#include "meshing/half_edge_mesh.h"
#include "meshing/measures.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

// Adaptor and result are in single precision: good for the connectivity, the points are projected.
TriangleMesh with_edges_of(double length, const TriangleMesh& mesh,
                           const Projection& onto_surface) {
  HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  half_edges.request_vertex_status();
  half_edges.request_edge_status();
  half_edges.request_halfedge_status();
  half_edges.request_face_status();
  const auto onto = [&](OpenMesh::VertexHandle vertex) {
    const Eigen::Vector3d x = onto_surface(point(half_edges, vertex));
    return CGAL::Epick::Point_3(x[0], x[1], x[2]);
  };
  CGAL::Polygon_mesh_processing::isotropic_remeshing(
      faces(half_edges), length, half_edges,
      CGAL::parameters::number_of_iterations(10).number_of_relaxation_steps(3).projection_functor(
          onto));
  half_edges.garbage_collection();
  TriangleMesh result = triangle_mesh(half_edges);
  project(result, onto_surface);
  return result;
}

}  // namespace

TriangleMesh remeshed(const TriangleMesh& mesh, int triangles, const Projection& onto_surface,
                      double grading) {
  constexpr int sweeps = 40;
  double length = std::sqrt(4 / std::sqrt(3.) * area(mesh) / triangles);
  TriangleMesh result = with_edges_of(length, mesh, onto_surface);
  // Where the surface is thinner than they are it collapses.
  if (result.triangle_count() < triangles / 2)
    throw std::invalid_argument(
        fmt::format("{} even triangles are too large to go round the thinnest parts of the "
                    "surface: take more",
                    triangles));
  length *= std::sqrt(double(result.triangle_count()) / triangles);
  result = with_edges_of(length, result, onto_surface);
  smooth(result, onto_surface, {.grading = grading}, sweeps);
  return result;
}

}  // namespace sbeh::meshing
