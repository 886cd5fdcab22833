#include "meshing/repair.h"

#include "meshing/measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Epick::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

Soup soup_of(const TriangleMesh& mesh) {
  Soup soup;
  for (const auto x : mesh.points.colwise()) soup.points.emplace_back(x[0], x[1], x[2]);
  for (const auto c : mesh.triangles.colwise()) {
    if (c.minCoeff() < 0 || c.maxCoeff() >= mesh.point_count() || !mesh.points.allFinite())
      throw std::invalid_argument("repair: the mesh has numbers that cannot be guessed");
    soup.triangles.push_back({std::size_t(c[0]), std::size_t(c[1]), std::size_t(c[2])});
  }
  return soup;
}

class Log {
 public:
  void add(const char* what, std::size_t count) {
    if (count > 0) done.push_back(fmt::format("{}: {}", what, count));
  }
  std::vector<std::string> done;
};

void clean_soup(Soup& s, Log& log) {
  log.add("points merged with others of the same coordinates",
          pmp::merge_duplicate_points_in_polygon_soup(s.points, s.triangles));
  const auto is_triangle = [](const auto& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  };
  const auto first_bad = std::stable_partition(s.triangles.begin(), s.triangles.end(), is_triangle);
  log.add("triangles with a repeated corner removed", std::size_t(s.triangles.end() - first_bad));
  s.triangles.erase(first_bad, s.triangles.end());
  log.add("repeated triangles removed",
          pmp::merge_duplicate_polygons_in_polygon_soup(
              s.points, s.triangles, CGAL::parameters::require_same_orientation(false)));
  log.add("unused points removed",
          pmp::remove_isolated_points_in_polygon_soup(s.points, s.triangles));
}

std::size_t count_inconsistent(const Soup& before, const Soup& after) {
  std::size_t turned = 0;
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    // A turned triangle has its corners in the other cyclic order.
    auto a = before.triangles[t];
    const auto& b = after.triangles[t];
    for (int k = 0; k < 3 && a != b; ++k) std::rotate(a.begin(), a.begin() + 1, a.end());
    if (a != b) ++turned;
  }
  return turned;
}

void orient(Soup& s, Log& log) {
  const Soup before = s;
  pmp::orient_polygon_soup(s.points, s.triangles);
  log.add("points doubled where surfaces touched", s.points.size() - before.points.size());
  if (s.points.size() > before.points.size()) return;
  const std::size_t turned = count_inconsistent(before, s);
  log.add("triangles turned to the orientation of their neighbours",
          std::min(turned, s.triangles.size() - turned));
}

void close_holes(Mesh& mesh, Log& log) {
  constexpr std::size_t largest = 8;  // edges
  std::size_t closed = 0;
  std::vector<Mesh::Halfedge_index> cycles;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  for (const Mesh::Halfedge_index h : cycles) {
    if (CGAL::halfedges_around_face(h, mesh).size() > largest) continue;
    std::vector<Mesh::Face_index> patch;
    pmp::triangulate_hole(mesh, h, std::back_inserter(patch));
    if (!patch.empty()) ++closed;
  }
  log.add("holes closed", closed);
}

TriangleMesh triangles_of(const Mesh& mesh) {
  TriangleMesh result{Eigen::Matrix3Xd(3, mesh.number_of_vertices()),
                      Eigen::Matrix3Xi(3, mesh.number_of_faces())};
  for (const auto v : mesh.vertices()) {
    const Point& x = mesh.point(v);
    result.points.col(Eigen::Index(v)) << x[0], x[1], x[2];
  }
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      result.triangles(k++, Eigen::Index(f)) = int(v);
  }
  return result;
}

}  // namespace

Repair repaired(const TriangleMesh& mesh) {
  Soup soup = soup_of(mesh);
  Log log;
  clean_soup(soup, log);
  orient(soup, log);
  Mesh surface;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, surface);
  const std::size_t faces = surface.number_of_faces();
  pmp::remove_degenerate_faces(surface);
  log.add("triangles without area removed, neighbours adapted", faces - surface.number_of_faces());
  close_holes(surface, log);
  surface.collect_garbage();
  Repair repair{triangles_of(surface), {}};
  if (CGAL::is_closed(surface) && volume(repair.mesh) < 0) {
    repair.mesh.triangles.row(1).swap(repair.mesh.triangles.row(2));
    log.add("triangles turned outward", surface.number_of_faces());
  }
  repair.done = std::move(log.done);
  return repair;
}

}  // namespace sbeh::meshing
