#include "meshing/repair.h"

#include "meshing/face_soup.h"
#include "meshing/measures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace sbeh::meshing {

namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Point = CGAL::Epick::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Halfedge = Mesh::Halfedge_index;

std::vector<Point> cgal_points(const Eigen::Matrix3Xd& points) {
  std::vector<Point> result;
  for (const auto x : points.colwise()) result.emplace_back(x[0], x[1], x[2]);
  return result;
}

void require_numbers(const PolygonMesh& mesh) {
  const auto in_range = [&](const std::vector<int>& face) {
    return std::ranges::all_of(face, [&](int i) { return i >= 0 && i < mesh.point_count(); });
  };
  if (!mesh.points.allFinite() || !std::ranges::all_of(mesh.faces, in_range))
    throw std::invalid_argument("repair: the mesh has numbers that cannot be guessed");
}

// Whether two triangles of the same corners go round in the other sense.
bool is_turned(std::array<int, 3> a, const std::array<int, 3>& b) {
  for (int k = 0; k < 3 && a != b; ++k) std::rotate(a.begin(), a.begin() + 1, a.end());
  return a != b;
}

// Where surfaces touch in a point or an edge CGAL doubles the points there.
void orient(FaceSoup& soup, RepairLog& log) {
  std::vector<Point> points = cgal_points(soup.points);
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& t : soup.triangles) faces.emplace_back(t.corner.begin(), t.corner.end());
  pmp::orient_polygon_soup(points, faces);
  const auto before = std::size_t(soup.points.cols());
  log.add(points.size() - before, "points doubled where surfaces touch");
  soup.points.conservativeResize(3, Eigen::Index(points.size()));
  for (std::size_t i = before; i < points.size(); ++i) {
    soup.points.col(Eigen::Index(i)) << points[i][0], points[i][1], points[i][2];
    if (!soup.point_numbers.empty()) soup.point_numbers.push_back(-1);
  }
  std::size_t turned = 0;
  for (std::size_t t = 0; t < faces.size(); ++t) {
    auto& corner = soup.triangles[t].corner;
    const std::array<int, 3> now{int(faces[t][0]), int(faces[t][1]), int(faces[t][2])};
    if (points.size() == before && is_turned(corner, now)) ++turned;
    corner = now;
  }
  log.add(std::min(turned, faces.size() - turned),
          "triangles turned to the orientation of their neighbours");
}

// Faces keep their numbers: nothing is ever removed from it.
Mesh surface_of(const FaceSoup& soup) {
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& t : soup.triangles) faces.emplace_back(t.corner.begin(), t.corner.end());
  Mesh surface;
  pmp::polygon_soup_to_polygon_mesh(cgal_points(soup.points), faces, surface);
  return surface;
}

// Of a hole whose corners lie on one line CGAL makes no triangles: a fan, whose flat ones are turned later.
std::size_t fill_flat_hole(Mesh& mesh, Halfedge h) {
  CGAL::Euler::fill_hole(h, mesh);
  std::size_t triangles = 1;
  for (; mesh.next(mesh.next(mesh.next(h))) != h; ++triangles)
    h = CGAL::Euler::split_face(h, mesh.next(mesh.next(h)), mesh);
  return triangles;
}

void close_holes(Mesh& mesh, RepairLog& log) {
  constexpr std::size_t largest = 8;  // edges
  std::size_t closed = 0, added = 0;
  std::vector<Halfedge> cycles;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  for (const Halfedge h : cycles) {
    if (CGAL::halfedges_around_face(h, mesh).size() > largest) continue;
    std::vector<Mesh::Face_index> patch;
    pmp::triangulate_hole(mesh, h, std::back_inserter(patch));
    ++closed;
    added += patch.empty() ? fill_flat_hole(mesh, h) : patch.size();
  }
  log.add(closed, "holes closed", fmt::format("{} triangles added", added));
}

using Corners = std::array<Mesh::Vertex_index, 3>;

// Height over the longest edge, over that edge; and the corner opposite of it.
struct Flatness {
  double height = 0;
  int apex = 0;
};
Flatness flatness(const Mesh& mesh, const Corners& corner) {
  std::array<Eigen::Vector3d, 3> x;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& p = mesh.point(corner[k]);
    x[k] = {p[0], p[1], p[2]};
  }
  double longest = 0;
  Flatness result;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = (x[(k + 2) % 3] - x[(k + 1) % 3]).norm();
    if (length <= longest) continue;
    longest = length;
    result.apex = int(k);
  }
  if (longest > 0) result.height = (x[1] - x[0]).cross(x[2] - x[0]).norm() / (longest * longest);
  return result;
}

Corners corners_of(const Mesh& mesh, Halfedge h) {
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

// Whether the longest edge of a flat face was turned, which leaves no face as flat as it was.
bool turn_longest_edge(Mesh& mesh, Mesh::Face_index face) {
  Halfedge h = mesh.halfedge(face);
  const Flatness flat = flatness(mesh, corners_of(mesh, h));
  for (int k = 0; k <= flat.apex; ++k) h = mesh.next(h);  // from the corner after the apex
  const Halfedge other = mesh.opposite(h);
  if (mesh.is_border(other)) return false;
  const auto [from, to, apex] = corners_of(mesh, h);
  const Mesh::Vertex_index opposite = mesh.target(mesh.next(other));
  if (mesh.halfedge(apex, opposite) != Mesh::null_halfedge()) return false;
  const double before = std::min(flat.height, flatness(mesh, corners_of(mesh, other)).height),
               after = std::min(flatness(mesh, {from, opposite, apex}).height,
                                flatness(mesh, {opposite, to, apex}).height);
  if (!(after > before)) return false;
  CGAL::Euler::flip_edge(h, mesh);
  return true;
}

// Several that lie on one edge are turned one after the other, from the outermost on.
void turn_flat_faces(Mesh& mesh, RepairLog& log) {
  std::size_t turned = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto face : mesh.faces())
      if (flatness(mesh, corners_of(mesh, mesh.halfedge(face))).height < flat_height
          && turn_longest_edge(mesh, face)) {
        ++turned;
        changed = true;
      }
  }
  log.add(turned, "flat triangles made away with by turning their longest edge");
}

void take_from(FaceSoup& soup, const Mesh& mesh) {
  soup.triangles.resize(mesh.number_of_faces(), {{}, -1});
  for (const auto face : mesh.faces()) {
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      soup.triangles[std::size_t(face)].corner[std::size_t(k++)] = int(v);
  }
}

}  // namespace

Repair repaired(const PolygonMesh& mesh) {
  require_numbers(mesh);
  RepairLog log;
  FaceSoup soup = soup_of(mesh, log);
  clean(soup, log);
  remove_strays(soup, log);
  remove_specks(soup, log);
  remove_unused_points(soup, log);
  orient(soup, log);
  Mesh surface = surface_of(soup);
  close_holes(surface, log);
  turn_flat_faces(surface, log);
  take_from(soup, surface);
  Repair repair{triangle_mesh(soup), names_of(soup), {}};
  if (CGAL::is_closed(surface) && volume(repair.mesh) < 0) {
    repair.mesh.triangles.row(1).swap(repair.mesh.triangles.row(2));
    log.add(surface.number_of_faces(), "triangles turned outward");
  }
  repair.done = std::move(log.done);
  return repair;
}

}  // namespace sbeh::meshing
