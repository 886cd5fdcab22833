#include "meshing/implicit_mesher.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

namespace sbeh::meshing {

TriangleMesh triangulate(const ImplicitShape& shape, double size) {
  using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
  using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
  using Kernel = Triangulation::Geom_traits;
  using Function = std::function<double(const Kernel::Point_3&)>;
  const Function f = [&](const Kernel::Point_3& x) {
    return shape.f(shape.centre + Eigen::Vector3d(x[0], x[1], x[2]));
  };
  constexpr double precision = 1e-4;     // of the intersections, relative: they are projected later
  constexpr double smallest_angle = 30;  // degrees; the mesher's own limit for termination
  const Kernel::Sphere_3 bounds(CGAL::ORIGIN, shape.radius * shape.radius);
  const CGAL::Implicit_surface_3<Kernel, Function> surface(f, bounds, precision);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(smallest_angle, size,
                                                                      size / 4);
  Triangulation triangulation;
  Complex complex(triangulation);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());
  CGAL::Surface_mesh<Kernel::Point_3> found;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, found);

  TriangleMesh mesh{Eigen::Matrix3Xd(3, found.number_of_vertices()),
                    Eigen::Matrix3Xi(3, found.number_of_faces())};
  for (const auto v : found.vertices()) {
    const Kernel::Point_3& x = found.point(v);
    mesh.points.col(Eigen::Index(v)) = shape.centre + Eigen::Vector3d(x[0], x[1], x[2]);
  }
  for (const auto t : found.faces()) {
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(found.halfedge(t), found))
      mesh.triangles(k++, Eigen::Index(t)) = int(v);
  }
  return mesh;
}

}  // namespace sbeh::meshing
